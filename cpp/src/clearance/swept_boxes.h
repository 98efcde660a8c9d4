// Boxes (world axes) of a moving body over spans of time, as a binary tree over the time.
// In:    a timed motion, the span. Units: mm, s.
// Out:   whether two bodies stay farther apart than a distance at all times, as far as boxes tell.
// Cost:  O(poses + leaves) to build; a pair of bodies opens only the times at which their boxes
// meet.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/relative_motion.h"
#include "geometry/box_tree.h"

namespace swept::clearance {

class SweptBoxes {
 public:
  SweptBoxes(const TimedMotion& motion, const TimeInterval& span);

  /// Of everything that the body passes.
  const BoxTree::Bounds& whole() const { return boxes_[1]; }
  /// True: no two points of the bodies, which move over the same span, are ever nearer than
  /// `within`.
  bool staysApart(const SweptBoxes& other, double within) const;

 private:
  static constexpr std::size_t kLeaves = 256;

  std::vector<BoxTree::Bounds> boxes_;  ///< a heap: 1 is the root, 2 n and 2 n + 1 the halves of n
};

/// Pairs of bodies, ascending, that the boxes do not prove to stay farther apart than `within`.
std::vector<std::pair<std::int32_t, std::int32_t>> nearPairs(const std::vector<SweptBoxes>& bodies,
                                                             double within);

}  // namespace swept::clearance
