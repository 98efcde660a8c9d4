// Makes the cover: triangles that cover the boundary of the swept volume. Offsets are measured from
// these triangles.
//
// In:    body, motion and grid; or a closed mesh.
// Out:   triangles in cells from the origin of the grid. Each represents a piece of the boundary
//        and has a slack: no point of the piece is farther than this from the triangle.
// Cost:  O(elements that culling keeps), about 110 bytes per triangle.
// Bounds of the slack (for one motion step with turn a and displacement d(p) of a point p):
//   side patch   two flat triangles deviate from the ruled surface by at most |e1 - e0| / 4, where
//                e0 and e1 are the edge vectors at both ends of the step. The patch is cut along
//                the edge until this deviation is small.
//   face         if one part of a face moves outward in a step and another part inward, the
//                boundary may bulge between the two copies of the face. At a grazing point
//                n(s) . d = 0, so this point lies within a |d| / 4 of the plane of the nearer
//                copy. The cover then keeps both copies, with this slack.
//   chord        the true motion deviates from the chords by at most `chord`, which holds for all
//                elements. It is not part of the slack.
// All elements that culling drops lie inside the swept volume (swept_elements.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sampling/sampler.h"

namespace swept::offset {

struct CoverTriangle {
  std::array<Eigen::Vector3d, 3> corner;  ///< cells from the grid's origin
  std::array<float, 3> timeSeconds{0, 0, 0};
  float slack = 0;  ///< cells, see above
};

struct Cover {
  std::vector<CoverTriangle> triangles;
  double largestSlack = 0;  ///< cells
  double chord = 0;         ///< cells, bound on the deviation of the true motion from the chords
  /// In grid coordinates: one vertex of each connected piece of the body, at the first placement.
  /// For a union of copies, at every placement.
  std::vector<Eigen::Vector3d> inside;
};

/// Returns the number of triangles of the cover for a union of copies, before long triangles are
/// cut. Returns 0 for continuous motions, for which this number depends on culling.
std::size_t triangleCopies(const SamplerInput& input);

/// Makes the cover of a motion. With `widened`, the triangles keep their slack, for a surface that
/// must contain the whole swept volume. Without `widened`, all slacks are 0, for a surface that
/// should be as close as possible.
Cover coverOfMotion(const SamplerInput& input, bool widened, RunContext& run);

/// Makes the cover from a mesh that is known to be the boundary, such as an envelope computed
/// before. `contactTime`: one entry per vertex, or empty.
Cover coverOfMesh(const TriMesh& mesh, const std::vector<double>& contactTime,
                  const GridPlan& grid);

}  // namespace swept::offset
