// Computes the distance between a point and a triangle, and between two triangles.
//
// In: corners, in any unit. Out: the nearest points. Cost: constant.
// Promise: degenerate triangles are allowed; their edges still count. A needle is a triangle whose
// corners lie nearly on a line. The distance of a point is exact up to rounding; for needles, the
// error is at most 1e-8 of their length. For two triangles with nearly parallel edges (common on
// machine parts), the error is at most about 1e-8 of their length.
// Source: C. Ericson, Real-Time Collision Detection (2005), 5.1.5 and 5.1.9.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "swept/types.h"

namespace swept {

using Triangle3d = std::array<Eigen::Vector3d, 3>;

/// The point of a triangle that is nearest to p.
struct Foot {
  Eigen::Vector3d point;
  Eigen::Vector3d offset;  ///< from `point` to p
};

namespace detail {
/// Finds the foot from the plane and the edges. Slower than footOnTriangle(), but also accurate for
/// needles.
Foot footOnNeedle(const Eigen::Vector3d& p, const Triangle3d& triangle);
/// Returns part / whole, or 0 if `part` is not positive (then an edge may have length 0).
inline double fractionOf(double part, double whole) { return part > 0 ? part / whole : 0; }
}  // namespace detail

/// Finds the foot by the signs of the barycentric coordinates of p in the plane of the triangle.
inline Foot footOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  // A triangle is a needle if its squared area is below this fraction of that of a right-angled
  // triangle with equally long edges ab and ac. Its barycentric coordinates are then mostly
  // rounding: their error is about 1e-16 times the fourth power of the edge length.
  constexpr double kNeedle = 1e-8;
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {a, ap};
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {b, bp};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double s = detail::fractionOf(d1, d1 - d3);
    return {a + ab * s, ap - ab * s};
  }
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {c, cp};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double s = detail::fractionOf(d2, d2 - d6);
    return {a + ac * s, ap - ac * s};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double s = detail::fractionOf(d4 - d3, (d4 - d3) + (d5 - d6));
    return {b + (c - b) * s, bp - (c - b) * s};
  }
  const double sum = va + vb + vc;
  if (!(sum > kNeedle * ab.squaredNorm() * ac.squaredNorm())) {
    return detail::footOnNeedle(p, {a, b, c});
  }
  const double s = vb * (1 / sum), t = vc * (1 / sum);
  return {a + ab * s + ac * t, ap - ab * s - ac * t};
}

inline Foot footOnTriangle(const Eigen::Vector3d& p, const Triangle3d& triangle) {
  return footOnTriangle(p, triangle[0], triangle[1], triangle[2]);
}

inline double squaredDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return footOnTriangle(p, a, b, c).offset.squaredNorm();
}

/// Finds the foot on a triangle of a mesh.
inline Foot footOnTriangle(const Eigen::Vector3d& p, const TriMesh& mesh, std::int32_t triangle) {
  const auto& c = mesh.triangles[triangle];
  return footOnTriangle(p, mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]);
}
inline double squaredDistance(const Eigen::Vector3d& p, const TriMesh& mesh,
                              std::int32_t triangle) {
  return footOnTriangle(p, mesh, triangle).offset.squaredNorm();
}

/// Nearest points of two triangles; `squared` is their squared distance, 0 if the triangles
/// intersect.
struct NearestPoints {
  double squared = 0;
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

NearestPoints nearestPoints(const Triangle3d& a, const Triangle3d& b);

}  // namespace swept
