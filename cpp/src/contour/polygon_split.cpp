// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/polygon_split.h"

#include <cmath>

namespace swept {
namespace {

using Vec2 = Eigen::Vector2d;

double cross2(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Quality of a diagonal of a quad. `valid`: seen along the lattice edge, the diagonal lies between
/// the other two corners. `miss`: distance from the crossing to the point where one of the two
/// triangles meets the lattice edge. `length2`: squared length of the diagonal.
struct Diagonal {
  bool valid = false;
  double miss = 0, length2 = 0;
};

/// Rates the diagonal from corner `from`. v holds the corners relative to the crossing, in ring
/// order, with the coordinates (b, c, a); a runs along the lattice edge.
Diagonal rate(const std::array<Eigen::Vector3d, 4>& v, int from) {
  const Eigen::Vector3d &p = v[from], &q = v[from + 2], &r = v[(from + 1) & 3],
                        &s = v[(from + 3) & 3];
  const Vec2 d = (q - p).head<2>();
  const double sideR = cross2(d, (r - p).head<2>()), sideS = cross2(d, (s - p).head<2>());
  const double sideEdge = cross2(d, -p.head<2>());
  Diagonal out;
  out.valid = sideR < 0 && sideS > 0;
  out.length2 = (q - p).squaredNorm();
  // The lattice edge passes through one of the two triangles. Find the point where the edge meets
  // this triangle.
  const Eigen::Vector3d& third = sideEdge < 0 ? r : s;
  const Eigen::Vector3d n = (q - p).cross(third - p);
  out.miss = std::abs(n[2]) > 1e-12 ? std::abs(n.dot(p) / n[2]) : 1e3;
  return out;
}

/// Two values of `miss` count as equal if they differ by less than this (cells).
constexpr double kEquallyGood = 2e-3;
/// If the `miss` of the chosen diagonal exceeds this (cells), the quad becomes a fan.
constexpr double kFanMiss = 0.05;

}  // namespace

Split chooseSplit(const DualSurface& dual, int axis, std::int32_t i, const Eigen::Vector3d& point,
                  std::uint32_t crossing) {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  std::array<Eigen::Vector3d, 4> v;
  for (int corner = 0; corner < 4; ++corner) {
    const std::uint32_t global = dual.vertex(axis, i, crossing, corner);
    const std::int32_t layer = global >= dual.firstVertex[i] ? i : i - 1;
    const Eigen::Vector3d p = dual.position(global, layer) - point;
    v[corner] = {p[b], p[c], p[axis]};
  }
  const Diagonal d02 = rate(v, 0), d13 = rate(v, 1);
  if (!d02.valid && !d13.valid) return Split::Fan;
  bool first = d02.valid;
  if (d02.valid && d13.valid) {
    first = std::abs(d02.miss - d13.miss) < kEquallyGood ? d02.length2 <= d13.length2
                                                         : d02.miss < d13.miss;
  }
  if ((first ? d02 : d13).miss > kFanMiss) return Split::Fan;
  return first ? Split::Diagonal02 : Split::Diagonal13;
}

}  // namespace swept
