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

// Best-first search over one grid. The order is that of the shortest way so far plus the remaining
// distance.
class GridSearch {
 public:
  GridSearch(const Scene& scene, const Rule& rule, const SearchSpace& space, const State& start,
             const State& goal, double width, Memory& memory)
      : scene_(scene),
        rule_(rule),
        space_(space),
        start_(start),
        goal_(goal),
        width_(width),
        memory_(memory) {}

  std::vector<State> search(int places, RunContext& run) {
    push({0, 0, 0}, {0, 0, 0}, 0);
    while (!queue_.empty() && places > 0) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (closed_.count(entry.cell) != 0) continue;
      run.checkpoint(Phase::Shifts);
      --places;
      const State from = placed(scene_, goal_, entry.before, width_);
      const State here = placed(scene_, goal_, entry.cell, width_);
      const bool root = entry.cell == Cell{0, 0, 0};
      if (!root && scene_.follow(from, here, rule_, memory_, 0.05).fraction < 1) continue;
      closed_[entry.cell] = entry.before;
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
  Memory& memory_;
  std::priority_queue<Entry> queue_;
  std::map<Cell, Cell> closed_;
};

// Whether the part is blocked at each placement in the cube around `middle`.
bool blocked(const Scene& scene, const Rule& rule, const State& middle, double halfDiagonal) {
  const Eigen::Matrix3d R = middle.pose.rotation.toRotationMatrix();
  const Vector3d t = middle.pose.translation;
  for (std::size_t i = 0; i < scene.count(); ++i) {
    const clearance::PairSearch pair(scene.part(), scene.neighbour(i));
    const double distance = pair.distanceAt(R, t, rule[i] + 1e-9).distance;
    if (distance > 0 && distance + halfDiagonal < rule[i]) return true;
    if (distance > 0 && !pair.containedAt(R, t)) continue;
    const double depth = halfDiagonal - rule[i];
    // Where the surfaces intersect, a cube smaller than the required distance is always blocked.
    if (depth < 0 || clearance::overlapsBy(pair, R, t, depth)) return true;
  }
  return false;
}

}  // namespace

std::vector<State> shiftsOnly(const Scene& scene, const Rule& rule, const SearchSpace& space,
                              const State& start, const State& goal, int places, Memory& memory,
                              RunContext& run) {
  for (const double width : kWidths) {
    std::vector<State> keys =
        GridSearch(scene, rule, space, start, goal, width * scene.radius(), memory)
            .search(places, run);
    if (!keys.empty()) return keys;
  }
  return {};
}

bool noShifts(const Scene& scene, const Rule& rule, const SearchSpace& space, const State* start,
              const State& goal, int places, RunContext& run) {
  for (const double fraction : kWidths) {
    const double width = fraction * scene.radius();
    std::set<Cell> seen{{0, 0, 0}};
    // Floods the cells that are not proven blocked, from the goal, the farthest cell first. This
    // finds a way out early.
    std::priority_queue<std::pair<int, Cell>> queue;
    queue.push({0, {0, 0, 0}});
    bool out = false;
    int left = places;
    while (!queue.empty() && !out && --left > 0) {
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
    if (!out && left > 0) return true;
  }
  return false;
}

}  // namespace swept::path
