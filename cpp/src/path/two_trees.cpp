// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/two_trees.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swept::path {
namespace {

using Eigen::Vector3d;

constexpr int kStart = 0, kGoal = 1;
// Largest number of moves of one extension and of one push.
constexpr int kSlides = 5, kPushes = 60;
constexpr double kPushFraction = 0.5;  // fraction of the rounds that push
constexpr double kMaxPush = 3;         // longest push, in radii of the part or in rad
constexpr double kMaxRounding = 1e-9;  // largest fraction of a move that counts as a rounding error
// Smallest fraction of a wanted move that the allowed move must achieve in the wanted direction.
constexpr double kStepBeyond = 0.05;
// Resolution at which the search finds where a move is blocked, as a fraction of the move.
constexpr double kFinest = 1.0 / 16;

}  // namespace

TwoTrees::TwoTrees(const Scene& scene, const Rule& rule, const SearchSpace& space,
                   const std::vector<State>& starts, const std::vector<State>& goals,
                   std::uint64_t seed)
    : scene_(scene), rule_(rule), space_(space), random_(seed), memory_(scene.memory()) {
  longest_ = std::max(0.5 * scene.radius(), 0.05 * (space.high - space.low).norm());
  shortest_ = 2e-4 * scene.radius();
  for (const State& state : starts) add(kStart, -1, state);
  for (const State& state : goals) add(kGoal, -1, state);
}

int TwoTrees::add(int tree, int parent, const State& state) {
  const double size = 0.15 * scene_.radius();
  const State upright = scene_.at(space_.upright, state.middle);
  const Vector3d turn = Scene::between(upright, state).turn * scene_.radius();
  CellKey key;
  for (int k = 0; k < 3; ++k) {
    key[static_cast<std::size_t>(k)] = static_cast<int>(std::floor(state.middle[k] / size));
    key[static_cast<std::size_t>(k + 3)] = static_cast<int>(std::floor(turn[k] / size));
  }
  const auto [cell, isNew] = cells_[tree].try_emplace(key, std::ssize(cellNodes_[tree]));
  if (isNew) cellNodes_[tree].push_back(0);
  ++cellNodes_[tree][static_cast<std::size_t>(cell->second)];
  trees_[tree].push_back({state, parent, cell->second, 0, {}});
  const int index = static_cast<int>(trees_[tree].size()) - 1;
  if (tree == kGoal) {
    const Vector3d& root = trees_[tree].front().state.middle;
    if ((state.middle - root).norm() > (farthest().middle - root).norm()) farthest_ = index;
    if (parent >= 0 && path_.empty() && space_.isOut && space_.isOut(state)) finish(-1, index);
  }
  return index;
}

int TwoTrees::nearest(int tree, const State& to) const {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < trees_[tree].size(); ++i) {
    const State& state = trees_[tree][i].state;
    const double shift = (state.middle - to.middle).norm();
    if (shift >= least) continue;
    const double d = scene_.distance(state, to);
    if (d >= least) continue;
    least = d;
    best = static_cast<int>(i);
  }
  return best;
}

// Selects a few random nodes. Returns the one with the smallest weight: few trials so far, and few
// nodes in its cell.
int TwoTrees::sparse(int tree) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 6; ++k) {
    // Every second candidate is one of the younger nodes, at the end of the list.
    const Tree& nodes = trees_[tree];
    const double u = random_.fraction();
    const double fraction = k % 2 == 0 ? u : 1 - 0.3 * u * u;
    const std::size_t i =
        std::min(nodes.size() - 1, static_cast<std::size_t>(fraction * double(nodes.size())));
    const double weight = cellNodes_[tree][static_cast<std::size_t>(nodes[i].cell)] +
                          2.0 * nodes[i].tries * nodes[i].tries;
    if (weight >= least) continue;
    least = weight;
    best = static_cast<int>(i);
  }
  ++trees_[tree][static_cast<std::size_t>(best)].tries;
  return best;
}

State TwoTrees::sample() {
  const Vector3d middle = random_.inBox(space_.low, space_.high);
  if (!space_.turns()) return scene_.at(space_.upright, middle);
  return limited(scene_.at(space_.upright, middle), scene_.at(random_.rotation(), middle));
}

