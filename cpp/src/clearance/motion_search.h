// Smallest distance over a whole motion; spans of it nearer than a level; samples for a graph.
// In:    a pair of meshes, a hierarchy over the motion. Units: mm.
// Out:   plain values; the same for any number of threads (rounds of fixed size, merged in order).
// Cost:  a proof or a distance query for each node that cannot be dropped with its parent.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <utility>

#include "clearance/pair_search.h"
#include "swept/run_context.h"

namespace swept::clearance {

/// What one neighbour's searches have in common.
struct SearchContext {
  const PairSearch& pair;
  const MotionTree& motion;
  RunContext& run;
  /// mm, nothing farther apart than this is measured.
  double within = std::numeric_limits<double>::infinity();
  std::atomic<std::int64_t> queries{0};
  std::atomic<std::int64_t> certificates{0};
};

struct Minimum {
  double distance = 0;
  double parameter = 0;
  PairDistance at;
  bool inside = false;  ///< one part wholly inside the other at `parameter`; distance is then 0
  bool found() const { return inside || at.pair.body >= 0; }
};

/// No part of the motion comes nearer than the result minus `slack`; stops early at or below slack.
/// Where nothing comes nearer than `context.within`, that is the distance, and nothing is found.
Minimum searchMinimum(SearchContext& context, double slack);

/// Says whether the parts overlap by at least this much at a pose (a sufficient test).
using OverlapTest =
    std::function<bool(const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double atLeast)>;

/// Spans of the motion's parameter that hold every moment nearer than `level` (> 0), ascending,
/// at most `resolution` of travel too long at each end. Single poses: from == to.
std::vector<std::pair<double, double>> spansBelow(SearchContext& context, double level,
                                                  double resolution, const OverlapTest& overlaps);

/// Distances at `samples` moments even in time, plus the one at `extra`; none above context.within.
std::vector<std::pair<double, double>> sampleDistances(SearchContext& context, int samples,
                                                       double extra);

}  // namespace swept::clearance
