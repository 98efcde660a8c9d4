// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/certainly_apart.h"

#include "geometry/exact_predicates.h"

namespace swept {
namespace {

/// Angles with a smaller sine than this count as zero. Rounding errors stay below 1e-15.
constexpr double kSine = 1e-9;

/// Returns true only if the angle between w and x is certainly acute. The margin is far above
/// rounding.
bool isCertainlyAcute(const Eigen::Vector3d& w, const Eigen::Vector3d& x) {
  const double along = w.dot(x);
  return along > 0 && along * along > kSine * kSine * w.squaredNorm() * x.squaredNorm();
}

/// Returns true if one of three planes through v separates the triangles (v, a, b) and (v, c, d);
/// all corners are relative to v. The planes are perpendicular to (v, a, b): one along each edge at
/// v, and one perpendicular to the bisector of a and b.
bool separatedAtVertex(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d) {
  const Eigen::Vector3d normal = a.cross(b);
  const double a2 = a.squaredNorm(), b2 = b.squaredNorm();
  if (!(normal.squaredNorm() > kSine * kSine * a2 * b2)) return false;
  const auto separates = [&](const Eigen::Vector3d& w) {
    return isCertainlyAcute(w, c) && isCertainlyAcute(w, d);
  };
  return separates(a.cross(normal)) || separates(normal.cross(b)) ||
         separates(-(std::sqrt(b2) * a + std::sqrt(a2) * b));
}

/// Two triangles share the edge from the origin to e and have the third corners p and q. Returns
/// whether they certainly lie on opposite sides of the edge.
bool separatedAtEdge(const Eigen::Vector3d& e, const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return isCertainlyAcute(e.cross(p), -e.cross(q));
}

}  // namespace

bool hasNoArea(const std::vector<Eigen::Vector3d>& vertices,
               const std::array<std::int32_t, 3>& tri) {
  return tri[0] == tri[1] || tri[1] == tri[2] || tri[2] == tri[0] ||
         collinear(vertices[tri[0]], vertices[tri[1]], vertices[tri[2]]);
}

bool certainlyApart(const std::vector<Eigen::Vector3d>& vertices,
                    const std::array<std::int32_t, 3>& p, const std::array<std::int32_t, 3>& q) {
  const auto at = [&](std::int32_t v) -> const Eigen::Vector3d& { return vertices[v]; };
  int common = 0, i = 0, j = 0;  // i, j: index in p and in q of the last common corner
  for (int m = 0; m < 3; ++m) {
    for (int n = 0; n < 3; ++n) {
      if (p[m] != q[n]) continue;
      ++common;
      i = m;
      j = n;
    }
  }
  if (common == 0) {
    // The plane of a triangle usually separates triangles of two sheets that lie on each other. A
    // plane through an edge usually separates neighbours in one sheet.
    const TriangleSeparator a(vertices, p), b(vertices, q);
    return a.separatedByPlane(b) || b.separatedByPlane(a) || a.separatedByEdge(b) ||
           b.separatedByEdge(a);
  }
  const Eigen::Vector3d& v = at(p[i]);
  const Eigen::Vector3d a = at(p[(i + 1) % 3]) - v, b = at(p[(i + 2) % 3]) - v;
  const Eigen::Vector3d c = at(q[(j + 1) % 3]) - v, d = at(q[(j + 2) % 3]) - v;
  if (common == 1) return separatedAtVertex(a, b, c, d) || separatedAtVertex(c, d, a, b);
  if (common == 3) return false;
  for (int m = 1; m < 3; ++m) {
    for (int n = 1; n < 3; ++n) {
      if (p[(i + m) % 3] == q[(j + n) % 3]) {
        return separatedAtEdge(m == 1 ? a : b, m == 1 ? b : a, n == 1 ? d : c);
      }
    }
  }
  return false;
}

}  // namespace swept
