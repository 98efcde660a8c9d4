// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/mechanism_input.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/number_text.h"
#include "base/parallel.h"
#include "clearance/pair_check.h"
#include "input/trajectory_check.h"
#include "motion/pivot.h"

namespace swept::clearance {
namespace {

std::string quoted(const MechanismPart& part) { return "part '" + part.name + "'"; }

[[noreturn]] void refuse(const std::string& code, const std::string& text) {
  throw Error(Status::InvalidInput, code, text);
}

void requireNames(const std::vector<MechanismPart>& parts) {
  if (parts.size() < 2)
    refuse("NoParts", counted(std::ssize(parts), "part was", "parts were") +
                          " given; give at least two parts");
  std::set<std::string> names;
  for (const MechanismPart& part : parts)
    if (!names.insert(part.name).second)
      refuse("PartTwice", quoted(part) + " is given twice; give each part once, with one motion");
}

void requireTimes(const MechanismPart& part, const Trajectory& motion) {
  if (motion.poses.size() < 2) return;
  if (motion.interpolation == Interpolation::None)
    refuse("NotInterpolated", "the motion of " + quoted(part) +
                                  " has interpolation none, so the part does not move between its "
                                  "poses; choose linear or screw");
  for (std::size_t i = 1; i < motion.poses.size(); ++i) {
    if (motion.poses[i].timeSeconds > motion.poses[i - 1].timeSeconds) continue;
    refuse("EqualTimes", "the motion of " + quoted(part) + " has two poses at t = " +
                             numberText(motion.poses[i].timeSeconds, kTellingDigits) +
                             " s; give each pose its own time");
  }
}

}  // namespace

Trajectory timedPoses(const MechanismPart& part, std::vector<Finding>& findings) {
  try {
    CheckedTrajectory checked = checkTrajectory(part.motion, RepeatedPoses::Keep);
    requireTimes(part, checked.trajectory);
    for (Finding& finding : checked.findings) {
      finding.text = quoted(part) + ": " + finding.text;
      findings.push_back(std::move(finding));
    }
    return carriedByPivot(std::move(checked.trajectory), pivotOf(part.motion));
  } catch (const Error& error) {
    if (error.code() == "NotInterpolated" || error.code() == "EqualTimes") throw;
    throw Error(error.status(), error.code(), quoted(part) + ": " + error.what());
  }
}

std::vector<PreparedPart> prepareParts(const std::vector<MechanismPart>& parts, RunContext& run) {
  requireNames(parts);
  std::vector<std::optional<PreparedPart>> prepared(parts.size());
  // Motions are checked first. This is fast, so their errors are reported before the slow
  // preparation of the meshes.
  std::vector<Trajectory> motions;
  std::vector<std::vector<Finding>> findings(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    motions.push_back(timedPoses(parts[i], findings[i]));
  parallelFor(parts.size(), [&](std::size_t i) {
    run.checkpoint(Phase::Input);
    const Eigen::Vector3d pivot = pivotOf(parts[i].motion);
    bool mended = false;
    Part part = closedPart(seenFromPivot(parts[i].mesh, pivot), quoted(parts[i]), run, mended);
    const Box box = part.box(part.tree().root());
    prepared[i].emplace(PreparedPart{std::move(part), mended, pivot,
                                     TimedMotion(motions[i], box.centre, box.half),
                                     std::move(findings[i])});
  });
  std::vector<PreparedPart> result;
  for (auto& part : prepared) result.push_back(std::move(*part));
  return result;
}

TimeInterval commonTime(const std::vector<MechanismPart>& parts,
                        const std::vector<PreparedPart>& prepared, std::vector<Finding>& findings) {
  std::size_t latest = parts.size();
  std::size_t earliest = parts.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TimedMotion& motion = prepared[i].motion;
    if (!motion.moves()) continue;
    const TimeInterval span = motion.span();
    if (latest == parts.size() || span.from > prepared[latest].motion.span().from) latest = i;
    if (earliest == parts.size() || span.to < prepared[earliest].motion.span().to) earliest = i;
  }
  if (latest == parts.size())
    refuse("NothingMoves", "none of the " + std::to_string(parts.size()) +
                               " parts has a motion of more than one pose; add poses");
  const TimeInterval common{prepared[latest].motion.span().from,
                            prepared[earliest].motion.span().to};
  if (!(common.from < common.to))
    refuse("NoCommonTime", "the motion of " + quoted(parts[latest]) +
                               " begins at t = " + numberText(common.from, kTellingDigits) +
                               " s, that of " + quoted(parts[earliest]) +
                               " ends at t = " + numberText(common.to, kTellingDigits) +
                               " s; change their times so that they overlap");
  Finding cut{"TimesCut", 0, {}, ""};
  std::string names;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TimeInterval span = prepared[i].motion.span();
    if (!prepared[i].motion.moves() || (span.from >= common.from && span.to <= common.to)) continue;
    ++cut.count;
    if (cut.first.size() >= 8) continue;
    cut.first.push_back(static_cast<std::int64_t>(i));
    names += (names.empty() ? "" : ", ") + parts[i].name;
  }
  if (cut.count > 0) {
    cut.text = counted(cut.count, "motion extends", "motions extend") +
               " beyond the time that all motions share (" + names +
               (cut.count > 8 ? ", ..." : "") + "); only this time was checked, from " +
               numberText(common.from) + " to " + numberText(common.to) + " s";
    findings.push_back(cut);
  }
  return common;
}

}  // namespace swept::clearance
