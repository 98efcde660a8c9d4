// Compares all pairs of parts that stand still, such as envelopes, other reserved spaces and parts.
// In:    meshes in world coordinates.
// Out:   for each pair, the smallest distance, or the depth and place of the overlap and the shared
//        solid.
// Units: mm, mm^3.
// Cost:  one distance query for each pair. The shared solid of two closed meshes of 70,000
//        triangles takes half a second.
// Promise: the distance is exact for the triangles. The shared solid is closed, and its volume is
//        that of the intersection of the meshes to within rounding (docs/overlap.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept {

struct OverlapPart {
  std::string name;  ///< different for each part
  TriMesh mesh;
  double chordError = 0;  ///< mm, how far the triangles may deviate from the exact surface
};

struct OverlapOptions {
  /// mm, distance that any two parts must keep; 0: only contact and clash matter.
  double required = 0;
  double tolerance = 0.01;  ///< mm: a distance below this plus both chord errors is contact
  bool shared = true;       ///< compute the shared solids
};

struct PairOverlap {
  PartPair parts;
  /// As for a motion with one pose, at time 0: "body" is the first part, "neighbour" the second.
  NeighbourClearance clearance;
  /// Volume (mm^3) of `shared`. Not set if one of the two meshes is open or intersects itself (see
  /// the warnings), or if OverlapOptions::shared is false.
  std::optional<double> volume;
  TriMesh shared;  ///< oriented outwards; empty if the parts share no volume
};

/// The finding NoSharedVolume says for which pairs the volume is missing, and why.
struct OverlapReport : RunReport {
  std::vector<std::string> names;  ///< names of the parts
  std::vector<PairOverlap> pairs;  ///< all pairs, sorted by the indices of their parts
  /// Index in `pairs` of the nearest pair (deepest clash first); not set if the run failed.
  std::optional<std::size_t> smallest;
  /// For example "3 pairs checked, 1 clash, deepest clash 2 mm (a - b), 125 mm^3 shared"
  std::string summary;
  double required = 0;
  double tolerance = 0;
  std::int64_t triangles = 0;
};

/// Never throws except std::bad_alloc; report.status describes a failure. Numbers and meshes do not
/// depend on the number of threads. Codes of bad input, besides those of meshes: NoParts,
/// PartTwice.
OverlapReport checkOverlaps(const std::vector<OverlapPart>& parts, const OverlapOptions& options,
                            RunContext& run);

/// Returns the report without the meshes as JSON text (UTF-8). docs/overlap.md describes the keys.
std::string toJson(const OverlapReport& report);

/// The solid that two solids share; empty if they share none.
struct SharedVolume {
  TriMesh mesh;
  double volume = 0;  ///< mm^3
};
/// Throws Error(InvalidInput) with the codes of checkOverlaps() for meshes, OpenMesh or
/// OverlappingShells, and Error(Cancelled).
SharedVolume sharedVolume(const OverlapPart& first, const OverlapPart& second, RunContext& run);

}  // namespace swept
