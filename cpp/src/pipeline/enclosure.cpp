// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/enclosure.h"

#include <algorithm>
#include <sstream>

namespace swept {

SignRuns findSigns(const SamplerInput& input, const MarkedEdges& marks, const SolidPoint& isSolid,
                   const Prepared& prepared, bool keepCavities, Report& report, RunContext& run) {
  if (!keepCavities) return findOutside(marks, prepared.grid, run);
  const auto note = [&](const char* code, std::int64_t count, const std::string& text) {
    auto& notes = report.warnings;  // signs may be asked for again
    notes.erase(std::remove_if(notes.begin(), notes.end(),
                               [&](const Finding& f) { return f.code == code; }),
                notes.end());
    notes.push_back({code, count, {}, text});
  };
  if (!prepared.body.closed) {
    note("CavitiesFilled", 1,
         "the body is open, so inside has no meaning: sealed-off hollow spaces are filled; close "
         "its holes to keep them");
    return findOutside(marks, prepared.grid, run);
  }
  std::vector<std::uint32_t> component;
  SignRuns found = findOutside(marks, prepared.grid, run, &component);
  const std::int64_t opened = openCavities(found, component, marks, input, isSolid, run);
  note("CavitiesKept", opened,
       std::to_string(opened) + " sealed-off hollow spaces are kept as inner shells");
  return found;
}

void requireCrossings(const HermiteGrid& hermite) {
  if (!hermite.crossings.empty()) return;
  throw Error(Status::InvalidInput, "CellTooLarge",
              "no line of the grid meets the body: it is thinner than the cell everywhere; use a "
              "smaller cell");
}

void requireEnclosed(const HermiteGrid& hermite, const Prepared& prepared, Report& report) {
  requireCrossings(hermite);
  const auto crossings = static_cast<std::int64_t>(hermite.crossings.size());
  if (prepared.body.closed || hermite.sheetEdges == 0) return;
  const double share =
      2.0 * static_cast<double>(hermite.sheetEdges) / static_cast<double>(crossings);
  const bool still = !prepared.motion.continuous;
  std::ostringstream text;
  text.precision(3);
  text << "the body is open and " << 100 * share
       << " % of the surface has the outside on both sides";
  if (still && share > 0.01) {
    throw Error(Status::InvalidInput, "OpenMesh",
                text.str() + "; close its holes, or move it so that the sweep closes it");
  }
  report.warnings.push_back({"OpenSheets",
                             hermite.sheetEdges,
                             {},
                             text.str() + "; these sheets get a thickness of 0.002 cell"});
}

}  // namespace swept
