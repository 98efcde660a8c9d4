// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/cover_search.h"

namespace swept::offset {

CoverSearch::CoverSearch(std::vector<CoverTriangle>& triangles) : triangles_(triangles) {
  const auto boxOf = [&](std::size_t t) {
    BoxTree::Bounds box;
    for (const Eigen::Vector3d& corner : triangles[t].corner) box.extend(corner);
    box.low.array() -= triangles[t].slack;
    box.high.array() += triangles[t].slack;
    return box;
  };
  tree_ = BoxTree(triangles.size(), boxOf, BoxTree::Order::Medians);
  std::vector<CoverTriangle> sorted(triangles.size());
  for (std::size_t index = 0; index < sorted.size(); ++index) {
    sorted[index] = triangles[static_cast<std::size_t>(tree_.item(index))];
  }
  triangles_.swap(sorted);
}

CoverSearch::Nearest CoverSearch::nearest(const Eigen::Vector3d& x, double below, std::int32_t hint,
                                          double enough) const {
  Nearest best{below, -1};
  const auto test = [&](std::int32_t t) {
    const CoverTriangle& triangle = triangles_[static_cast<std::size_t>(t)];
    const double reach = (x - nearestOnTriangle(x, triangle)).norm() - triangle.slack;
    if (reach < best.reach) best = {reach, t};
  };
  if (hint >= 0) test(hint);
  if (best.triangle >= 0 && best.reach <= enough) return best;
  tree_.searchNear(x, best.reach, [&](std::uint32_t index, double& reach) {
    test(static_cast<std::int32_t>(index));
    reach = best.reach;
    return best.triangle < 0 || best.reach > enough;
  });
  return best;
}

}  // namespace swept::offset
