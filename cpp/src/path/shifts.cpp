// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/shifts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <set>

#include "clearance/penetration.h"

namespace swept::path {
namespace {

using Eigen::Vector3d;

using Cell = std::array<int, 3>;
// Edge lengths of the cells, in radii of the part.
constexpr std::array<double, 3> kWidths{0.5, 0.25, 0.1};

State placed(const Scene& scene, const State& goal, const Cell& cell, double width) {
  return scene.moved(goal, {width * Vector3d(cell[0], cell[1], cell[2]), Vector3d::Zero()});
}

bool within(const SearchSpace& space, const State& state) {
  return (state.middle.array() >= space.low.array()).all() &&
         (state.middle.array() <= space.high.array()).all();
}

}  // namespace

// Best-first search over one grid. The next placement is the one with the smallest sum of the
// length of the path so far and the straight distance to the start.
class GridSearch {
 public:
  GridSearch(const Scene& scene, const Rule& rule, const SearchSpace& space, const State& start,
             const State& goal, double width, int maxPlacements, Memory& memory, State& farthest)
      : scene_(scene),
        rule_(rule),
        space_(space),
        start_(start),
        goal_(goal),
        width_(width),
        left_(maxPlacements),
        memory_(memory),
        farthest_(farthest) {
    push({0, 0, 0}, {0, 0, 0}, 0);
  }

  /// Examines up to `count` placements, and subtracts their number from `count` and from left_.
  /// Returns the path once it is found.
  std::vector<State> search(int& count, const RunContext& run) {
    while (!isOver() && count > 0 && !run.isCancelled()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (closed_.count(entry.cell) != 0) continue;
      --count;
      --left_;
      const State from = placed(scene_, goal_, entry.before, width_);
      const State here = placed(scene_, goal_, entry.cell, width_);
      const bool root = entry.cell == Cell{0, 0, 0};
      if (!root && scene_.follow(from, here, rule_, memory_, 0.05).fraction < 1) continue;
      closed_[entry.cell] = entry.before;
      if ((here.middle - goal_.middle).norm() > (farthest_.middle - goal_.middle).norm())
        farthest_ = here;
      // The search ends as soon as a straight free move leads to the start.
      if (scene_.follow(here, start_, rule_, memory_, 0.05).fraction >= 1)
        return pathFrom(entry.cell);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int sign : {1, -1}) {
          Cell next = entry.cell;
          next[axis] += sign;
          if (closed_.count(next) == 0) push(next, entry.cell, entry.length + width_);
        }
    }
    return {};
  }
  bool isOver() const { return queue_.empty() || left_ <= 0; }

 private:
  struct Entry {
    double bound, length;
    Cell cell, before;
    bool operator<(const Entry& other) const {
      return bound != other.bound ? bound > other.bound
                                  : std::tie(cell, before) > std::tie(other.cell, other.before);
    }
  };

  void push(const Cell& cell, const Cell& before, double length) {
    const State state = placed(scene_, goal_, cell, width_);
    if (within(space_, state))
      queue_.push({length + (state.middle - start_.middle).norm(), length, cell, before});
  }

  std::vector<State> pathFrom(Cell cell) const {
    std::vector<State> keys{start_};
    while (cell != Cell{0, 0, 0}) {
      keys.push_back(placed(scene_, goal_, cell, width_));
      cell = closed_.at(cell);
    }
    keys.push_back(goal_);
    return keys;
  }

  const Scene& scene_;
  const Rule& rule_;
  const SearchSpace& space_;
  const State& start_;
  const State& goal_;
  double width_;
  int left_;  ///< placements that may still be examined
  Memory& memory_;
  State& farthest_;
  std::priority_queue<Entry> queue_;
  std::map<Cell, Cell> closed_;
};

namespace {

// Returns whether the part is blocked at each placement in the cube around `middle`.
bool blocked(const Scene& scene, const Rule& rule, const State& middle, double halfDiagonal) {
  const Eigen::Matrix3d R = middle.pose.rotation.toRotationMatrix();
  const Vector3d t = middle.pose.translation;
  for (std::size_t i = 0; i < scene.count(); ++i) {
    const clearance::PairSearch pair(scene.part(), scene.neighbour(i));
    const double distance = pair.distanceAt(R, t, rule[i] + 1e-9).distance;
    if (distance > 0 && distance + halfDiagonal < rule[i]) return true;
    if (distance > 0 && !pair.containedAt(R, t)) continue;
    const double depth = halfDiagonal - rule[i];
    // If the surfaces intersect and half the diagonal is less than the required distance, the whole
    // cube is blocked.
    if (depth < 0 || clearance::overlapsAtLeast(pair, R, t, depth)) return true;
  }
  return false;
}

}  // namespace

ShiftSearch::ShiftSearch(const Scene& scene, const Rule& rule, const SearchSpace& space,
                         const std::vector<State>& starts, const std::vector<State>& goals,
                         int maxPlacements)
    : scene_(scene),
      rule_(rule),
      space_(space),
      starts_(starts),
      goals_(goals),
      maxPlacements_(maxPlacements),
      memory_(scene.memory()),
      farthest_(goals.front()) {}

ShiftSearch::~ShiftSearch() = default;

void ShiftSearch::advance(int count, const RunContext& run) {
  while (count > 0 && !isOver() && !run.isCancelled()) {
    if (!grid_) begin();
    path_ = grid_->search(count, run);
    if (!path_.empty() || !grid_->isOver()) continue;
    grid_.reset();
    ++number_;
  }
}

bool ShiftSearch::isOver() const {
  return !path_.empty() || number_ >= starts_.size() * goals_.size() * kWidths.size();
}

void ShiftSearch::begin() {
  const std::size_t pair = number_ / kWidths.size();
  grid_ = std::make_unique<GridSearch>(
      scene_, rule_, space_, starts_[pair / goals_.size()], goals_[pair % goals_.size()],
      kWidths[number_ % kWidths.size()] * scene_.radius(), maxPlacements_, memory_, farthest_);
}

bool provesNoTranslation(const Scene& scene, const Rule& rule, const SearchSpace& space,
                         const State* start, const State& goal, int maxPlacements,
                         const std::function<bool()>& isLate, RunContext& run) {
  for (const double fraction : kWidths) {
    const double width = fraction * scene.radius();
    std::set<Cell> seen{{0, 0, 0}};
    // Flood fill over the cells that are not proven blocked, from the goal. The farthest cell comes
    // first, so that a path out is found early.
    std::priority_queue<std::pair<int, Cell>> queue;
    queue.push({0, {0, 0, 0}});
    bool out = false;
    int left = maxPlacements;
    while (!queue.empty() && !out && --left > 0 && !isLate()) {
      run.checkpoint(Phase::Shifts);
      const Cell cell = queue.top().second;
      queue.pop();
      const State state = placed(scene, goal, cell, width);
      const bool hasStart =
          start != nullptr &&
          (state.middle - start->middle).cwiseAbs().maxCoeff() <= 0.5 * width * (1 + 1e-9);
      out = hasStart || !within(space, state);
      if (out || (cell != Cell{0, 0, 0} &&
                  blocked(scene, rule, state, 0.5 * std::sqrt(3.0) * width * (1 + 1e-9))))
        continue;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int sign : {1, -1}) {
          Cell next = cell;
          next[axis] += sign;
          if (seen.insert(next).second)
            queue.push({next[0] * next[0] + next[1] * next[1] + next[2] * next[2], next});
        }
    }
    if (!out && left > 0 && queue.empty()) return true;
  }
  return false;
}

}  // namespace swept::path
