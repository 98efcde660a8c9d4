// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/swept_boxes.h"

#include <algorithm>

#include "base/parallel.h"

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

BoxTree::Bounds boxOf(const TimedMotion& motion, const Pose& pose, double grown) {
  const Vector3d centre = pose.rotation * motion.centre() + pose.translation;
  const Vector3d half =
      pose.rotation.toRotationMatrix().cwiseAbs() * motion.half() + Vector3d::Constant(grown);
  return {centre - half, centre + half};
}

double gapBetween(const BoxTree::Bounds& a, const BoxTree::Bounds& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

}  // namespace

SweptBoxes::SweptBoxes(const TimedMotion& motion, const TimeInterval& span) {
  boxes_.resize(2 * kLeaves);
  const auto leafStart = [&](std::size_t i) {
    return span.from + (span.to - span.from) * static_cast<double>(i) / kLeaves;
  };
  std::vector<double> times = motion.moves() ? motion.times() : std::vector<double>{};
  for (std::size_t i = 0; i < kLeaves; ++i) {
    const double from = leafStart(i);
    const double to = leafStart(i + 1);
    std::vector<double> moments{from, to};
    const auto first = std::upper_bound(times.begin(), times.end(), from);
    moments.insert(moments.end() - 1, first, std::lower_bound(first, times.end(), to));
    BoxTree::Bounds& box = boxes_[kLeaves + i];
    for (std::size_t k = 0; k + 1 < moments.size(); ++k) {
      const double bulge = motion.bulge(motion.slice(moments[k], moments[k + 1]));
      box.extend(boxOf(motion, motion.poseAt(moments[k]), bulge));
      box.extend(boxOf(motion, motion.poseAt(moments[k + 1]), bulge));
    }
  }
  for (std::size_t i = kLeaves; i-- > 1;) {
    boxes_[i] = boxes_[2 * i];
    boxes_[i].extend(boxes_[2 * i + 1]);
  }
}

bool SweptBoxes::staysApart(const SweptBoxes& other, double within) const {
  std::vector<std::size_t> open{1};
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (gapBetween(boxes_[i], other.boxes_[i]) > within) continue;
    if (i >= kLeaves) return false;
    open.push_back(2 * i);
    open.push_back(2 * i + 1);
  }
  return true;
}

std::vector<std::pair<std::int32_t, std::int32_t>> nearPairs(const std::vector<SweptBoxes>& bodies,
                                                             double within) {
  const BoxTree tree(bodies.size(), [&](std::size_t i) { return bodies[i].whole(); });
  const Vector3d margin = Vector3d::Constant(within);
  return gather<std::pair<std::int32_t, std::int32_t>>(
      bodies.size(), 16, [&](std::size_t i, auto& found) {
        const auto first = static_cast<std::int32_t>(i);
        const auto begin = found.size();
        tree.forBox(bodies[i].whole().low - margin, bodies[i].whole().high + margin,
                    [&](std::uint32_t place) {
                      const std::int32_t second = tree.item(place);
                      if (second > first && !bodies[i].staysApart(bodies[second], within))
                        found.emplace_back(first, second);
                    });
        std::sort(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end());
      });
}

}  // namespace swept::clearance
