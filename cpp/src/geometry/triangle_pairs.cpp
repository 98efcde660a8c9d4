// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/triangle_pairs.h"

#include "geometry/certainly_apart.h"
#include "geometry/exact_predicates.h"

namespace swept {
namespace {

struct Plane2d {
  int u = 0, v = 1;
  int turn = 0;  ///< orientation of the triangle in this plane
};

/// Returns a coordinate plane on which the projection of the triangle has area.
Plane2d projection(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d n = (b - a).cross(c - a).cwiseAbs();
  int first = 0;
  n.maxCoeff(&first);
  for (int i = 0; i < 3; ++i) {
    const int axis = (first + i) % 3;
    Plane2d plane{(axis + 1) % 3, (axis + 2) % 3, 0};
    plane.turn = orientation2d(a, b, c, plane.u, plane.v);
    if (plane.turn != 0) return plane;
  }
  return {};
}

/// Returns whether r lies in the closed wedge at v between a and b. r must lie in the plane of
/// (v, a, b).
bool wedgeContains(const Eigen::Vector3d& v, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const Eigen::Vector3d& r) {
  const Plane2d plane = projection(v, a, b);
  return plane.turn * orientation2d(v, a, r, plane.u, plane.v) >= 0 &&
         plane.turn * orientation2d(v, r, b, plane.u, plane.v) >= 0;
}

/// Returns whether r lies in the closed triangle. r must lie in the plane of the triangle.
bool triangleContains(const Corners& p, const Plane2d& plane, const Eigen::Vector3d& r) {
  for (int i = 0; i < 3; ++i) {
    if (plane.turn * orientation2d(*p[i], *p[(i + 1) % 3], r, plane.u, plane.v) < 0) return false;
  }
  return true;
}

/// Returns whether two closed segments in one plane intersect.
bool segmentsMeet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d, const Plane2d& plane) {
  const int u = plane.u, v = plane.v;
  const int c1 = orientation2d(a, b, c, u, v), d1 = orientation2d(a, b, d, u, v);
  const int a1 = orientation2d(c, d, a, u, v), b1 = orientation2d(c, d, b, u, v);
  if (c1 * d1 > 0 || a1 * b1 > 0) return false;
  if (c1 != 0 || d1 != 0 || a1 != 0 || b1 != 0) return true;
  // All four points lie on one line. Test whether the ranges overlap.
  for (const int axis : {u, v}) {
    if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
        std::max(c[axis], d[axis]) < std::min(a[axis], b[axis])) {
      return false;
    }
  }
  return true;
}

bool segmentMeetsTriangleInPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Corners& p, const Plane2d& plane) {
  if (triangleContains(p, plane, a) || triangleContains(p, plane, b)) return true;
  for (int i = 0; i < 3; ++i) {
    if (segmentsMeet(a, b, *p[i], *p[(i + 1) % 3], plane)) return true;
  }
  return false;
}

/// Returns whether the segment a-b intersects a triangle. The ends a and b lie on the sides sa and
/// sb of the triangle's plane (-1, 0 or 1).
bool segmentMeetsTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int sa, int sb,
                          const Corners& p) {
  if (sa * sb > 0) return false;
  if (sa == 0 && sb == 0) {
    return segmentMeetsTriangleInPlane(a, b, p, projection(*p[0], *p[1], *p[2]));
  }
  if (sa == 0) return triangleContains(p, projection(*p[0], *p[1], *p[2]), a);
  if (sb == 0) return triangleContains(p, projection(*p[0], *p[1], *p[2]), b);
  bool positive = false, negative = false;
  for (int i = 0; i < 3; ++i) {
    const int side = orientation3d(a, b, *p[i], *p[(i + 1) % 3]);
    positive = positive || side > 0;
    negative = negative || side < 0;
    if (positive && negative) return false;
  }
  return true;
}

