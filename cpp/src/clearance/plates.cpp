// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/plates.h"

#include <algorithm>

#include "base/parallel.h"

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kLevels = 4;  // groups of up to 256 triangles; larger groups are seldom flat

Vector3d doubleArea(const Triangle3d& c) { return (c[1] - c[0]).cross(c[2] - c[0]); }

/// Returns the mean normal; its sign has no meaning. Neighbouring triangles of an open surface may
/// have opposite orientations, so each normal is first turned to the side of the largest one.
Vector3d meanNormal(const Triangle3d* begin, const Triangle3d* end) {
  const Vector3d first = doubleArea(*std::max_element(begin, end, [](const auto& a, const auto& b) {
    return doubleArea(a).squaredNorm() < doubleArea(b).squaredNorm();
  }));
  Vector3d sum = Vector3d::Zero();
  for (const Triangle3d* c = begin; c != end; ++c) {
    const Vector3d normal = doubleArea(*c);
    sum += normal.dot(first) < 0 ? Vector3d(-normal) : normal;
  }
  const double length = sum.norm();
  return length > 1e-150 ? Vector3d(sum / length) : Vector3d::UnitZ();
}

Plate plateOf(const Triangle3d* begin, const Triangle3d* end) {
  BoxTree::Bounds box;
  const Vector3d axis = meanNormal(begin, end);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Triangle3d* c = begin; c != end; ++c) {
    for (const Vector3d& x : *c) {
      box.extend(x);
      low = std::min(low, axis.dot(x));
      high = std::max(high, axis.dot(x));
    }
  }
  const Vector3d middle = 0.5 * (box.low + box.high);
  Plate plate{middle + (0.5 * (low + high) - axis.dot(middle)) * axis, axis};
  for (const Triangle3d* c = begin; c != end; ++c) {
    for (const Vector3d& x : *c) {
      const Vector3d off = x - plate.centre;
      const double along = axis.dot(off);
      plate.half = std::max(plate.half, std::abs(along));
      plate.radius = std::max(plate.radius, (off - along * axis).norm());
    }
  }
  return plate;
}

}  // namespace

Plates::Plates(const BoxTree& tree, const std::vector<Triangle3d>& corners) {
  levels_.resize(std::min(kLevels, tree.root().level));
  std::size_t width = 1;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    width *= BoxTree::kWidth;
    std::vector<Plate>& plates = levels_[k];
    plates.resize(tree.count(static_cast<std::int32_t>(k + 1)));
    constexpr std::size_t kBlock = 256;
    parallelBlocks(plates.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        plates[i] = plateOf(&corners[i * width],
                            corners.data() + std::min((i + 1) * width, corners.size()));
    });
  }
}

}  // namespace swept::clearance
