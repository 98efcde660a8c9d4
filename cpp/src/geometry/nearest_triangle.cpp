// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/nearest_triangle.h"

namespace swept {

double NearestTriangle::query(const Eigen::Vector3d& p, double limit, double enough,
                              std::int32_t& hint) const {
  double best = limit;
  bool isEnough = false;  // only what was found can be: the limit itself may be as small
  const auto look = [&](std::int32_t t) {
    const auto& tri = triangles_[t];
    const double d = squaredDistance(p, vertices_[tri[0]], vertices_[tri[1]], vertices_[tri[2]]);
    if (d >= best) return false;
    best = d;
    hint = t;
    isEnough = d <= enough;
    return true;
  };
  if (hint >= 0) look(hint);
  if (isEnough) return best;
  tree_.searchNear(p, std::sqrt(best), [&](std::uint32_t place, double& reach) {
    if (look(tree_.item(place))) reach = std::sqrt(best);
    return !isEnough;
  });
  return best;
}

}  // namespace swept
