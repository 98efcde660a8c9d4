// Welds and cleans the generator (the moving part). This is the first half of checkBody().
// In:    triangles with valid indices and finite vertices.
// Out:   the same surface with shared vertices.
// Units: mm. Cost: O(n) for n triangles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "swept/types.h"

namespace swept {

/// Maps each vertex to its representative: the first vertex with the same coordinates (-0.0 equals
/// 0.0). A representative maps to itself.
std::vector<std::int32_t> exactWeld(const std::vector<Eigen::Vector3d>& vertices);

/// Does the same within `tolerance` (mm), for the vertices marked in `candidates`. Vertices are
/// visited in the order of their indices. Each vertex joins the nearest representative before it.
/// So a long row of near vertices does not collapse into one vertex.
std::vector<std::int32_t> toleranceWeld(const std::vector<Eigen::Vector3d>& vertices,
                                        const std::vector<std::uint8_t>& candidates,
                                        double tolerance);

/// Applies a vertex map to the triangles. Returns the number of vertices that map to another one.
std::int64_t applyMap(const std::vector<std::int32_t>& map, TriMesh& mesh);

struct CleanCounts {
  std::int64_t degenerate = 0;
  std::int64_t repeated = 0;  ///< removed because the same triangle exists already
  std::int64_t opposite = 0;  ///< removed together with a triangle of opposite orientation
  std::vector<std::int64_t> firstDegenerate, firstDuplicate;  ///< indices, at most 8 each
};

/// Removes triangles that repeat a vertex or have no area. Of duplicates with the same orientation,
/// keeps one. Removes pairs of duplicates with opposite orientations, unless `keepSheets`. Then
/// removes unused vertices; the others keep their order. Remaining triangles keep their face
/// numbers. Returns the edges of the remaining triangles.
EdgeTable cleanTriangles(TriMesh& mesh, CleanCounts& counts, bool keepSheets = false);

}  // namespace swept
