// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/task_check.h"

#include <cmath>
#include <numbers>

#include "base/limits.h"
#include "base/number_text.h"

namespace swept::path {
namespace {

[[noreturn]] void badOption(const std::string& text) {
  throw Error(Status::InvalidInput, "BadOption", text);
}

void requireLength(const char* name, double value, bool mayBeZero) {
  if (std::isfinite(value) && value >= 0 && value <= kMaxLength && (mayBeZero || value > 0)) return;
  badOption(std::string(name) + " is " + numberText(value, kTellingDigits) +
            " mm; allowed: " + (mayBeZero ? "0" : "more than 0") + " up to 1e9 mm");
}

}  // namespace

void checkPathOptions(const PathTask& task, const std::vector<ClearanceNeighbour>& neighbours,
                      const PathOptions& o) {
  requireLength("required distance (clearance)", o.clearance, true);
  requireLength("accuracy (tolerance)", o.tolerance, false);
  requireLength("mesh deflection (chord error) of the part", o.bodyChordError, true);
  requireLength("release distance", o.release, true);
  if (!(o.budgetSeconds > 0) || !std::isfinite(o.budgetSeconds))
    badOption("time limit (budget) is " + numberText(o.budgetSeconds, kTellingDigits) +
              " s; allowed: more than 0");
  if (o.mostSteps && *o.mostSteps < 1)
    badOption("the limit of moves is " + std::to_string(*o.mostSteps) +
              "; allowed: 1 or more, or not given (no limit)");
  if (o.interpolation == Interpolation::None)
    badOption("interpolation is 'none'; a path needs linear or screw");
  if (o.largestTurn && !(*o.largestTurn >= 0 && *o.largestTurn <= std::numbers::pi + 1e-9))
    badOption("the largest angle by which the part may turn is " +
              numberText(*o.largestTurn * 180 / std::numbers::pi, 6) +
              " degrees; allowed: 0 to 180");
  if (neighbours.empty())
    throw Error(Status::InvalidInput, "NoNeighbours", "no neighbour is given; choose at least one");
  for (const ClearanceNeighbour& n : neighbours) {
    requireLength("mesh deflection (chord error) of a neighbour", n.chordError, true);
    if (n.rule.contact)
      throw Error(
          Status::InvalidInput, "BadRule",
          "the rule of neighbour '" + n.name +
              "' allows contact, but a search must keep its distance from all neighbours; set a "
              "release distance, which allows contact near the start and the goal, or ignore this "
              "neighbour");
  }
  if (!task.start && !task.extraction)
    throw Error(Status::InvalidInput, "NoStart",
                "no start is given; give a start placement, or a distance or direction in which to "
                "take the part out");
  if (task.start && task.extraction)
    badOption(
        "a start and an extraction (a distance to which, or a direction in which, to take the part "
        "out) are both given; give only one of them");
  if (task.extraction) {
    if (task.extraction->direction &&
        !(task.extraction->direction->norm() > 0 && task.extraction->direction->allFinite()))
      badOption(
          "the direction in which to take the part out must have three finite numbers that are not "
          "all 0");
    if (!task.extraction->direction)
      requireLength("radius of the extraction", task.extraction->radius, false);
  }
}

std::string keyName(std::size_t index) { return "key " + std::to_string(index + 1); }

Pose checkedPose(const Pose& pose, const std::string& what) {
  const double norm = pose.rotation.norm();
  if (!pose.translation.allFinite() || !std::isfinite(norm))
    throw Error(Status::InvalidInput, "BadPose",
                what + " contains a number that is not finite; give finite numbers only");
  if (std::abs(norm - 1) > 1e-4)
    throw Error(Status::InvalidInput, "BadPose",
                what + " has a quaternion of length " + numberText(norm, 6) +
                    " instead of 1 (allowed error: 0.0001); give a unit quaternion");
  if (const double far = pose.translation.cwiseAbs().maxCoeff(); far > kMaxLength)
    throw Error(Status::InvalidInput, "OutOfRange",
                what + " lies " + numberText(far, kTellingDigits) +
                    " mm from the origin, but the limit is 1e9 mm; check the unit of length");
  Pose checked = pose;
  checked.rotation.normalize();
  return checked;
}

}  // namespace swept::path
