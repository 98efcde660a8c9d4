// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/motion_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

namespace swept::clearance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Nodes per round; fixed, so that results do not depend on threads.
constexpr std::size_t kNodesPerRound = 16;

struct QueuedNode {
  double key = 0;           // mm, lower bound of the distance in this node
  std::int64_t number = 0;  // order of creation; breaks ties
  MotionNode node;
  LeafPair hint;
  int level = 0;
};

// Returns the effort for a proof. Most proofs fail near the root, so the effort is small there. It
// doubles with each split.
std::int64_t effortAt(int level) { return std::int64_t{1000} << std::min(level, 11); }

struct Examined {
  bool finished = false;
  bool inside = false;
  double parameter = 0;
  double span = 0;
  PairDistance at;
  Certificate proof;
};

class MinimumSearch {
 public:
  MinimumSearch(SearchContext& context, double slack) : c_(context), slack_(slack) {}

  Minimum run() {
    seed();
    while (!queue_.empty() && !result_.inside && result_.distance > slack_) {
      c_.run.checkpoint(Phase::Check);
      round();
    }
    const bool apart = result_.found() && result_.distance > 0;
    if (apart && c_.motion.isContinuous()) polish();
    return result_;
  }

 private:
  void push(const MotionNode& node, double key, LeafPair hint, int level) {
    queue_.push({key, number_++, node, hint, level});
  }

  // Starts the queue with some nodes spread over the motion. Measures the distance at their
  // representative poses, which gives a first upper bound.
  void seed() {
    std::vector<MotionNode> nodes{c_.motion.root()};
    for (bool grown = true; grown && nodes.size() < 32;) {
      grown = false;
      std::vector<MotionNode> finer;
      for (const MotionNode& node : nodes) {
        if (c_.motion.splits(node)) {
          c_.motion.split(node, finer);
          grown = true;
        } else {
          finer.push_back(node);
        }
      }
      nodes.swap(finer);
    }
    result_.distance = c_.within;
    std::optional<double> overlapping;  // a parameter at which the solids overlap
    for (const MotionNode& node : nodes) {
      const MotionBound b = c_.motion.bound(node);
      const bool overlap = c_.pair.containedAt(b.R, b.t);
      // Here it only matters whether the surfaces intersect. If one part lies in the middle of the
      // other, all directions are about equally near, so a search for the exact distance would take
      // long.
      const double below =
          overlap ? std::min(contactDistance(), result_.distance) : result_.distance;
      const PairDistance d = c_.pair.distanceAt(b.R, b.t, below, result_.at.pair);
      ++c_.queries;
      if (overlap && !overlapping) overlapping = b.parameter;
      keepSmaller(d, b.parameter, node.to - node.from);
      push(node, overlap ? -b.reach : d.distance - b.reach, d.pair, 0);
    }
    if (overlapping && result_.distance > slack_) setInside(*overlapping);
  }

  /// Returns the smallest distance, in mm, at which surfaces count as apart.
  double contactDistance() const { return std::max(slack_, std::numeric_limits<double>::min()); }

  void setInside(double parameter) {
    result_.inside = true;
    result_.distance = 0;
    result_.parameter = parameter;
  }

  void keepSmaller(const PairDistance& d, double parameter, double span) {
    if (d.pair.body < 0 || d.distance >= result_.distance) return;
    result_.distance = d.distance;
    result_.parameter = parameter;
    result_.at = d;
    span_ = span;
  }

  Examined examine(const QueuedNode& item, double best) const {
    Examined e;
    const MotionBound b = c_.motion.bound(item.node);
    e.parameter = b.parameter;
    e.span = item.node.to - item.node.from;
    const bool last = b.reach <= slack_ || !c_.motion.splits(item.node);
    if (!last) {
      e.proof = c_.pair.certify(b, best - slack_, effortAt(item.level), item.hint);
      ++c_.certificates;
    }
    e.finished = last || e.proof.holds;
    if (!e.proof.holds) {
      const LeafPair hint = e.proof.obstacle.body >= 0 ? e.proof.obstacle : item.hint;
      e.at = c_.pair.distanceAt(b.R, b.t, best, hint);
      ++c_.queries;
    }
    if (e.finished && (e.proof.holds || e.at.distance > 0))
      e.inside = c_.pair.containedAt(b.R, b.t);
    return e;
  }

