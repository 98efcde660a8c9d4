// Measures the clearance of whole mechanisms: of parts that move at the same time, each with its
// own motion.
// In:    parts (meshes in their own coordinates), a motion for each part, rules for pairs.
// Out:   for each pair that comes within `range`: the smallest distance, when and where it occurs,
//        the verdict, and the depth of a clash.
// Units: mm, s.
// Cost:  the cost of checkClearance() for each pair that comes within `range`. Bounding boxes over
//        time exclude all other pairs.
// Promise: at no time common to all motions, also between poses, is a pair closer than `distance -
//        tolerance`. A pair that is not listed never comes closer than `range` (docs/clearance.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "swept/clearance.h"

namespace swept {

/// A part and its motion: x_world = pose * x. The times of all motions belong to one time axis. A
/// part that stands still has exactly one pose, and the time of that pose is ignored. A part
/// without a pose is an error.
struct MechanismPart {
  std::string name;  ///< different for each part
  TriMesh mesh;
  Trajectory motion;      ///< Interpolation::None is allowed only with one pose
  double chordError = 0;  ///< mm, how far the triangles may deviate from the exact surface
};

/// The rule of one pair, in place of the common distance. The two parts are given by name, in any
/// order.
struct PairRule {
  std::string first;
  std::string second;
  NeighbourRule rule;
};

struct MechanismOptions {
  /// mm, distance that any two parts must keep; 0: only contact and clash matter.
  double required = 0;
  double tolerance = 0.01;  ///< mm, largest error of a smallest distance
  /// mm, above 0: pairs that come closer than this are measured. Not set: a tenth of the diagonal
  /// of the part of median size. The value is increased if the verdicts need more.
  std::optional<double> range;
  /// Accuracy of the ends of intervals, as mm of travel, above 0. Not set: 10 times the tolerance.
  std::optional<double> intervalTolerance;
  int curveSamples = 200;   ///< number of points of the graph of distance over time, 0 or more
  bool penetration = true;  ///< measure the depth and the place of a clash
  /// Rules of single pairs, such as allowed contact or no check for parts that a joint connects.
  std::vector<PairRule> rules;
};

/// Indices of two parts, in the order given; `first` is the smaller index.
struct PartPair {
  std::int32_t first = 0;
  std::int32_t second = 0;
  auto operator<=>(const PartPair&) const = default;
};

/// One pair that comes within the range. Points and boxes are in world coordinates at the time
/// given with them.
struct PairClearance {
  PartPair parts;
  double required = 0;  ///< mm, distance that this pair must keep; 0 if contact is allowed
  Pose poseOfFirst;     ///< at clearance.timeSeconds
  Pose poseOfSecond;
  /// "Body" is the first part and "neighbour" the second. `name` has both names; `pose` is
  /// poseOfFirst. Distances of the curve are capped at the range plus two tolerances.
  NeighbourClearance clearance;
};

struct MechanismReport : RunReport {
  std::vector<std::string> names;    ///< names of the parts
  TimeInterval time;                 ///< the time common to all motions, which was checked
  double range = 0;                  ///< mm, see MechanismOptions
  std::vector<PairClearance> pairs;  ///< sorted by the indices of their parts
  std::int64_t farPairs = 0;         ///< number of checked pairs that never come within the range
  std::vector<PartPair> ignored;     ///< pairs not checked, because a rule ignores them
  /// Pairs not checked, because their parts do not move relative to each other.
  std::vector<PartPair> joined;
  /// Index in `pairs` of the nearest pair (deepest clash first); not set if there is no pair.
  std::optional<std::size_t> smallest;
  /// For example "12 pairs checked, 1 clash, deepest clash 3.2 mm at t = 4.1 s (a, b)"
  std::string summary;
  double required = 0;
  double tolerance = 0;
  std::int64_t triangles = 0;
};

/// Never throws except std::bad_alloc; report.status describes a failure. The numbers do not depend
/// on the number of threads. Codes of bad input, besides those of meshes and motions: NoParts,
/// PartTwice, UnknownPart, BadRule, NothingMoves, NoCommonTime, NotInterpolated, EqualTimes.
MechanismReport checkMechanism(const std::vector<MechanismPart>& parts,
                               const MechanismOptions& options, RunContext& run);

/// Returns the report as JSON text (UTF-8). docs/clearance.md describes the keys.
std::string toJson(const MechanismReport& report);

/// Measures distances by a slow method, for comparison: with one FCL query at both ends of `time`,
/// at each pose of the two parts in between, and at `between` evenly spaced times in every gap.
/// Smaller distances between these times are missed. Throws Error.
StampedClearance stampedPair(const MechanismPart& first, const MechanismPart& second,
                             const TimeInterval& time, int between, RunContext& run);

}  // namespace swept