State TwoTrees::sampleNear(int tree, int node) {
  const State& state = trees_[tree][static_cast<std::size_t>(node)].state;
  const double scale = scene_.radius() * std::pow(10.0, random_.between(-2, 0.5));
  Twist twist;
  if (random_.fraction() < 0.4) {
    // Continue in the direction of the moves that led to this node.
    int before = node;
    for (int k = 0; k < 6; ++k) {
      const int parent = trees_[tree][static_cast<std::size_t>(before)].parent;
      if (parent < 0) break;
      before = parent;
    }
    twist = Scene::between(trees_[tree][static_cast<std::size_t>(before)].state, state);
    const double length = scene_.length(twist);
    if (length > 0) twist = twist * (scale / length);
  }
  const double noise = scene_.length(twist) > 0 ? 0.3 * scale : scale;
  // Adds noise. A third of the samples get only a shift, a third only a turn, and a third both.
  const double kind = random_.fraction();
  if (kind < 0.67 || !space_.turns())
    twist.shift += noise * random_.fraction() * random_.direction();
  if (kind > 0.33 && space_.turns())
    twist.turn += noise / scene_.radius() * random_.fraction() * random_.direction();
  return limited(state, scene_.moved(state, twist));
}

// Returns `to`, with its turn from upright reduced to the largest turn allowed.
State TwoTrees::limited(const State& from, const State& to) const {
  if (!space_.turns()) return scene_.at(from.pose.rotation, to.middle);
  const State upright = scene_.at(space_.upright, to.middle);
  Twist turn = Scene::between(upright, to);
  const double angle = turn.turn.norm();
  if (angle <= space_.largestTurn) return to;
  return scene_.moved(upright, turn * (0.999 * space_.largestTurn / angle));
}

int TwoTrees::extend(int tree, int from, const State& to, double most, bool& reached) {
  const double whole = scene_.distance(trees_[tree][static_cast<std::size_t>(from)].state, to);
  reached = !(whole > 0);
  if (reached) return from;
  const double step = std::min(most, whole);
  return slide(tree, from, {&to, {}, step, step, kSlides}, reached);
}

int TwoTrees::push(int tree, int from) {
  const Twist drive = randomDrive(trees_[tree][static_cast<std::size_t>(from)].state);
  const double step = scene_.radius() * std::pow(10.0, random_.between(-1.5, -0.5));
  bool reached = false;
  return slide(tree, from, {nullptr, drive, step, kMaxPush * scene_.radius(), kPushes}, reached);
}

// Returns a move along or about an axis of the world, an axis of the part, or a random direction.
// The twist is longer than any push.
Twist TwoTrees::randomDrive(const State& at) {
  const double kind = random_.fraction();
  Vector3d d = random_.direction();
  if (kind < 0.8) {
    d = Vector3d::Unit(static_cast<int>(random_.index(3)));
    if (kind < 0.4) d = at.pose.rotation * d;
    if (random_.fraction() < 0.5) d = -d;
  }
  const double far = 2 * kMaxPush;
  if (space_.turns() && random_.fraction() < 0.5) return {Vector3d::Zero(), far * d};
  return {far * scene_.radius() * d, Vector3d::Zero()};
}

int TwoTrees::slide(int tree, int from, const Drive& drive, bool& reached) {
  State at = trees_[tree][static_cast<std::size_t>(from)].state;
  Touches touches = trees_[tree][static_cast<std::size_t>(from)].touches;
  const double radius = scene_.radius();
  double step = drive.step, left = drive.most;
  int node = from;
  for (int k = 0; k < drive.moves && left > 0; ++k) {
    const Twist whole = drive.to != nullptr ? Scene::between(at, *drive.to) : drive.twist;
    const double wanted = scene_.length(whole);
    const double length = (1 + 1e-6) * std::min(step, left);
    const Twist requested = wanted <= length ? whole : whole * (length / wanted);
    const Twist allowed = allowedMove(scene_, at, rule_, touches, requested);
    // The allowed move must still lead in the wanted direction.
    const double progress =
        allowed.shift.dot(requested.shift) + radius * radius * allowed.turn.dot(requested.turn);
    const double most = scene_.length(requested);
    if (!(progress >= kStepBeyond * most * most) || scene_.length(allowed) > 3 * most) break;
    const Twist difference{allowed.shift - requested.shift, allowed.turn - requested.turn};
    const bool last =
        drive.to != nullptr && wanted <= length && scene_.length(difference) <= kMaxRounding * most;
    const State next = last ? *drive.to : limited(at, scene_.moved(at, allowed));
    const Follow follow = scene_.follow(at, next, rule_, memory_, kFinest);
    const double travelled = follow.fraction * scene_.distance(at, next);
    if (travelled > shortest_) {
      at = follow.fraction >= 1 ? next : scene_.stateBetween(at, next, follow.fraction);
      left -= travelled;
      dropFar(scene_, at, rule_, drive.step, touches);
      node = add(tree, node, at);
      trees_[tree][static_cast<std::size_t>(node)].touches = touches;
      reached = last && follow.fraction >= 1;
      if (reached || !path_.empty()) break;
    }
    if (follow.fraction >= 1) {
      step = std::min(drive.step, 2 * step);
    } else {
      if (follow.neighbour < 0) break;
      const bool isNew = addTouch(memory_, follow.neighbour, touches);
      if (isNew || follow.fraction > 0.3) continue;
      step *= 0.5;
      if (step < kStepBeyond * drive.step) break;
    }
  }
  return node;
}

