// Decides whether two triangles of one mesh intersect, that is, share more than their common
// corners and edges.
//
// In: triangles by their corners, none of them degenerate. Out: yes or no, exactly.
// Cost: well under a microsecond unless the triangles nearly touch.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept {

using Corners = std::array<const Eigen::Vector3d*, 3>;

/// For triangles without a common corner: returns true if they share a point; touching counts.
bool trianglesMeet(const Corners& p, const Corners& q);

/// For triangles (v, a, b) and (v, c, d): returns true if they share more than v.
bool meetBeyondVertex(const Eigen::Vector3d& v, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const Eigen::Vector3d& c, const Eigen::Vector3d& d);

/// For triangles over the edge (u, v) with third corners p and q: returns true if they overlap.
bool meetBeyondEdge(const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& p,
                    const Eigen::Vector3d& q);

/// Finds the common corners of two triangles and calls the matching function above. Two triangles
/// with the same three corners intersect.
bool trianglesIntersect(const std::vector<Eigen::Vector3d>& vertices,
                        const std::array<std::int32_t, 3>& p, const std::array<std::int32_t, 3>& q);
inline bool trianglesIntersect(const TriMesh& mesh, std::int64_t first, std::int64_t second) {
  return trianglesIntersect(mesh.vertices, mesh.triangles[first], mesh.triangles[second]);
}

/// Does the same as trianglesIntersect(), but makes cheap tests first. Returns false if a triangle
/// has no area.
bool trianglesIntersectFast(const std::vector<Eigen::Vector3d>& vertices,
                            const std::array<std::int32_t, 3>& p,
                            const std::array<std::int32_t, 3>& q);
inline bool trianglesIntersectFast(const TriMesh& mesh, std::int32_t first, std::int32_t second) {
  return trianglesIntersectFast(mesh.vertices, mesh.triangles[first], mesh.triangles[second]);
}

}  // namespace swept
