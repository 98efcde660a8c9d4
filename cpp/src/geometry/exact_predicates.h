// Signs of orientation determinants, exact for any finite input.
// In:    points in double. Out: -1, 0, 1: the sign of the exact value.
// Cost:  a few nanoseconds where rounding cannot matter, microseconds where it does.
// Method: a bound on the rounding error first; where it does not decide, the determinant is summed
// up without error as an expansion (a sum of doubles that do not overlap; Shewchuk 1997).
// Limits: exact while no intermediate leaves the range of double (coordinates within 1e-60..1e60).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace swept {

/// Sign of det(b - a, c - a, d - a): positive if d lies on the side of the plane (a, b, c) to which
/// its counter-clockwise normal points.
int orientation3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d);

/// Sign of the turn a, b, c in the plane of the coordinates `u` and `v` (0, 1 or 2).
int orientation2d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  int u, int v);

/// True if the three points lie on one line, exactly.
bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace swept
