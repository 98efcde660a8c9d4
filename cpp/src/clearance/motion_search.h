// Finds the smallest distance over a whole motion, the time spans in which the distance is below a
// given value, and samples of the distance for a graph.
// In:      a pair of meshes and the tree of the motion (motion_tree.h).
// Out:     results that do not depend on the number of threads: nodes are examined in rounds of
//          fixed size, and the results of a round are merged in order.
// Units:   mm.
// Cost:    one proof or distance query for each node whose parent could not be discarded.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <utility>

#include "clearance/pair_search.h"
#include "swept/run_context.h"

namespace swept::clearance {

/// Data that all searches for one neighbour share.
struct SearchContext {
  const PairSearch& pair;
  const MotionTree& motion;
  RunContext& run;
  /// mm; larger distances are not measured.
  double within = std::numeric_limits<double>::infinity();
  std::atomic<std::int64_t> queries{0};
  std::atomic<std::int64_t> certificates{0};
};

struct Minimum {
  double distance = 0;
  double parameter = 0;
  PairDistance at;
  /// One part lies wholly inside the other at `parameter`; distance is then 0.
  bool inside = false;
  bool found() const { return inside || at.pair.body >= 0; }
};

/// Returns the smallest distance over the motion. It is too large by at most `slack` (mm). The
/// search ends early once the distance is at most `slack`. If no distance is below
/// `context.within`, returns that value, and found() is false.
Minimum searchMinimum(SearchContext& context, double slack);

/// Returns true only if the parts overlap by at least `atLeast` (mm) at a pose. May return false
/// although they do.
using OverlapTest =
    std::function<bool(const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double atLeast)>;

/// Returns spans of the motion parameter, in ascending order. Together they contain all times with
/// a distance below `level` (mm, > 0). At each end, a span extends beyond these times by at most
/// `resolution` (mm of travel). Without interpolation, a single pose gives a span with from == to.
std::vector<std::pair<double, double>> spansBelow(SearchContext& context, double level,
                                                  double resolution, const OverlapTest& overlaps);

/// Returns pairs (parameter, distance) at `samples` evenly spaced times and at the parameter
/// `extra`. A distance above context.within is replaced by that value.
std::vector<std::pair<double, double>> sampleDistances(SearchContext& context, int samples,
                                                       double extra);

}  // namespace swept::clearance
