// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/penetration.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include "clearance/depth_pieces.h"

namespace swept::clearance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kNoBound = std::numeric_limits<double>::infinity();
/// Some point of a piece probably lies deeper than the centre of the piece. The difference is about
/// this fraction of the sum of the piece's radius and the reach of its motion.
constexpr double kPromise = 0.3;
// Largest number of connected pieces of a part from which the search starts.
constexpr std::size_t kMaxPieces = 1000;
constexpr std::size_t kPiecesPerRound = 64;  // pieces per round; fixed, see motion_search.cpp

struct PieceSearch {
  double bound = 0;    // mm, in this part of the motion no point of the piece lies deeper
  double promise = 0;  // mm, depth that some point is likely to reach
  std::int64_t number = 0;
  MotionNode motion;
  Piece piece;
  // mm, upper bound of the depth of all points of the piece minus the depth of its centre, both at
  // the representative pose
  double excess = 0;
  double radius = 0;
  double reach = 0;
};

// Order of the queue: first by promise, to find deep points; later by bound, to prove that no point
// is much deeper.
struct Before {
  bool byBound = false;
  bool operator()(const PieceSearch& a, const PieceSearch& b) const {
    const double x = byBound ? a.bound : a.promise;
    const double y = byBound ? b.bound : b.promise;
    return x != y ? x < y : a.number > b.number;
  }
};

class DepthSearch {
 public:
  DepthSearch(SearchContext& context, double tolerance, std::int64_t effort)
      : c_(context), tolerance_(tolerance), effort_(effort) {}

  PenetrationResult run(const Minimum& touch) {
    begin(touch);
    for (const Piece& piece : roots(c_.pair))
      fresh_.push_back(makeItem(c_.motion.root(), piece, kNoBound));
    examine();
    while (!queue_.empty() && spent_ < effort_) {
      c_.run.checkpoint(Phase::Check);
      if (!before_.byBound && 2 * spent_ > effort_) {
        before_.byBound = true;
        std::make_heap(queue_.begin(), queue_.end(), before_);
      }
      for (std::size_t i = 0; i < kPiecesPerRound && !queue_.empty(); ++i) {
        std::pop_heap(queue_.begin(), queue_.end(), before_);
        const PieceSearch item = std::move(queue_.back());
        queue_.pop_back();
        if (item.bound > best_.depth + allowed()) divide(item);
      }
      examine();
    }
    double bound = best_.depth + allowed();
    for (const PieceSearch& item : queue_) bound = std::max(bound, item.bound);
    if (!(best_.depth > 0)) {
      PenetrationResult none;
      none.depthBound = bound;
      return none;
    }
    best_.known = true;
    sharpen();
    best_.depthBound = std::max(bound, best_.depth);
    finish();
    return best_;
  }

 private:
  double allowed() const { return std::max(tolerance_, 0.01 * best_.depth); }

  // Returns a new item of the queue. `bound`: the bound of the item that is split.
  PieceSearch makeItem(const MotionNode& node, const Piece& piece, double bound) {
    PieceSearch item;
    item.bound = bound;
    item.number = number_++;
    item.motion = node;
    item.piece = piece;
    return item;
  }

  void divide(const PieceSearch& item) {
    const bool byMotion = c_.motion.splits(item.motion) && item.reach > item.excess;
    if (byMotion) {
      nodes_.clear();
      c_.motion.split(item.motion, nodes_);
      for (const MotionNode& node : nodes_)
        fresh_.push_back(makeItem(node, item.piece, item.bound));
    } else {
      pieces_.clear();
      cutPiece(c_.pair, item.piece, pieces_);
      for (const Piece& piece : pieces_) fresh_.push_back(makeItem(item.motion, piece, item.bound));
    }
  }