  void round() {
    batch_.clear();
    while (!queue_.empty() && batch_.size() < kNodesPerRound) {
      batch_.push_back(queue_.top());
      queue_.pop();
    }
    examined_.assign(batch_.size(), {});
    const double best = result_.distance;
    tbb::parallel_for(std::size_t{0}, batch_.size(), [&](std::size_t i) {
      if (!c_.run.isCancelled()) examined_[i] = examine(batch_[i], best);
    });
    c_.run.checkpoint(Phase::Check);
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const Examined& e = examined_[i];
      if (e.inside && !result_.inside) setInside(e.parameter);
      keepSmaller(e.at, e.parameter, e.span);
      if (e.finished) continue;
      children_.clear();
      c_.motion.split(batch_[i].node, children_);
      const bool known = e.proof.obstacle.body >= 0;
      for (const MotionNode& child : children_)
        push(child, known ? e.proof.estimate : batch_[i].key,
             known ? e.proof.obstacle : batch_[i].hint, batch_[i].level + 1);
    }
  }

  // Refines the time of the minimum by a golden section search around it. The distance found can
  // only decrease.
  void polish() {
    constexpr double kRatio = 0.6180339887498949;
    const double width = span_ > 0 ? span_ : 1.0;
    double low = std::max(0.0, result_.parameter - width);
    double high = std::min(c_.motion.largestParameter(), result_.parameter + width);
    const auto measure = [&](double u) {
      const Pose pose = c_.motion.poseAt(u);
      const PairDistance d = c_.pair.distanceAt(pose.rotation.toRotationMatrix(), pose.translation,
                                                kInfinity, result_.at.pair);
      ++c_.queries;
      keepSmaller(d, u, span_);
      return d.distance;
    };
    measure(low);  // finds a minimum at the very start or end of the motion exactly
    measure(high);
    double a = high - kRatio * (high - low);
    double b = low + kRatio * (high - low);
    double atA = measure(a);
    double atB = measure(b);
    for (int i = 0; i < 48 && high - low > 1e-10; ++i) {
      if (atA <= atB) {
        high = b;
        b = a;
        atB = atA;
        atA = measure(a = high - kRatio * (high - low));
      } else {
        low = a;
        a = b;
        atA = atB;
        atB = measure(b = low + kRatio * (high - low));
      }
    }
  }

  struct Later {
    bool operator()(const QueuedNode& a, const QueuedNode& b) const {
      return a.key != b.key ? a.key > b.key : a.number > b.number;
    }
  };

  SearchContext& c_;
  double slack_;
  Minimum result_;
  double span_ = 0;
  std::int64_t number_ = 0;
  std::priority_queue<QueuedNode, std::vector<QueuedNode>, Later> queue_;
  std::vector<QueuedNode> batch_;
  std::vector<Examined> examined_;
  std::vector<MotionNode> children_;
};

enum class Level { Clear, Below, Split };

struct LevelItem {
  MotionNode node;
  LeafPair hint;
  int level = 0;
  Level outcome = Level::Clear;
};

/// Returns an upper bound (mm) of the distance of these nearest points anywhere in the node. Along
/// the line between the points, the distance grows at most by the advance of the body's point.
/// Perpendicular to the line, it grows at most by the reach.
double largestDistance(const MotionBound& b, const PairDistance& d) {
  if (d.pair.body < 0 || d.distance <= 0) return d.distance + b.reach;
  const Eigen::Vector3d n = (d.onBody - d.onNeighbour) / d.distance;
  const Eigen::Vector3d point = b.R.transpose() * (d.onBody - b.t);
  const double along =
      std::max(d.distance + b.advance(n, point, Eigen::Vector3d::Zero()), b.reach - d.distance);
  return std::min(d.distance + b.reach, std::hypot(along, b.reach));
}

/// Returns whether the pair of triangles found last (`item.hint`) is nearer than the level
/// everywhere in the node.
bool hintIsBelow(const SearchContext& c, const LevelItem& item, const MotionBound& b,
                 double level) {
  // If the reach is at least the level, largestDistance() is never below the level.
  if (item.hint.body < 0 || b.reach >= level) return false;
  const NearestPoints p = c.pair.leafDistance(b.R, b.t, item.hint);
  return largestDistance(b, {std::sqrt(p.squared), item.hint, p.a, p.b}) < level;
}

void classify(SearchContext& c, LevelItem& item, double level, double resolution,
              const OverlapTest& overlaps) {
  const MotionBound b = c.motion.bound(item.node);
  const bool last = !c.motion.splits(item.node) || b.reach <= 0.5 * resolution;
  if (hintIsBelow(c, item, b, level)) {
    item.outcome = Level::Below;
    return;
  }
  Certificate proof;
  if (b.reach > 0) {
    proof = c.pair.certify(b, level, effortAt(item.level), item.hint);
    ++c.certificates;
  }
  if (proof.holds) {
    item.outcome = c.pair.containedAt(b.R, b.t) ? Level::Below : Level::Clear;
    return;
  }
  if (proof.obstacle.body >= 0) item.hint = proof.obstacle;
  if (last) {
    // The node is not split further. Without a proof, it counts as below the level if its reach is
    // positive. So spans may be too long, never too short.
    const bool below = b.reach > 0 || c.pair.anyNearerThan(b.R, b.t, level, item.hint).body >= 0 ||
                       c.pair.containedAt(b.R, b.t);
    item.outcome = below ? Level::Below : Level::Clear;
    return;
  }
  // The exact distance is not measured, because it costs more than the proofs for both halves. The
  // pair that prevented this proof will soon show that the parts are below the level.
  const bool below =
      hintIsBelow(c, item, b, level) || (b.reach >= level && overlaps(b.R, b.t, b.reach - level));
  item.outcome = below ? Level::Below : Level::Split;
}

}  // namespace

