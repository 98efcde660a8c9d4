// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/collapser.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/spread_points.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

using Eigen::Vector3d;

// A search for a near triangle ends when the squared distance is at most this fraction of the
// squared tolerance.
constexpr double kNearFraction = 0.25;
// Fraction of the tolerance by which a border may pass over its patch.
constexpr double kFoldFraction = 0.1;
constexpr double kMinCosine = 0.2;  // a triangle may turn by less than 78 degrees
constexpr double kMinShape = 0.01;  // height / longest side of a new triangle
// Limit of the squared distance of sample points on new triangles from the original, as a fraction
// of the squared tolerance. The remaining fraction allows for the surface between the points.
constexpr double kNetFraction = 0.96;
// Weight of the squared edge length in the cost, to be multiplied by the squared tolerance. It
// makes flat regions collapse evenly.
constexpr double kLengthWeight = 1e-3;

double squaredLongest(const std::array<Vector3d, 3>& c) {
  return std::max(
      {(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()});
}

Vector3d areaOf(const std::array<Vector3d, 3>& c) { return (c[1] - c[0]).cross(c[2] - c[0]); }

}  // namespace

void Collapser::work() {
  for (const std::int32_t v : part_.vertices) pushAround(v, true);
  std::uint64_t steps = 0;
  const std::uint64_t total = 5 * part_.vertices.size();
  while (!queue_.empty()) {
    if ((++steps & 1023U) == 0) run_.checkpoint(state_.phase, std::min(steps, total), 8 * total);
    const Entry entry = queue_.top();
    queue_.pop();
    if (state_.gone[entry.from] || state_.gone[entry.to]) continue;
    if (state_.stamp[entry.from] != entry.stampFrom || state_.stamp[entry.to] != entry.stampTo)
      continue;
    collapse(entry.from, entry.to);
  }
}

