// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/summary.h"

#include <cmath>

#include "base/number_text.h"

namespace swept {
namespace clearance {
namespace {

/// Returns whether row a counts as nearer than row b. Allowed contacts come last, because their
/// distance of 0 is intended.
bool nearer(const NeighbourClearance& a, const NeighbourClearance& b) {
  const bool allowedA = a.rule.contact && a.meetsRule(), allowedB = b.rule.contact && b.meetsRule();
  if (allowedA != allowedB) return allowedB;
  if (a.distance - a.chordError != b.distance - b.chordError && (a.distance > 0 || b.distance > 0))
    return a.distance - a.chordError < b.distance - b.chordError;
  return a.penetration.depth > b.penetration.depth;
}

/// Returns a length in mm as text. Less than a nanometre is treated as rounding and becomes 0.
std::string lengthText(double length) {
  return numberText(std::abs(length) < 1e-6 ? 0 : length, 4);
}

}  // namespace

Summary summaryOf(const std::vector<const NeighbourClearance*>& rows, const std::string& head,
                  std::size_t ignored, Timed timed) {
  Summary summary{{}, head};
  int clashes = 0;
  int contacts = 0;
  int below = 0;
  int allowed = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    clashes += rows[i]->verdict == ClearanceVerdict::Clash;
    const bool contact = rows[i]->verdict == ClearanceVerdict::Contact;
    const bool isAllowed = contact && rows[i]->rule.contact.has_value();
    allowed += isAllowed;
    contacts += contact && !isAllowed;
    below += rows[i]->verdict == ClearanceVerdict::BelowRequired;
    if (!summary.smallest || nearer(*rows[i], *rows[*summary.smallest])) summary.smallest = i;
  }
  if (!summary.smallest) return summary;
  const NeighbourClearance& row = *rows[*summary.smallest];
  const auto add = [&](int count, const char* one, const char* many) {
    if (count > 0) summary.text += ", " + counted(count, one, many);
  };
  add(clashes, "clash", "clashes");
  add(contacts, "contact", "contacts");
  add(below, "below required", "below required");
  add(allowed, "allowed contact", "allowed contacts");
  add(static_cast<int>(ignored), "ignored", "ignored");
  const bool deep = row.verdict == ClearanceVerdict::Clash && row.penetration.known;
  const std::string length = lengthText(deep ? row.penetration.depth : row.distance);
  summary.text += (deep ? ", deepest clash " : ", smallest distance ") + length + " mm";
  const std::string certain = lengthText(row.guaranteed);
  const bool withTime = timed == Timed::Yes;
  if (!deep && certain != length) summary.text += " (guaranteed: " + certain + " mm)";
  if (withTime) summary.text += " at t = " + numberText(row.timeSeconds) + " s";
  if (!row.name.empty()) summary.text += " (" + row.name + ")";
  return summary;
}

}  // namespace clearance

const char* clearanceVerdictName(ClearanceVerdict verdict) {
  switch (verdict) {
    case ClearanceVerdict::Clear:
      return "clear";
    case ClearanceVerdict::BelowRequired:
      return "below";
    case ClearanceVerdict::Contact:
      return "contact";
    case ClearanceVerdict::Clash:
      return "clash";
  }
  return "?";
}

}  // namespace swept
