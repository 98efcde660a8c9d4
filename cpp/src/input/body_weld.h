// Welding and cleaning of the generator, the first half of the body check.
// In:    triangles with valid indices and finite vertices. Out: the same surface, vertices shared.
// Units: mm. Cost: O(n).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "swept/types.h"

namespace swept {

/// First representative of each vertex among those with the same coordinates (-0.0 equals 0.0).
/// Representatives map to themselves and are the lowest index of their class.
std::vector<std::int32_t> exactWeld(const std::vector<Eigen::Vector3d>& vertices);

/// The same among the vertices marked in `candidates`, within `tolerance`. Greedy in index order:
/// a vertex joins the nearest earlier representative, so clusters do not chain.
std::vector<std::int32_t> toleranceWeld(const std::vector<Eigen::Vector3d>& vertices,
                                        const std::vector<std::uint8_t>& candidates,
                                        double tolerance);

/// Applies a vertex map to the triangles; returns how many vertices were mapped elsewhere.
std::int64_t applyMap(const std::vector<std::int32_t>& map, TriMesh& mesh);

struct CleanCounts {
  std::int64_t degenerate = 0;
  std::int64_t repeated = 0;  ///< removed because the same triangle was there already
  std::int64_t opposite = 0;  ///< removed because they met their own reverse
  std::vector<std::int64_t> firstDegenerate, firstDuplicate;  ///< at most 8 positions each
};

/// Removes triangles that repeat a vertex or have no area, duplicates (same orientation: one is
/// kept; opposite orientation: none, unless `keepSheets`) and then unused vertices (the order of
/// the others stays). Faces of triangles go with them. Returns the edges of what is left.
EdgeTable cleanTriangles(TriMesh& mesh, CleanCounts& counts, bool keepSheets = false);

}  // namespace swept