  void examine() {
    probes_.assign(fresh_.size(), {});
    tbb::parallel_for(std::size_t{0}, fresh_.size(), [&](std::size_t i) {
      if (c_.run.isCancelled()) return;
      PieceSearch& item = fresh_[i];
      const MotionBound b = c_.motion.bound(item.motion);
      probes_[i] = probe(c_.pair, b.R, b.t, item.piece);
      item.piece.near = probes_[i].near;
      item.radius = probes_[i].radius;
      item.reach = b.reach;
      item.excess = probes_[i].most - probes_[i].depth;
      item.bound = std::min(item.bound, probes_[i].most + item.reach);
      item.promise = probes_[i].depth + kPromise * (item.radius + item.reach);
    });
    c_.run.checkpoint(Phase::Check);
    spent_ += std::ssize(fresh_);
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
      if (probes_[i].surfaceDepth > best_.depth) {
        best_.depth = probes_[i].surfaceDepth;
        best_.point = probes_[i].surfacePoint;
        bestHasPiece_ = true;
        bestCorners_ = fresh_[i].piece.corners;
        bestSpan_ = fresh_[i].motion.to - fresh_[i].motion.from;
        best_.pointOfBody = fresh_[i].piece.ofBody;
        best_.parameter = c_.motion.bound(fresh_[i].motion).parameter;
      }
    }
    for (const PieceSearch& item : fresh_) {
      if (item.bound <= best_.depth + allowed()) continue;
      queue_.push_back(item);
      std::push_heap(queue_.begin(), queue_.end(), before_);
    }
    fresh_.clear();
  }

  double tryAt(double u, bool ofBody, const Vector3d& local);
  void refineTime(double u, double width, bool ofBody, const Vector3d& local);
  void begin(const Minimum& touch);
  void sharpen();
  void finish();
  void measureRegion(const Matrix3d& R, const Vector3d& t);

  SearchContext& c_;
  double tolerance_;
  std::int64_t effort_;
  std::int64_t spent_ = 0;
  std::int64_t number_ = 0;
  PenetrationResult best_;
  Triangle3d bestCorners_;  // piece of triangle with the deepest point, in its mesh's frame
  double bestSpan_ = 0;
  bool bestHasPiece_ = false;
  std::vector<PieceSearch> queue_;  // a heap, ordered by before_
  Before before_;
  std::vector<PieceSearch> fresh_;
  std::vector<Probe> probes_;
  std::vector<MotionNode> nodes_;
  std::vector<Piece> pieces_;
};

double DepthSearch::tryAt(double u, bool ofBody, const Vector3d& local) {
  const Part& other = ofBody ? c_.pair.neighbour() : c_.pair.body();
  if (!other.closed()) return -std::numeric_limits<double>::infinity();
  const Pose pose = c_.motion.poseAt(u);
  const Matrix3d R = pose.rotation.toRotationMatrix();
  const double depth = depthIn(c_.pair, R, pose.translation, ofBody, local);
  if (depth > best_.depth) {
    best_.depth = depth;
    best_.parameter = u;
    best_.pointOfBody = ofBody;
    best_.point = ofBody ? Vector3d(R * local + pose.translation) : local;
  }
  return depth;
}

// Improves the time at which a point is deepest, by a golden section search between the motion
// parameters u - width and u + width.
void DepthSearch::refineTime(double u, double width, bool ofBody, const Vector3d& local) {
  double low = std::max(0.0, u - width);
  double high = std::min(c_.motion.largestParameter(), u + width);
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) * 0.382;
    const double b = low + (high - low) * 0.618;
    if (tryAt(a, ofBody, local) >= tryAt(b, ofBody, local))
      high = b;
    else
      low = a;
  }
}

// Tests the first points at times around the time of the smallest distance: the corners of the
// nearest pair of triangles, and its nearest points.
void DepthSearch::begin(const Minimum& touch) {
  if (touch.inside) {  // one of these points lies inside
    const auto tryPieces = [&](bool ofBody, const Part& own) {
      const std::size_t count = std::min(own.pieces().size(), kMaxPieces);
      for (std::size_t i = 0; i < count; ++i) tryAt(touch.parameter, ofBody, own.pieces()[i]);
    };
    tryPieces(true, c_.pair.body());
    tryPieces(false, c_.pair.neighbour());
  }
  if (touch.at.pair.body < 0) return;
  const Pose pose = c_.motion.poseAt(touch.parameter);
  const Vector3d onBody = pose.rotation.conjugate() * (touch.at.onBody - pose.translation);
  const auto tryPoint = [&](bool ofBody, const Vector3d& local) {
    tryAt(touch.parameter, ofBody, local);
    if (!c_.motion.isContinuous()) return;
    for (const double width : {1.0, 0.05, 0.002}) refineTime(touch.parameter, width, ofBody, local);
  };
  tryPoint(true, onBody);
  tryPoint(false, touch.at.onNeighbour);
  for (const Vector3d& x : c_.pair.body().corners(touch.at.pair.body)) tryPoint(true, x);
  for (const Vector3d& x : c_.pair.neighbour().corners(touch.at.pair.neighbour)) tryPoint(false, x);
}

