// Finds where a choice of (face, placement) pairs left the envelope open, and the missing pairs.
//
// A choice can only err towards the outside: every sampled crossing is a true one, so what it calls
// inside is inside. Lattice points next to the surface are asked against all placements: the one
// that pushes the surface there farthest (support query) is tested exactly, body against point.
// Covered points that were called outside are followed through unmarked edges to where the
// covering body ends: an unmarked edge that its surface crosses is a hole, and the triangle there
// at that placement is what was missing.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "grid/marked_edges.h"
#include "sampling/dense/placement_space.h"
#include "sampling/sampler.h"
#include "signs/signs.h"

namespace swept::dense {

struct LeakSearch {
  std::int64_t asked = 0;     ///< surface points (ends of contributing edges) that were tested
  std::int64_t covered = 0;   ///< of these, covered by a placement although called outside
  double deepest = 0;         ///< mm: largest advance by which one of these was missed
  std::int64_t followed = 0;  ///< covered lattice points met on the way to the holes
  bool complete = true;       ///< false: stopped at a limit
  /// (face, placement), sorted, without repeats
  std::vector<std::pair<std::uint32_t, std::uint32_t>> missing;
};

/// Surface points that no placement covers, by layer, in the order in which they were asked.
/// Whether a point is covered does not depend on what has been sampled, so the next round need not
/// ask again.
struct ClearPoints {
  struct Point {
    std::uint64_t place;  ///< lattice point and the axis and side of the edge it was asked for
    std::uint32_t face, placement;
    bool operator==(const Point&) const = default;
  };
  std::vector<std::vector<Point>> layers;
};

/// margin: mm, by which a placement must reach beyond a point before it counts as missed; the same
/// for all calls that share `clear`.
LeakSearch findLeaks(const SamplerInput& input, const PlacementSpace& space,
                     const MarkedEdges& marked, const SignRuns& signs, double margin,
                     ClearPoints& clear, RunContext& run);

}  // namespace swept::dense