void Collapser::neighbours(std::int32_t v, std::vector<std::int32_t>& result) const {
  result.clear();
  for (const std::int32_t t : state_.around[v]) {
    for (const std::int32_t w : state_.mesh.triangles[t]) {
      if (w != v) result.push_back(w);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
}

bool Collapser::isBorderEdge(std::int32_t a, std::int32_t b) const {
  bool open = false, patch = false;
  for (const std::int32_t t : state_.around[a]) {
    if (has(state_.mesh.triangles[t], b)) (state_.label[t] < 0 ? open : patch) = true;
  }
  return open && patch;
}

bool Collapser::mayMerge(std::int32_t from, std::int32_t to) const {
  if (isFree(from)) return true;
  return state_.kind[from] == VertexKind::Border && !isFree(to) && isBorderEdge(from, to);
}

Vector3d Collapser::bestPosition(std::int32_t from, std::int32_t to) const {
  if (!isFree(from) || !isFree(to)) return at(to);
  Quadric q = state_.quadric[from];
  q += state_.quadric[to];
  const Vector3d middle = 0.5 * (at(from) + at(to));
  const Vector3d best = state_.origin + q.dampedMinimiser(middle - state_.origin);
  const double length = (at(from) - at(to)).norm();
  return best.allFinite() && (best - middle).norm() <= 2 * length ? best : middle;
}

void Collapser::push(std::int32_t a, std::int32_t b) {
  if (!isMine(a) || !isMine(b)) return;
  if (!mayMerge(a, b)) {
    if (!mayMerge(b, a)) return;
    std::swap(a, b);
  } else if (isFree(a) && isFree(b) && b < a) {
    std::swap(a, b);
  }
  Quadric q = state_.quadric[a];
  q += state_.quadric[b];
  const double error = q.error(bestPosition(a, b) - state_.origin);
  const double square = state_.tolerance * state_.tolerance;
  // If even the mean squared distance from the planes is too large, the largest one is too large,
  // too.
  if (error > q.weight * square) return;
  const double cost = error + kLengthWeight * square * (at(a) - at(b)).squaredNorm();
  queue_.push({cost, a, b, state_.stamp[a], state_.stamp[b]});
}

void Collapser::pushAround(std::int32_t v, bool once) {
  neighbours(v, ring_);
  for (const std::int32_t w : ring_) {
    // With `once`, an edge with both ends in part_.vertices is put into the queue only from the end
    // with the smaller number.
    if (!once || v < w || !std::binary_search(part_.vertices.begin(), part_.vertices.end(), w))
      push(v, w);
  }
}

bool Collapser::linkIsSimple(std::int32_t from, std::int32_t to) {
  neighbours(from, ring_);
  neighbours(to, otherRing_);
  common_.clear();
  std::set_intersection(ring_.begin(), ring_.end(), otherRing_.begin(), otherRing_.end(),
                        std::back_inserter(common_));
  if (common_.size() != 2) return false;
  // The opposite vertices of both triangles lose one triangle each and must keep at least three.
  return state_.around[common_[0]].size() > 3 && state_.around[common_[1]].size() > 3;
}

void Collapser::collapse(std::int32_t from, std::int32_t to) {
  if (!mayMerge(from, to) || !linkIsSimple(from, to) || !borderStaysNear(from, to)) return;
  const Vector3d best = bestPosition(from, to);
  if (tryCollapse(from, to, best)) return;
  // The best position of the quadrics may leave a point too far from the surface. Then another
  // position may still work.
  if (!isFree(from) || !isFree(to)) return;
  const Vector3d middle = 0.5 * (at(from) + at(to));
  const Vector3d first = at(from), last = at(to), between = 0.5 * (best + middle);
  for (const Vector3d& position : {last, first, middle, between}) {
    if (tryCollapse(from, to, position)) return;
  }
}

// Checks that the new straight border edges stay within the tolerance of the patch's surface. The
// attached points alone cannot ensure this, because they may lie nearer to open ground that rises
// beside the border.
bool Collapser::borderStaysNear(std::int32_t from, std::int32_t to) {
  if (state_.kind[from] != VertexKind::Border) return true;
  const LabelSurface* surface = nullptr;
  for (const std::int32_t t : state_.around[from]) {
    if (state_.label[t] >= 0) surface = state_.surfaces[state_.label[t]].get();
  }
  if (surface == nullptr || surface->isPlanar()) return true;
  constexpr int kSteps = 4;
  for (const std::int32_t before : ring_) {
    if (before == to || !isBorderEdge(from, before)) continue;
    for (int i = 1; i < kSteps; ++i) {
      const double w = static_cast<double>(i) / kSteps;
      const Vector3d p = (1 - w) * at(before) + w * at(to);
      if (!(std::abs(surface->distance(p)) <= state_.tolerance)) return false;
    }
  }
  return true;
}

// Returns whether the triangle would face the other way: compares its normal with that of the
// surface.
bool Collapser::turnsOver(const std::array<Vector3d, 3>& next, const LabelSurface& surface) const {
  const Vector3d normal = surface.normal((next[0] + next[1] + next[2]) / 3);
  return areaOf(next).dot(normal) <
         -kFoldFraction * state_.tolerance * std::sqrt(squaredLongest(next));
}

bool Collapser::tryCollapse(std::int32_t from, std::int32_t to, const Vector3d& position) {
  if (!(position[part_.axis] >= part_.low && position[part_.axis] < part_.high)) return false;
  remaining_.clear();
  removed_.clear();
  for (const std::int32_t v : {from, to}) {
    for (const std::int32_t t : state_.around[v]) {
      if (has(state_.mesh.triangles[t], from) && has(state_.mesh.triangles[t], to)) {
        if (v == from) removed_.push_back(t);
      } else if (v == from || position != at(to)) {
        remaining_.push_back(t);
      }
    }
  }
  if (!hasGoodShapes(from, to, position) || !reattachAll(from, to)) return false;
  if (state_.original != nullptr && !staysNearOriginal(from, to, position)) return false;
  const Vector3d before = at(to);
  before_.clear();
  for (const std::int32_t t : remaining_) before_.push_back(state_.mesh.triangles[t]);
  moveCorners(from, to, position);
  if (intersectsOthers()) {
    state_.mesh.vertices[to] = before;
    for (std::size_t k = 0; k < remaining_.size(); ++k)
      state_.mesh.triangles[remaining_[k]] = before_[k];
    if (!std::all_of(hits_.begin(), hits_.end(),
                     [&](std::int32_t t) { return intersectedBefore(t); }))
      return false;
    moveCorners(from, to, position);
  }
  if (log_ != nullptr) log_->add(from, to, before, remaining_, before_, removed_);
  apply(from, to);
  return true;
}

bool Collapser::hasGoodShapes(std::int32_t from, std::int32_t to, const Vector3d& position) {
  corners_.clear();
  for (const std::int32_t t : remaining_) {
    std::array<Vector3d, 3> now, next;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t v = state_.mesh.triangles[t][k];
      now[k] = at(v);
      next[k] = v == from || v == to ? position : at(v);
    }
    corners_.push_back(next);
    if (state_.label[t] >= 0) {
      if (turnsOver(next, *state_.surfaces[state_.label[t]])) return false;
      continue;
    }
    const Vector3d before = areaOf(now), after = areaOf(next);
    const double area = after.norm();
    if (before.dot(after) < kMinCosine * before.norm() * area) return false;
    const double shape = area / squaredLongest(next);
    if (!(shape >= kMinShape || shape > before.norm() / squaredLongest(now))) return false;
  }
  return true;
}

// Finds a new triangle within the tolerance for each point that is attached to a changing triangle.
// Tries the old triangle of the point first, and ends the search if this triangle is near enough.
bool Collapser::reattachAll(std::int32_t from, std::int32_t to) {
  reattached_.clear();
  if (!reattach(at(from), -1)) return false;
  if (isFree(to) && !reattach(at(to), -1)) return false;
  for (const std::int32_t t : removed_) {
    if (state_.label[t] < 0 && !reattachPoints(t, -1)) return false;
  }
  for (std::size_t k = 0; k < remaining_.size(); ++k) {
    const bool open = state_.label[remaining_[k]] < 0;
    if (open && !reattachPoints(remaining_[k], static_cast<std::int32_t>(k))) return false;
  }
  return true;
}

bool Collapser::reattachPoints(std::int32_t triangle, std::int32_t before) {
  std::vector<Vector3d>& points = state_.attached[triangle];
  for (Vector3d& p : points) {
    if (reattach(p, before)) continue;
    // Most collapses fail. The point that failed moves to the front, so that the next attempt tests
    // it first.
    std::swap(p, points[0]);
    return false;
  }
  return true;
}

bool Collapser::reattach(const Vector3d& p, std::int32_t before) {
  const double limit = state_.tolerance * state_.tolerance;
  double least = limit;
  std::int32_t chosen = -1;
  auto test = [&](std::int32_t k) {
    const double d = squaredDistance(p, corners_[k][0], corners_[k][1], corners_[k][2]);
    if (d > least) return;
    least = d;
    chosen = k;
  };
  if (before >= 0) test(before);
  for (std::int32_t k = 0;
       k < static_cast<std::int32_t>(remaining_.size()) && least > kNearFraction * limit; ++k) {
    if (k != before && state_.label[remaining_[k]] < 0) test(k);
  }
  if (chosen >= 0) reattached_.emplace_back(p, chosen);
  return chosen >= 0;
}

bool Collapser::isNearOriginal(const Vector3d& p) {
  const double limit = kNetFraction * state_.tolerance * state_.tolerance;
  return state_.original->isNear(p, limit, nearest_);
}

// Returns the spacing (mm) of sample points. At folds: on the mesh of kWatchFolds (collapse.cpp),
// 332 triangles deviated too much after the first round with 3 tolerances, and 237 with 1.5.
double Collapser::spacingFor(Care care) const {
  constexpr double kFolded = 1.5, kDeviated = 0.5;  // tolerances
  if (care == Care::Deviated) return kDeviated * state_.tolerance;
  return (care == Care::Folded ? std::min(kFolded, state_.coarseness) : state_.coarseness) *
         state_.tolerance;
}

// Returns whether sample points on the new triangles lie near the original.
bool Collapser::staysNearOriginal(std::int32_t from, std::int32_t to, const Vector3d& position) {
  nearest_ = state_.nearby[to];
  if (isFree(from) && isFree(to) && !isNearOriginal(position)) return false;
  nearPosition_ = nearest_;
  const double spacing = spacingFor(std::max(state_.care[from], state_.care[to]));
  for (std::size_t k = 0; k < remaining_.size(); ++k) {
    if (state_.label[remaining_[k]] >= 0) continue;
    const auto& c = corners_[k];
    if (squaredLongest(c) <= spacing * spacing) continue;
    // The corners are known to be near the original. So they are not tested, but only give the hint
    // for the next search.
    const auto& v = state_.mesh.triangles[remaining_[k]];
    const bool far = spreadPoints(c[0], c[1], c[2], spacing, [&](const Vector3d& p) {
      for (int i = 0; i < 3; ++i) {
        if (p != c[i]) continue;
        const bool fresh = v[i] == from || v[i] == to;
        const std::int32_t hint = fresh ? nearPosition_ : state_.nearby[v[i]];
        if (hint >= 0) nearest_ = hint;
        return false;
      }
      return !isNearOriginal(p);
    });
    if (far) return false;
  }
  return true;
}

bool Collapser::intersect(std::int32_t triangle, std::int32_t other) const {
  const TriMesh& mesh = state_.mesh;
  if (state_.label[triangle] >= 0 && state_.label[triangle] == state_.label[other]) return false;
  return trianglesIntersectFast(mesh, triangle, other);
}

// Returns whether a remaining triangle intersects another triangle after its corners have moved.
// Collects the intersected triangles in hits_.
bool Collapser::intersectsOthers() {
  hits_.clear();
  around_.clear();
  MovingBoxes::Box all;
  for (const std::int32_t t : remaining_) all.extend(MovingBoxes::boxOf(state_.mesh, t));
  boxes_.forBox(all, [&](std::int32_t other, const MovingBoxes::Box& box) {
    if (std::find(removed_.begin(), removed_.end(), other) == removed_.end() &&
        std::find(remaining_.begin(), remaining_.end(), other) == remaining_.end())
      around_.emplace_back(other, box);
  });
  for (std::size_t k = 0; k < remaining_.size(); ++k) {
    const std::int32_t t = remaining_[k];
    const MovingBoxes::Box own = MovingBoxes::boxOf(state_.mesh, t);
    for (const auto& [other, box] : around_) {
      if (box.intersects(own) && intersect(t, other)) hits_.push_back(other);
    }
    for (std::size_t j = k + 1; j < remaining_.size(); ++j) {
      if (intersect(t, remaining_[j])) hits_.push_back(remaining_[j]);
    }
  }
  return !hits_.empty();
}

// Returns whether one of the changed triangles already intersected `other` before the step. Returns
// false if `other` is one of the remaining triangles.
bool Collapser::intersectedBefore(std::int32_t other) const {
  const auto intersects = [&](std::int32_t t) { return t == other || intersect(t, other); };
  if (std::find(remaining_.begin(), remaining_.end(), other) != remaining_.end()) return false;
  return std::any_of(remaining_.begin(), remaining_.end(), intersects) ||
         std::any_of(removed_.begin(), removed_.end(), intersects);
}

void Collapser::moveCorners(std::int32_t from, std::int32_t to, const Vector3d& position) {
  state_.mesh.vertices[to] = position;
  for (const std::int32_t t : remaining_) {
    for (std::int32_t& v : state_.mesh.triangles[t]) {
      if (v == from) v = to;
    }
  }
}

void Collapser::apply(std::int32_t from, std::int32_t to) {
  for (const std::int32_t t : remaining_) state_.attached[t].clear();
  for (const std::int32_t t : removed_) state_.attached[t].clear();
  for (const auto& [p, k] : reattached_) state_.attached[remaining_[k]].push_back(p);
  for (const std::int32_t t : removed_) {
    state_.dead[t] = 1;
    for (const std::int32_t v : state_.mesh.triangles[t]) std::erase(state_.around[v], t);
  }
  for (const std::int32_t t : remaining_) boxes_.grow(t);
  for (const std::int32_t t : removed_) boxes_.remove(t);
  std::vector<std::int32_t>& aroundTo = state_.around[to];
  aroundTo.insert(aroundTo.end(), state_.around[from].begin(), state_.around[from].end());
  state_.around[from].clear();
  state_.gone[from] = 1;
  state_.care[to] = std::max(state_.care[from], state_.care[to]);
  state_.nearby[to] = nearPosition_;
  state_.quadric[to] += state_.quadric[from];
  ++state_.stamp[to];
  pushAround(to, false);
}

}  // namespace swept
