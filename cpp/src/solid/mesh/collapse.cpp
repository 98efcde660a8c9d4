// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/collapse.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/nearest_triangle.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr double kNearFraction = 0.05;  // of the squared tolerance: near enough to look no further
constexpr double kFoldFraction = 0.1;  // of the tolerance: how far a border may pass over its patch

bool has(const std::array<std::int32_t, 3>& tri, std::int32_t v) {
  return tri[0] == v || tri[1] == v || tri[2] == v;
}

}  // namespace

void Collapser::work(const std::vector<std::int32_t>& vertices) {
  for (const std::int32_t v : vertices) pushAround(v, true);
  std::uint64_t steps = 0;
  const std::uint64_t total = 5 * vertices.size();
  while (!queue_.empty()) {
    if ((++steps & 2047U) == 0) run_.checkpoint(Phase::Export, std::min(steps, total), 8 * total);
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
    for (const std::int32_t w : state_.triangles[t]) {
      if (w != v) result.push_back(w);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
}

bool Collapser::isBorderEdge(std::int32_t a, std::int32_t b) const {
  bool open = false, patch = false;
  for (const std::int32_t t : state_.around[a]) {
    const auto& tri = state_.triangles[t];
    if (tri[0] != b && tri[1] != b && tri[2] != b) continue;
    (state_.label[t] < 0 ? open : patch) = true;
  }
  return open && patch;
}

bool Collapser::mayGo(std::int32_t from, std::int32_t to) const {
  if (state_.kind[from] == VertexKind::Free) return true;
  return state_.kind[from] == VertexKind::Border && state_.kind[to] != VertexKind::Free &&
         isBorderEdge(from, to);
}

Vector3d Collapser::placeFor(std::int32_t from, std::int32_t to) const {
  if (state_.kind[from] != VertexKind::Free || state_.kind[to] != VertexKind::Free)
    return state_.points[to];
  const PlaneQuadric q = state_.quadric[from] + state_.quadric[to];
  Eigen::Matrix3d a = q.a;
  a.diagonal().array() += 1e-6 * q.a.trace();
  const Vector3d middle = 0.5 * (state_.points[from] + state_.points[to]);
  const Vector3d best = middle + a.ldlt().solve(-q.b - q.a * middle);
  const double length = (state_.points[from] - state_.points[to]).norm();
  return best.allFinite() && (best - middle).norm() <= 2 * length ? best : middle;
}

void Collapser::push(std::int32_t a, std::int32_t b) {
  if (!isMine(a) || !isMine(b)) return;
  if (!mayGo(a, b)) {
    if (!mayGo(b, a)) return;
    std::swap(a, b);
  } else if (state_.kind[a] == VertexKind::Free && state_.kind[b] == VertexKind::Free && b < a) {
    std::swap(a, b);
  }
  const Vector3d place = placeFor(a, b);
  const PlaneQuadric q = state_.quadric[a] + state_.quadric[b];
  // The small length term makes flat regions collapse evenly.
  const double cost = std::max(0.0, q.at(place)) +
                      1e-9 * q.a.trace() * (state_.points[a] - state_.points[b]).squaredNorm();
  queue_.push({cost, a, b, state_.stamp[a], state_.stamp[b]});
}

void Collapser::pushAround(std::int32_t v, bool once) {
  neighbours(v, ring_);
  for (const std::int32_t w : ring_) {
    if (!once || v < w) push(v, w);
  }
}

bool Collapser::linkIsSimple(std::int32_t from, std::int32_t to) {
  neighbours(from, ring_);
  neighbours(to, otherRing_);
  common_.clear();
  std::set_intersection(ring_.begin(), ring_.end(), otherRing_.begin(), otherRing_.end(),
                        std::back_inserter(common_));
  if (common_.size() != 2) return false;
  // A tetrahedron would fold flat.
  return state_.around[from].size() > 3 || state_.around[to].size() > 3;
}

void Collapser::collapse(std::int32_t from, std::int32_t to) {
  if (!mayGo(from, to) || !linkIsSimple(from, to) || !borderHolds(from, to)) return;
  const Vector3d best = placeFor(from, to);
  if (tryCollapse(from, to, best)) return;
  // Where the quadrics' place leaves a point too far off, another may not.
  if (state_.kind[from] != VertexKind::Free || state_.kind[to] != VertexKind::Free) return;
  const Vector3d middle = 0.5 * (state_.points[from] + state_.points[to]);
  for (const Vector3d& place :
       {state_.points[to], state_.points[from], middle, Vector3d(0.5 * (best + middle))}) {
    if (tryCollapse(from, to, place)) return;
  }
}

// The straight edge that a border gets stays within the tolerance of the patch's surface: where
// open ground rises beside it, the points of that ground do not see to it.
bool Collapser::borderHolds(std::int32_t from, std::int32_t to) {
  if (state_.kind[from] != VertexKind::Border) return true;
  const Carrier* surface = nullptr;
  for (const std::int32_t t : state_.around[from]) {
    if (state_.label[t] >= 0) surface = &(*state_.patches)[state_.label[t]].surface;
  }
  if (surface == nullptr || surface->isPlanar()) return true;
  constexpr int kSteps = 4;
  for (const std::int32_t before : ring_) {
    if (before == to || !isBorderEdge(from, before)) continue;
    for (int i = 1; i < kSteps; ++i) {
      const double w = static_cast<double>(i) / kSteps;
      const Vector3d p = (1 - w) * state_.points[before] + w * state_.points[to];
      if (!(std::abs(surface->distance(p)) <= state_.tolerance)) return false;
    }
  }
  return true;
}

// Seen along the surface's normal.
bool Collapser::turnsOver(const std::array<Vector3d, 3>& next, const Carrier& surface) const {
  const Vector3d area = (next[1] - next[0]).cross(next[2] - next[0]);
  const double longest =
      std::sqrt(std::max({(next[1] - next[0]).squaredNorm(), (next[2] - next[1]).squaredNorm(),
                          (next[0] - next[2]).squaredNorm()}));
  const Vector3d normal = surface.normal((next[0] + next[1] + next[2]) / 3);
  return area.dot(normal) < -kFoldFraction * state_.tolerance * longest;
}

bool Collapser::tryCollapse(std::int32_t from, std::int32_t to, const Vector3d& place) {
  staying_.clear();
  dying_.clear();
  for (const std::int32_t v : {from, to}) {
    for (const std::int32_t t : state_.around[v]) {
      if (has(state_.triangles[t], from) && has(state_.triangles[t], to)) {
        if (v == from) dying_.push_back(t);
      } else if (v == from || place != state_.points[to]) {
        staying_.push_back(t);
      }
    }
  }
  // Two triangles of different kinds would fall on one another when the third corners agree.
  corners_.clear();
  for (const std::int32_t t : staying_) {
    std::array<Vector3d, 3> now, next;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t v = state_.triangles[t][k];
      now[k] = state_.points[v];
      next[k] = v == from || v == to ? place : state_.points[v];
    }
    corners_.push_back(next);
    if (state_.label[t] >= 0) {
      if (turnsOver(next, (*state_.patches)[state_.label[t]].surface)) return false;
      continue;
    }
    const Vector3d before = (now[1] - now[0]).cross(now[2] - now[0]);
    const Vector3d after = (next[1] - next[0]).cross(next[2] - next[0]);
    const double longest =
        std::max({(next[1] - next[0]).squaredNorm(), (next[2] - next[1]).squaredNorm(),
                  (next[0] - next[2]).squaredNorm()});
    if (!(after.norm() > 0.01 * longest)) return false;
    if (before.dot(after) < 0.3 * before.norm() * after.norm()) return false;
  }
  if (!reattach(from, to)) return false;
  apply(from, to, place);
  return true;
}

// Points that lie on the triangles about to change find a new one within the tolerance. Where
// such a point lay before is asked first, and if it is near enough there, no other.
bool Collapser::reattach(std::int32_t from, std::int32_t to) {
  moved_.clear();
  const double limit = state_.tolerance * state_.tolerance;
  if (!findHome(state_.points[from], -1, limit)) return false;
  if (state_.kind[to] == VertexKind::Free && !findHome(state_.points[to], -1, limit)) return false;
  for (const std::int32_t t : dying_) {
    if (state_.label[t] < 0 && !findHomes(t, -1, limit)) return false;
  }
  for (std::size_t k = 0; k < staying_.size(); ++k) {
    if (state_.label[staying_[k]] < 0 &&
        !findHomes(staying_[k], static_cast<std::int32_t>(k), limit))
      return false;
  }
  for (const std::int32_t t : staying_) state_.attached[t].clear();
  for (const std::int32_t t : dying_) state_.attached[t].clear();
  for (const auto& [p, k] : moved_) state_.attached[staying_[k]].push_back(p);
  return true;
}

bool Collapser::findHomes(std::int32_t triangle, std::int32_t before, double limit) {
  std::vector<Vector3d>& points = state_.attached[triangle];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (findHome(points[i], before, limit)) continue;
    // Most collapses are tried in vain: what has failed is asked first the next time.
    std::swap(points[i], points[0]);
    return false;
  }
  return true;
}