bool TwoTrees::connect(int tree, int node) {
  const int other = 1 - tree;
  const State to = trees_[tree][static_cast<std::size_t>(node)].state;
  int at = nearest(other, to);
  for (int k = 0; k < 12; ++k) {
    bool reached = false;
    const int next = extend(other, at, to, longest_, reached);
    if (!path_.empty()) return true;
    if (reached) {
      finish(tree == kStart ? node : next, tree == kStart ? next : node);
      return true;
    }
    const double before = scene_.distance(trees_[other][static_cast<std::size_t>(at)].state, to);
    const double now = scene_.distance(trees_[other][static_cast<std::size_t>(next)].state, to);
    if (next == at || now > before - 0.02 * longest_) return false;
    at = next;
  }
  return false;
}

void TwoTrees::finish(int startNode, int goalNode) {
  path_.clear();
  for (int i = startNode; i >= 0; i = trees_[kStart][static_cast<std::size_t>(i)].parent)
    path_.push_back(trees_[kStart][static_cast<std::size_t>(i)].state);
  std::reverse(path_.begin(), path_.end());
  for (int i = goalNode; i >= 0; i = trees_[kGoal][static_cast<std::size_t>(i)].parent) {
    const State& state = trees_[kGoal][static_cast<std::size_t>(i)].state;
    if (path_.empty() || scene_.distance(path_.back(), state) > 0) path_.push_back(state);
  }
}

// The tree with more blocked moves gets more of the rounds.
int TwoTrees::chooseTree() {
  if (trees_[kStart].empty()) return kGoal;
  const double fraction = hardness_[kGoal] / (hardness_[kGoal] + hardness_[kStart]);
  return random_.fraction() < std::clamp(fraction, 0.1, 0.9) ? kGoal : kStart;
}

bool TwoTrees::grow(int rounds) {
  for (int round = 0; round < rounds && path_.empty(); ++round) {
    const int tree = chooseTree();
    const double kind = random_.fraction();
    int from;
    State to;
    if (kind < 0.15 && !trees_[1 - tree].empty()) {
      to = trees_[1 - tree][random_.index(trees_[1 - tree].size())].state;
      from = nearest(tree, to);
    } else if (kind < 0.3) {
      to = sample();
      from = nearest(tree, to);
    } else {
      from = sparse(tree);
      to = sampleNear(tree, from);
    }
    if (random_.fraction() < kPushFraction) {
      const int end = push(tree, sparse(tree));
      if (!path_.empty()) break;
      if (!trees_[1 - tree].empty() && connect(tree, end)) break;
      continue;
    }
    bool reached = false;
    const auto before = trees_[tree][static_cast<std::size_t>(from)].state;
    const int node = extend(tree, from, to, longest_, reached);
    if (!path_.empty()) break;
    const double wanted = std::min(longest_, scene_.distance(before, to));
    const double travelled =
        scene_.distance(before, trees_[tree][static_cast<std::size_t>(node)].state);
    hardness_[tree] += 0.02 * ((travelled < 0.9 * wanted ? 1 : 0.05) - hardness_[tree]);
    if (node == from) continue;
    if (!trees_[1 - tree].empty() && connect(tree, node)) break;
  }
  return !path_.empty();
}

}  // namespace swept::path
