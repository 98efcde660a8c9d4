// Signs of orientation determinants, exact for any finite input.
//
// In: points in double. Out: -1, 0, 1: the sign of the exact value.
// Cost: a few nanoseconds if rounding cannot change the sign, otherwise microseconds.
// Method: a bound on the rounding error decides most cases. Otherwise the determinant is summed
// without error as an expansion (a sum of doubles whose bits do not overlap; Shewchuk 1997).
// Limits: exact if no intermediate value leaves the range of double (coordinates within
// 1e-60..1e60).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace swept {

/// Returns the sign of det(b - a, c - a, d - a). It is positive if d lies on the side of the plane
/// (a, b, c) to which its counter-clockwise normal points.
int orientation3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d);

/// Returns the orientation of a, b, c, projected onto the coordinates `u` and `v` (0, 1 or 2). 1 is
/// counter-clockwise.
int orientation2d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  int u, int v);

/// Returns whether the three points lie exactly on one line.
bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace swept
