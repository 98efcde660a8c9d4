// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/moving_boxes.h"

#include <algorithm>

#include "geometry/morton.h"

namespace swept {
namespace {

constexpr std::size_t kMinToRebuild = 64;  // with fewer members, a rebuild saves nothing

}  // namespace

MovingBoxes::MovingBoxes(const TriMesh& mesh, std::vector<std::int32_t> members)
    : mesh_(mesh), members_(std::move(members)) {
  build();
}

void MovingBoxes::build() {
  const std::size_t n = members_.size();
  left_ = n;
  levels_.clear();
  order_.resize(n);
  slot_.resize(n);
  if (n == 0) return;
  Box all;
  for (const std::int32_t t : members_) all.extend(boxOf(mesh_, t));
  const double scale = 1023 / std::max(all.sizes().maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(n);
  for (std::size_t m = 0; m < n; ++m) {
    const Eigen::Vector3d c =
        ((boxOf(mesh_, members_[m]).center() - all.min()) * scale).cwiseMax(0).cwiseMin(1023);
    keys[m] = {mortonCode(static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]),
                          static_cast<std::uint32_t>(c[2])),
               static_cast<std::uint32_t>(m)};
  }
  std::sort(keys.begin(), keys.end());
  levels_.emplace_back((n + 3) / 4);
  for (std::size_t i = 0; i < n; ++i) {
    order_[i] = members_[keys[i].second];
    slot_[keys[i].second] = static_cast<std::uint32_t>(i);
    levels_[0][i / 4].extend(boxOf(mesh_, order_[i]));
  }
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> level((below.size() + 3) / 4);
    for (std::size_t i = 0; i < below.size(); ++i) level[i / 4].extend(below[i]);
    levels_.push_back(std::move(level));
  }
}

std::size_t MovingBoxes::memberOf(std::int32_t triangle) const {
  return std::lower_bound(members_.begin(), members_.end(), triangle) - members_.begin();
}

void MovingBoxes::grow(std::int32_t triangle) {
  const Box box = boxOf(mesh_, triangle);
  std::size_t index = slot_[memberOf(triangle)];
  for (std::vector<Box>& level : levels_) {
    index /= 4;
    if (level[index].contains(box)) return;
    level[index].extend(box);
  }
}

void MovingBoxes::remove(std::int32_t triangle) {
  order_[slot_[memberOf(triangle)]] = -1;
  if (--left_ > members_.size() / 2 || members_.size() < kMinToRebuild) return;
  std::vector<std::int32_t> left;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (order_[slot_[m]] >= 0) left.push_back(members_[m]);
  }
  members_ = std::move(left);
  build();
}

}  // namespace swept
