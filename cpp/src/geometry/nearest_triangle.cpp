// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/nearest_triangle.h"

#include "geometry/half_edges.h"

namespace swept {

NearestTriangle::NearestTriangle(const std::vector<Eigen::Vector3d>& vertices,
                                 const Triangles& triangles, Walks walks)
    : vertices_(vertices), triangles_(triangles), tree_(boxTreeOf(vertices, triangles)) {
  if (walks == Walks::Yes)
    across_ = std::move(findAdjacency(EdgeTable(triangles, vertices.size())).across);
}

double NearestTriangle::query(const Eigen::Vector3d& p, double limit, double enough,
                              std::int32_t& hint) const {
  double best = limit;
  // True only after a triangle was found: `limit` alone may already be below `enough`.
  bool isEnough = false;
  const auto test = [&](std::int32_t t) {
    const double d = squaredDistanceTo(p, t);
    if (d >= best) return false;
    best = d;
    hint = t;
    isEnough = d <= enough;
    return true;
  };
  if (hint >= 0) test(hint);
  if (isEnough) return best;
  tree_.searchNear(p, std::sqrt(best), [&](std::uint32_t place, double& reach) {
    if (test(tree_.item(place))) reach = std::sqrt(best);
    return !isEnough;
  });
  return best;
}

void NearestTriangle::testNeighbours(const Eigen::Vector3d& p, std::int32_t at, int depth,
                                     double limit, double& best, std::int32_t& hint) const {
  for (int k = 0; k < 3 && best > limit; ++k) {
    const std::uint32_t other = across_[3 * static_cast<std::size_t>(at) + k];
    if (other == kNoNeighbour) continue;
    const auto next = static_cast<std::int32_t>(other / 3);
    if (depth > 1) {
      testNeighbours(p, next, depth - 1, limit, best, hint);
      continue;
    }
    const double d = squaredDistanceTo(p, next);
    if (d >= best) continue;
    best = d;
    hint = next;
  }
}

bool NearestTriangle::isNear(const Eigen::Vector3d& p, double limit, std::int32_t& hint) const {
  if (hint >= 0 && across_.size() > 0) {
    double best = squaredDistanceTo(p, hint);
    while (best > limit) {
      const std::int32_t at = hint;
      testNeighbours(p, at, 1, limit, best, hint);
      if (hint == at) testNeighbours(p, at, 2, limit, best, hint);
      if (hint == at) break;
    }
    if (best <= limit) return true;
  }
  const double reach = 1.01 * limit, found = query(p, reach, limit, hint);
  return found < reach && found <= limit;
}

}  // namespace swept