bool Collapser::findHome(const Vector3d& p, std::int32_t before, double limit) {
  double least = limit;
  std::int32_t home = -1;
  auto ask = [&](std::int32_t k) {
    const double d = squaredDistance(p, corners_[k][0], corners_[k][1], corners_[k][2]);
    if (d > least) return;
    least = d;
    home = k;
  };
  if (before >= 0) ask(before);
  for (std::int32_t k = 0;
       k < static_cast<std::int32_t>(staying_.size()) && least > kNearFraction * limit; ++k) {
    if (k != before && state_.label[staying_[k]] < 0) ask(k);
  }
  if (home >= 0) moved_.emplace_back(p, home);
  return home >= 0;
}

void Collapser::apply(std::int32_t from, std::int32_t to, const Vector3d& place) {
  for (const std::int32_t t : dying_) {
    state_.dead[t] = 1;
    for (const std::int32_t v : state_.triangles[t]) std::erase(state_.around[v], t);
  }
  for (const std::int32_t t : state_.around[from]) {
    for (std::int32_t& v : state_.triangles[t]) {
      if (v == from) v = to;
    }
    state_.around[to].push_back(t);
  }
  state_.around[from].clear();
  state_.gone[from] = 1;
  state_.points[to] = place;
  state_.quadric[to] = state_.quadric[from] + state_.quadric[to];
  ++state_.stamp[to];
  pushAround(to, false);
}

}  // namespace swept::step
