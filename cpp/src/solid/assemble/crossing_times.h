// Finds where a surface that an edge sweeps passes through itself. The kernel needs faces that do
// not, so such a surface is cut at a time between the two passes.
// Units:   times are fractions of the motion step.
// Cost:    some thousand evaluations of the surface, and the pairs of its triangles.
// Method:  triangles on a grid of parameters; a cut lies between the times of two triangles that
//          intersect. One cut is found for as many pairs as possible: those whose times overlap.
// Limits:  passes that are less than two rows of the grid apart.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "solid/carrier/bspline.h"

namespace swept::step {

/// Returns times in order. `at`: a point of the surface at a parameter of the edge and a time.
/// `cuts`: times at which the surface is cut already.
std::vector<double> crossingTimes(const std::function<Eigen::Vector3d(double, double)>& at,
                                  Range edge, const std::vector<double>& cuts);

}  // namespace swept::step