/// Returns on which sides of the plane of p the corners of q lie.
std::array<int, 3> sides(const Corners& p, const Corners& q) {
  std::array<int, 3> result{};
  for (int i = 0; i < 3; ++i) result[i] = orientation3d(*p[0], *p[1], *p[2], *q[i]);
  return result;
}

bool oneSided(const std::array<int, 3>& s) {
  return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

}  // namespace

bool trianglesMeet(const Corners& p, const Corners& q) {
  const std::array<int, 3> ofQ = sides(p, q);
  if (oneSided(ofQ)) return false;
  const std::array<int, 3> ofP = sides(q, p);
  if (oneSided(ofP)) return false;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (segmentMeetsTriangle(*q[i], *q[j], ofQ[i], ofQ[j], p)) return true;
    if (segmentMeetsTriangle(*p[i], *p[j], ofP[i], ofP[j], q)) return true;
  }
  return false;
}

bool meetBeyondVertex(const Eigen::Vector3d& v, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  // Near v, the triangles are cones over the arcs (a, b) and (c, d) of a sphere around v. They
  // share more than v exactly if the arcs intersect.
  const int sc = orientation3d(v, a, b, c), sd = orientation3d(v, a, b, d);
  if (sc * sd > 0) return false;
  const int sa = orientation3d(v, c, d, a), sb = orientation3d(v, c, d, b);
  if (sa * sb > 0) return false;
  if (sc == 0 && sd == 0) {
    return wedgeContains(v, a, b, c) || wedgeContains(v, a, b, d) || wedgeContains(v, c, d, a) ||
           wedgeContains(v, c, d, b);
  }
  if (sc == 0) return wedgeContains(v, a, b, c);
  if (sd == 0) return wedgeContains(v, a, b, d);
  if (sa == 0) return wedgeContains(v, c, d, a);
  if (sb == 0) return wedgeContains(v, c, d, b);
  // Each arc crosses the line in which the two planes intersect. The arcs intersect if they cross
  // it on the same side of v.
  return sc == sb && sd == sa;
}

bool meetBeyondEdge(const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& p,
                    const Eigen::Vector3d& q) {
  if (orientation3d(u, v, p, q) != 0) return false;
  const Plane2d plane = projection(u, v, p);
  return plane.turn * orientation2d(u, v, q, plane.u, plane.v) > 0;
}

bool trianglesIntersect(const std::vector<Eigen::Vector3d>& vertices,
                        const std::array<std::int32_t, 3>& p,
                        const std::array<std::int32_t, 3>& q) {
  auto at = [&](std::int32_t v) -> const Eigen::Vector3d& { return vertices[v]; };
  // Move the common corners to the front of both corner lists.
  int common = 0;
  std::array<std::int32_t, 3> a = p, b = q;
  for (int i = 0; i < 3; ++i) {
    for (int j = common; j < 3; ++j) {
      if (p[i] != b[j]) continue;
      std::swap(b[common], b[j]);
      for (int k = common; k < 3; ++k) {
        if (a[k] == p[i]) std::swap(a[common], a[k]);
      }
      ++common;
      break;
    }
  }
  if (common == 3) return true;
  if (common == 2) return meetBeyondEdge(at(a[0]), at(a[1]), at(a[2]), at(b[2]));
  if (common == 1) return meetBeyondVertex(at(a[0]), at(a[1]), at(a[2]), at(b[1]), at(b[2]));
  return trianglesMeet({&at(a[0]), &at(a[1]), &at(a[2])}, {&at(b[0]), &at(b[1]), &at(b[2])});
}

bool trianglesIntersectFast(const std::vector<Eigen::Vector3d>& vertices,
                            const std::array<std::int32_t, 3>& p,
                            const std::array<std::int32_t, 3>& q) {
  return !certainlyApart(vertices, p, q) && !hasNoArea(vertices, p) && !hasNoArea(vertices, q) &&
         trianglesIntersect(vertices, p, q);
}

}  // namespace swept