// Moves the deepest point to better corners of its piece and to a better time. The depth found
// never decreases.
void DepthSearch::sharpen() {
  if (!bestHasPiece_) return;
  const bool ofBody = best_.pointOfBody;
  Vector3d local = centroid(bestCorners_);
  double deepest = best_.depth;
  for (const Vector3d& corner : bestCorners_) {
    const double depth = tryAt(best_.parameter, ofBody, corner);
    if (depth > deepest) {
      deepest = depth;
      local = corner;
    }
  }
  if (c_.motion.isContinuous())
    refineTime(best_.parameter, bestSpan_ > 0 ? 4 * bestSpan_ : 1.0, ofBody, local);
}

void DepthSearch::finish() {
  best_.pose = c_.motion.poseAt(best_.parameter);
  best_.timeSeconds = best_.pose.timeSeconds;
  const Matrix3d R = best_.pose.rotation.toRotationMatrix();
  const Vector3d t = best_.pose.translation;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  best_.surface =
      best_.pointOfBody
          ? c_.pair.neighbour().nearest(best_.point, kFar).point
          : Vector3d(R * c_.pair.body().nearest(R.transpose() * (best_.point - t), kFar).point + t);
  measureRegion(R, t);
}

// Measures the box around the intersection of the surfaces and all vertices inside the other part.
// A node lies wholly outside the other part if its centre is farther outside than its radius.
void DepthSearch::measureRegion(const Matrix3d& R, const Vector3d& t) {
  Vector3d low = best_.point.cwiseMin(best_.surface);
  Vector3d high = best_.point.cwiseMax(best_.surface);
  const auto grow = [&](const Vector3d& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  };
  for (const LeafPair& pair : c_.pair.pairsWithin(R, t, 0, 200000)) {
    const NearestPoints p = c_.pair.leafDistance(R, t, pair);
    grow(p.a);
  }
  for (const Piece& root : roots(c_.pair)) {
    const Part& own = root.ofBody ? c_.pair.body() : c_.pair.neighbour();
    std::vector<BoxTree::Node> stack{own.tree().root()};
    while (!stack.empty()) {
      const BoxTree::Node node = stack.back();
      stack.pop_back();
      if (node.isItem()) {
        for (const Vector3d& x : own.corners(node.index)) {
          const Vector3d world = root.ofBody ? Vector3d(R * x + t) : x;
          // A point within the current box cannot enlarge it.
          if ((world.array() >= low.array()).all() && (world.array() <= high.array()).all())
            continue;
          if (depthIn(c_.pair, R, t, root.ofBody, x) > 0) grow(world);
        }
        continue;
      }
      const Box box = own.box(node);
      const Vector3d middle = root.ofBody ? Vector3d(R * box.centre + t) : box.centre;
      const Vector3d half = root.ofBody ? Vector3d(R.cwiseAbs() * box.half) : box.half;
      const bool nothingNew = ((middle - half).array() >= low.array()).all() &&
                              ((middle + half).array() <= high.array()).all();
      if (nothingNew) continue;
      if (depthIn(c_.pair, R, t, root.ofBody, box.centre) + box.half.norm() < 0) continue;
      for (std::uint32_t k = own.tree().children(node); k-- > 0;)
        stack.push_back(BoxTree::child(node, k));
    }
  }
  best_.regionMin = low;
  best_.regionMax = high;
}

}  // namespace

PenetrationResult deepestPenetration(SearchContext& context, const Minimum& touch, double tolerance,
                                     std::int64_t effort) {
  return DepthSearch(context, tolerance, effort).run(touch);
}

bool overlapsAtLeast(const PairSearch& pair, const Matrix3d& R, const Vector3d& t, double atLeast) {
  if (atLeast < 0) return true;
  struct Open {
    double promise;  // see PieceSearch::promise; one deep point suffices, so promising pieces come
                     // first
    Piece piece;
    bool operator<(const Open& other) const { return promise < other.promise; }
  };
  std::priority_queue<Open> queue;
  std::vector<Piece> fresh = roots(pair);
  for (int effort = 0; effort < 150;) {
    for (Piece& piece : fresh) {
      ++effort;
      const Probe p = probe(pair, R, t, piece);
      piece.near = p.near;
      if (p.surfaceDepth >= atLeast) return true;
      if (p.most > atLeast) queue.push({p.depth + kPromise * p.radius, piece});
    }
    if (queue.empty()) return false;
    const Piece next = queue.top().piece;
    queue.pop();
    fresh.clear();
    cutPiece(pair, next, fresh);
  }
  return false;
}

}  // namespace swept::clearance
