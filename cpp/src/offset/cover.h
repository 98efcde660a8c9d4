// Triangles that cover the boundary of the swept volume: what an offset is measured from.
//
// In:    body, motion, grid; or a closed mesh. Out: triangles in cells from the grid's origin, each
//        with the slack within which the piece of boundary that it stands for lies.
// Cost:  O(elements kept by culling), about 110 bytes a triangle.
// Bounds (all of one motion step, turn a, displacement d(p)):
//   side patch   two flat triangles leave the ruled surface by at most |e1 - e0| / 4, e the edge
//                vector at either end of the step; it is cut along the edge until this is small;
//   face         where a face moves partly outward, partly inward in a step, the boundary may bulge
//                between its two copies: at a grazing point n(s) . d = 0, so it lies within
//                a |d| / 4 of the plane of the nearer copy. Both copies are then kept and have this
//                slack.
//   chord        the true motion leaves the chords by at most `chord`, for all elements alike.
// Everything else that is left out lies inside the swept volume (swept_elements.h).
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
  float slack = 0;  ///< cells
};

struct Cover {
  std::vector<CoverTriangle> triangles;
  double largestSlack = 0;  ///< cells
  double chord = 0;         ///< cells, bound on how far the true motion leaves the chords
  std::vector<Eigen::Vector3d> inside;  ///< cells; a surface point of every connected piece
};

/// Number of triangles that coverOfMotion would at most make for a union of copies; continuous
/// motions: 0, culling decides.
std::size_t copiesOf(const SamplerInput& input);

/// widened: the triangles keep their slack, for a surface that shall hold everything; else they are
/// taken as they are, for one that shall lie as near as possible.
Cover coverOfMotion(const SamplerInput& input, bool widened, RunContext& run);

/// A mesh that is known to be the boundary, such as an envelope made before. contactTime may be
/// empty.
Cover coverOfMesh(const TriMesh& mesh, const std::vector<double>& contactTime,
                  const GridPlan& grid);

}  // namespace swept::offset
