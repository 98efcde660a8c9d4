// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/polygon_split.h"

#include <cmath>

namespace swept {
namespace {

using Point = Eigen::Vector2d;

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Drops the coordinate in which the Newell normal of the polygon is largest. The other two are
// ordered so that the polygon runs counter-clockwise.
std::vector<Point> flatten(const std::vector<Eigen::Vector3d>& vertices,
                           std::span<const std::int32_t> corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = vertices[static_cast<std::size_t>(corners[0])];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d a = vertices[static_cast<std::size_t>(corners[i])] - origin;
    const Eigen::Vector3d b =
        vertices[static_cast<std::size_t>(corners[(i + 1) % corners.size()])] - origin;
    normal += a.cross(b);
  }
  int drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  int u = (drop + 1) % 3;
  int v = (drop + 2) % 3;
  if (normal[drop] < 0) std::swap(u, v);
  std::vector<Point> points;
  points.reserve(corners.size());
  for (const std::int32_t corner : corners) {
    const Eigen::Vector3d p = vertices[static_cast<std::size_t>(corner)] - origin;
    points.emplace_back(p[u], p[v]);
  }
  return points;
}

bool contains(const Point& a, const Point& b, const Point& c, const Point& p) {
  // A polygon may touch itself (at a slit to a hole). So a point that coincides with a corner of
  // the ear does not count as inside.
  if (p == a || p == b || p == c) return false;
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

}  // namespace

void splitPolygon(const std::vector<Eigen::Vector3d>& vertices,
                  std::span<const std::int32_t> corners,
                  std::vector<std::array<std::int32_t, 3>>& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const std::vector<Point> points = flatten(vertices, corners);
  std::vector<std::size_t> ring(corners.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;

  const auto isEar = [&](std::size_t k) {
    const std::size_t n = ring.size();
    const Point& a = points[ring[(k + n - 1) % n]];
    const Point& b = points[ring[k]];
    const Point& c = points[ring[(k + 1) % n]];
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t j = 2; j + 1 < n; ++j) {
      if (contains(a, b, c, points[ring[(k + j) % n]])) return false;
    }
    return true;
  };

  std::size_t start = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    std::size_t ear = start % n;
    std::size_t tried = 0;
    while (tried < n && !isEar(ear)) {
      ear = (ear + 1) % n;
      ++tried;
    }
    // No ear is left, so the rest is degenerate or intersects itself. Clipping a corner
    // nevertheless keeps the boundary.
    if (tried == n) ear = start % n;
    triangles.push_back(
        {corners[ring[(ear + n - 1) % n]], corners[ring[ear]], corners[ring[(ear + 1) % n]]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    start = ear;
  }
  triangles.push_back({corners[ring[0]], corners[ring[1]], corners[ring[2]]});
}

}  // namespace swept
