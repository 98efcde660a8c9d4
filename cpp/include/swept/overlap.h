// Comparison of parts that stand still, every two of them: envelopes, other reserved spaces, parts.
// In:    meshes in one world. Out: for every two of them the smallest distance, or how deep they
// lie
//        in each other and where, and the solid that they share.
// Units: mm, mm^3. Cost: a distance query a pair; the shared solid of two closed meshes of 70,000
//        triangles takes half a second.
// Promise: the distance is exact for the triangles. The shared solid is closed, and its volume that
//        of the meshes to within rounding (docs/overlap.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept {

struct OverlapPart {
  std::string name;  ///< of its own
  TriMesh mesh;
  double chordError = 0;  ///< mm, how far the triangles may lie off the exact surface
};

struct OverlapOptions {
  double required = 0;      ///< mm, distance asked for between any two; 0: only contact and clash
  double tolerance = 0.01;  ///< mm: nearer than this plus both chord errors is contact
  bool shared = true;       ///< make the shared solids
};

struct PairOverlap {
  PartPair parts;
  /// As of a motion with one pose, at time 0: "body" is the first part, "neighbour" the second.
  NeighbourClearance clearance;
  /// mm^3, of `shared`; absent where one of the two is open or crosses itself (see the warnings),
  /// or where no shared solids were asked for.
  std::optional<double> volume;
  TriMesh shared;  ///< turned outward; empty where they share nothing
};

struct OverlapReport {
  Status status = Status::Ok;
  std::string code;
  std::string message;
  std::vector<std::string> names;  ///< of the parts
  std::vector<PairOverlap> pairs;  ///< all, ascending by their parts
  int smallest = -1;               ///< in `pairs`: the nearest one, the deepest clash first
  std::string summary;  ///< "3 pairs checked, 1 clash, deepest 2 mm (a - b), 125 mm^3 shared"
  double required = 0;
  double tolerance = 0;
  std::int64_t triangles = 0;
  int threads = 0;
  std::vector<StageSeconds> seconds;  ///< "total" is the last entry
  std::vector<Finding> warnings;      ///< NoSharedVolume: of which pairs, and why
};

/// Never throws except std::bad_alloc; failures are in report.status. The same numbers and meshes
/// for any count of threads. Codes of bad input, besides those of meshes: NoParts, PartTwice.
OverlapReport checkOverlaps(const std::vector<OverlapPart>& parts, const OverlapOptions& options,
                            RunContext& run);

/// The report as JSON text (UTF-8) without the meshes; keys as in docs/overlap.md.
std::string toJson(const OverlapReport& report);

/// The solid that two solids share; empty where there is none.
struct SharedVolume {
  TriMesh mesh;
  double volume = 0;  ///< mm^3
};
/// Throws Error(InvalidInput): what checkOverlaps() says of meshes, OpenMesh, OverlappingShells;
/// Error(Cancelled).
SharedVolume sharedVolume(const OverlapPart& first, const OverlapPart& second, RunContext& run);

}  // namespace swept
