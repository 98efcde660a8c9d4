// Clearance of whole mechanisms: parts that move at the same time, each with a motion of its own.
// In:    parts (meshes in coordinates of their own), a motion for each, what is asked of the pairs.
// Out:   for each pair that comes near: smallest distance, when, where; verdict; how deep a clash
// goes. Units: mm, s. Cost: a search (clearance.h) for each pair that comes within `range`; pairs
// that stay farther apart are told from their boxes over time. Promise: as checkClearance: no
// moment of the common time, between two poses or at one, is nearer than `distance - tolerance`,
// and no pair that is not listed comes nearer than `range` (docs/clearance.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/clearance.h"

namespace swept {

/// A part and its motion: x_world = pose * x. Times are those of the whole mechanism. A part that
/// stands still has one pose, whose time does not matter; no pose at all is an error.
struct MechanismPart {
  std::string name;  ///< of its own
  TriMesh mesh;
  Trajectory motion;      ///< Interpolation::None only with one pose
  double chordError = 0;  ///< mm, how far the triangles may lie off the exact surface
};

/// What one pair asks for in place of the common distance; its parts by name, in any order.
struct PairRule {
  std::string first;
  std::string second;
  NeighbourRule rule;
};

struct MechanismOptions {
  double required = 0;      ///< mm, distance asked for between any two; 0: only contact and clash
  double tolerance = 0.01;  ///< mm, how far a smallest distance may be off
  /// mm, pairs that come nearer than this are measured. 0: a tenth of the diagonal of the middle
  /// one of the parts by size. At least what the verdicts need is taken.
  double range = 0;
  double intervalTolerance = 0;  ///< mm of travel to which ends of intervals are found; 0: 10
                                 ///< tolerances
  int curveSamples = 200;        ///< points of the graph of distance over time; 0: none
  bool penetration = true;       ///< measure how deep a clash goes and where
  /// Parts that a joint holds together may touch, or are not looked at (contact, ignored).
  std::vector<PairRule> rules;
};

/// Numbers of two parts, in the order given; the first is the smaller one.
struct PartPair {
  std::int32_t first = 0;
  std::int32_t second = 0;
  auto operator<=>(const PartPair&) const = default;
};

/// One pair that comes within the range. Points and boxes: world, at the time named.
struct PairClearance {
  PartPair parts;
  double required = 0;  ///< mm, asked of this pair; 0 where contact is allowed
  Pose poseOfFirst;     ///< at clearance.timeSeconds
  Pose poseOfSecond;
  /// "Body" is the first part, "neighbour" the second; `name` has both; `pose` is poseOfFirst. In
  /// the curve no distance is above the range by more than two tolerances.
  NeighbourClearance clearance;
};

struct MechanismReport {
  Status status = Status::Ok;
  std::string code;
  std::string message;
  std::vector<std::string> names;    ///< of the parts
  TimeInterval time;                 ///< common to all motions: what was looked at
  double range = 0;                  ///< mm, see MechanismOptions
  std::vector<PairClearance> pairs;  ///< ascending by their parts
  std::int64_t farPairs = 0;         ///< looked at, never within the range
  std::vector<PartPair> ignored;     ///< not looked at: asked for
  std::vector<PartPair> joined;      ///< not looked at: the parts keep their place to each other
  int smallest = -1;    ///< in `pairs`: the nearest one (deepest clash first); -1: none
  std::string summary;  ///< "12 pairs looked at, 1 clash, deepest 3.2 mm at t = 4.1 s (a, b)"
  double required = 0;
  double tolerance = 0;
  std::int64_t triangles = 0;
  int threads = 0;
  std::vector<StageSeconds> seconds;  ///< "total" is the last entry
  std::vector<Finding> warnings;
};

/// Never throws except std::bad_alloc; failures are in report.status. The same numbers for any
/// count of threads. Codes of bad input, besides those of meshes and motions: NoParts, PartTwice,
/// UnknownPart, BadRule, NothingMoves, NoCommonTime, NotInterpolated, EqualTimes.
MechanismReport checkMechanism(const std::vector<MechanismPart>& parts,
                               const MechanismOptions& options, RunContext& run);

/// The report as JSON text (UTF-8); keys as in docs/clearance.md.
std::string toJson(const MechanismReport& report);

/// The slow way, for comparison: one query by FCL at both ends of `time`, at every moment between
/// them at which one of the two has a pose, and at `between` more evenly between two of these. Sees
/// nothing between those. Throws Error.
StampedClearance stampedPair(const MechanismPart& first, const MechanismPart& second,
                             const TimeInterval& time, int between, RunContext& run);

}  // namespace swept