Minimum searchMinimum(SearchContext& context, double slack) {
  return MinimumSearch(context, slack).run();
}

std::vector<std::pair<double, double>> spansBelow(SearchContext& c, double level, double resolution,
                                                  const OverlapTest& overlaps) {
  std::vector<LevelItem> items{{c.motion.root(), {}, 0, Level::Clear}};
  std::vector<LevelItem> next;
  std::vector<std::pair<double, double>> spans;
  std::vector<MotionNode> children;
  std::vector<std::int32_t> members;
  while (!items.empty()) {
    constexpr std::size_t kChunk = 256;
    for (std::size_t first = 0; first < items.size(); first += kChunk) {
      const std::size_t last = std::min(items.size(), first + kChunk);
      c.run.checkpoint(Phase::Check);
      tbb::parallel_for(first, last, [&](std::size_t i) {
        if (!c.run.isCancelled()) classify(c, items[i], level, resolution, overlaps);
      });
    }
    c.run.checkpoint(Phase::Check);
    next.clear();
    for (const LevelItem& item : items) {
      if (item.outcome == Level::Split) {
        children.clear();
        c.motion.split(item.node, children);
        for (const MotionNode& child : children)
          next.push_back({child, item.hint, item.level + 1, {}});
      } else if (item.outcome == Level::Below) {
        members.clear();
        c.motion.listMembers(item.node, members);
        const bool whole = item.node.cluster >= 0 && c.motion.isContinuous();
        for (const std::int32_t m : members)
          spans.emplace_back(m + (whole ? 0.0 : item.node.from), m + (whole ? 1.0 : item.node.to));
      }
    }
    items.swap(next);
  }
  std::sort(spans.begin(), spans.end());
  const double join = c.motion.isContinuous() ? 0.0 : 1.0;  // adjacent poses form one span
  std::vector<std::pair<double, double>> joined;
  for (const auto& s : spans) {
    if (!joined.empty() && s.first <= joined.back().second + join)
      joined.back().second = std::max(joined.back().second, s.second);
    else
      joined.push_back(s);
  }
  return joined;
}

std::vector<std::pair<double, double>> sampleDistances(SearchContext& c, int samples,
                                                       double extra) {
  std::vector<double> parameters;
  const double largest = c.motion.largestParameter();
  const auto& poses = c.motion.poses();
  const double start = poses.front().timeSeconds;
  const double end = poses.back().timeSeconds;
  for (int i = 0; i < samples; ++i) {
    const double fraction = samples > 1 ? double(i) / (samples - 1) : 0.0;
    const double time = start + fraction * (end - start);
    const auto after = std::upper_bound(poses.begin(), poses.end(), time,
                                        [](double x, const Pose& p) { return x < p.timeSeconds; });
    const auto k = std::max<std::ptrdiff_t>(0, after - poses.begin() - 1);
    double u = double(k);
    if (c.motion.isContinuous() && k + 1 < std::ssize(poses))
      u += (time - poses[k].timeSeconds) / (poses[k + 1].timeSeconds - poses[k].timeSeconds);
    parameters.push_back(end > start ? std::min(u, largest) : std::round(fraction * largest));
  }
  if (samples > 0) parameters.push_back(extra);
  std::sort(parameters.begin(), parameters.end());
  parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
  std::vector<std::pair<double, double>> result(parameters.size());
  constexpr std::size_t kRun = 8;  // successive samples that pass on their nearest pair as a hint
  tbb::parallel_for(std::size_t{0}, (parameters.size() + kRun - 1) / kRun, [&](std::size_t r) {
    LeafPair hint;
    for (std::size_t i = r * kRun; i < std::min(parameters.size(), (r + 1) * kRun); ++i) {
      if (c.run.isCancelled()) return;
      const Pose pose = c.motion.poseAt(parameters[i]);
      const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
      if (c.pair.containedAt(R, pose.translation)) {
        result[i] = {parameters[i], 0.0};
        continue;
      }
      const PairDistance d = c.pair.distanceAt(R, pose.translation, c.within, hint);
      ++c.queries;
      hint = d.pair;
      result[i] = {parameters[i], d.distance};
    }
  });
  c.run.checkpoint(Phase::Check);
  return result;
}

}  // namespace swept::clearance
