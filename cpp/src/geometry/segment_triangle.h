// Where a segment passes through a triangle.
// Units: any. Cost: O(1).
// Limits: rounding decides where the segment passes through an edge or a corner of the triangle.
// Source: T. Moller, B. Trumbore, Fast, minimum storage ray/triangle intersection (1997).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

namespace swept {

/// Returns the fraction of the segment, and the weights of the corners b and c. Returns nothing if
/// the segment does not pass through the triangle, or lies in its plane.
inline std::optional<Eigen::Vector3d> throughTriangle(const Eigen::Vector3d& from,
                                                      const Eigen::Vector3d& to,
                                                      const Eigen::Vector3d& a,
                                                      const Eigen::Vector3d& b,
                                                      const Eigen::Vector3d& c) {
  const Eigen::Vector3d along = to - from, ab = b - a, ac = c - a, p = along.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return std::nullopt;
  const Eigen::Vector3d off = from - a;
  const double u = off.dot(p) / determinant;
  if (u < 0 || u > 1) return std::nullopt;
  const Eigen::Vector3d q = off.cross(ab);
  const double v = along.dot(q) / determinant;
  if (v < 0 || u + v > 1) return std::nullopt;
  const double t = ac.dot(q) / determinant;
  if (t < 0 || t > 1) return std::nullopt;
  return Eigen::Vector3d(t, u, v);
}

}  // namespace swept
