// Stores bounding boxes (world axes) of a moving body over intervals of time, in a binary tree over
// time.
// In:      a timed motion and the time span.
// Out:     whether the boxes prove that two bodies always stay farther apart than a given distance.
// Units:   mm, s.
// Cost:    O(poses + leaves) to build. For a pair of bodies, only the intervals are visited in
//        which their boxes are near each other.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/relative_motion.h"
#include "geometry/box_tree.h"

namespace swept::clearance {

class SweptBoxes {
 public:
  SweptBoxes(const TimedMotion& motion, const TimeInterval& span);

  /// Returns the box of the whole motion.
  const BoxTree::Bounds& whole() const { return boxes_[1]; }
  /// Returns true only if all points of the two bodies are always more than `within` apart. Both
  /// trees must cover the same time span.
  bool staysApart(const SweptBoxes& other, double within) const;

 private:
  static constexpr std::size_t kLeaves = 256;

  /// A binary heap: 1 is the root, 2 n and 2 n + 1 are the halves of n.
  std::vector<BoxTree::Bounds> boxes_;
};

/// Returns, in ascending order, the pairs of bodies that the boxes do not prove to be more than
/// `within` apart.
std::vector<std::pair<std::int32_t, std::int32_t>> nearPairs(const std::vector<SweptBoxes>& bodies,
                                                             double within);

}  // namespace swept::clearance
