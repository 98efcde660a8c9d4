// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/imprint.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "geometry/half_edges.h"
#include "geometry/triangle_distance.h"

namespace swept::step {

using Eigen::Vector3d;

Imprint::Imprint(const HalfEdgeMesh& mesh, double snap)
    : snap_(snap),
      nearest_(mesh.points, mesh.triangles),
      on_(mesh.points),
      points_(mesh.points),
      triangles_(mesh.triangles),
      opposite_(mesh.opposite),
      firstOf_(mesh.points.size(), -1),
      parts_(mesh.triangles.size()),
      isTaken_(mesh.points.size(), 0) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    rootOf_.push_back(static_cast<std::int32_t>(t));
    parts_[t].push_back(static_cast<std::int32_t>(t));
    for (int k = 0; k < 3; ++k) firstOf_[triangles_[t][k]] = static_cast<Corner>(3 * t + k);
  }
}

std::optional<std::int32_t> Imprint::insert(const Vector3d& p) {
  std::int32_t root = -1;
  nearest_.query(p, HUGE_VAL, 0, root);
  std::int32_t best = -1;
  double least = HUGE_VAL;
  for (const std::int32_t t : parts_[root]) {
    const auto& [a, b, c] = triangles_[t];
    const double squared = squaredDistance(p, on_[a], on_[b], on_[c]);
    if (squared < least) {
      least = squared;
      best = t;
    }
  }
  const auto& corners = triangles_[best];
  const Vector3d foot = footOnTriangle(p, on_[corners[0]], on_[corners[1]], on_[corners[2]]).point;
  const auto take = [&](std::int32_t v) {
    isTaken_[v] = 1;
    points_[v] = p;
    return v;
  };
  for (const std::int32_t v : corners) {
    if (!isTaken_[v] && (foot - on_[v]).norm() <= snap_) return take(v);
    if (foot == on_[v]) return std::nullopt;
  }
  // An edge that is much nearer than the corners is cut.
  constexpr double kNearEdge = 0.02;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t a = corners[k], b = corners[(k + 1) % 3];
    const Vector3d along = on_[b] - on_[a];
    const double at = (foot - on_[a]).dot(along) / along.squaredNorm();
    const double off = (foot - on_[a] - at * along).norm();
    if (at <= 0 || at >= 1 || off > kNearEdge * std::min(at, 1 - at) * along.norm()) continue;
    stoppedBy_ = ownerOf(a, b);
    if (stoppedBy_ >= 0) return std::nullopt;
    return take(splitEdge(3 * best + k, foot));
  }
  return take(splitTriangle(best, foot));
}

std::vector<std::int32_t> Imprint::connect(std::int32_t from, std::int32_t to, int owner) {
  constexpr int kMaxSteps = 20000;
  stoppedBy_ = -1;
  std::vector<std::int32_t> path{from};
  const Vector3d along = on_[to] - on_[from];
  const Vector3d across = along.cross(normalAt(from) + normalAt(to));
  const auto isNextTo = [&](std::int32_t a, std::int32_t b) {
    bool isFound = false;
    around(a, [&](Corner h) { return isFound = target(h) == b; });
    return isFound;
  };
  bool isWhole = false;
  if (across.squaredNorm() > 0) {
    for (int i = 0; i < kMaxSteps && !isWhole; ++i) {
      if (isNextTo(path.back(), to)) {
        path.push_back(to);
        isWhole = true;
        break;
      }
      const auto next = step(path.back(), to, along, across);
      if (!next) break;
      isTaken_[*next] = 1;
      path.push_back(*next);
    }
  }
  if (!isWhole) {
    for (std::size_t i = 1; i < path.size(); ++i) isTaken_[path[i]] = path[i] == to;
    path = shortestPath(from, to);
    if (path.empty()) return {};
    for (const std::int32_t v : path) isTaken_[v] = 1;
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto [place, isNew] = owners_.try_emplace(edgeKey(path[i], path[i + 1]), owner);
    if (isNew) continue;
    stoppedBy_ = place->second;
    return {};
  }
  return path;
}

std::optional<std::int32_t> Imprint::step(std::int32_t at, std::int32_t to, const Vector3d& along,
                                          const Vector3d& across) {
  const Vector3d end = on_[to];
  Corner best = -1;
  Vector3d crossing = Vector3d::Zero();
  double bestAdvance = 0;
  around(at, [&](Corner h) {
    const std::int32_t p = target(h), q = target(nextHalfEdge(h));
    const double sideP = (on_[p] - end).dot(across), sideQ = (on_[q] - end).dot(across);
    if (sideP * sideQ > 0 || sideP == sideQ) return false;
    const Vector3d x = on_[p] + sideP / (sideP - sideQ) * (on_[q] - on_[p]);
    const double length = (x - on_[at]).norm();
    const double advance = length > 0 ? (x - on_[at]).dot(along) / length : 0;
    if (advance > bestAdvance) {
      bestAdvance = advance;
      best = nextHalfEdge(h);
      crossing = x;
    }
    return false;
  });
  if (best < 0) return std::nullopt;
  const std::int32_t p = origin(best), q = target(best);
  for (const std::int32_t v : {p, q}) {
    if (isTaken_[v] || (on_[v] - crossing).norm() > snap_) continue;
    return v;
  }
  stoppedBy_ = ownerOf(p, q);
  if (stoppedBy_ >= 0) return std::nullopt;
  return splitEdge(best, crossing);
}

std::vector<std::int32_t> Imprint::shortestPath(std::int32_t from, std::int32_t to) const {
  constexpr std::size_t kMaxVisited = 3000;
  constexpr double kDetour = 3;  // times the distance
  const double longest = kDetour * (on_[to] - on_[from]).norm() + snap_;
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::unordered_map<std::int32_t, std::pair<double, std::int32_t>> best;
  queue.emplace(0.0, from);
  best[from] = {0.0, -1};
  while (!queue.empty() && best.size() < kMaxVisited) {
    const double length = queue.top().first;
    const std::int32_t v = queue.top().second;
    queue.pop();
    if (v == to) break;
    if (length > best[v].first) continue;
    around(v, [&](Corner h) {
      const std::int32_t w = target(h);
      if ((isTaken_[w] && w != to) || owners_.count(edgeKey(v, w)) > 0) return false;
      const double total = length + (on_[w] - on_[v]).norm();
      const auto known = best.find(w);
      if (total > longest || (known != best.end() && known->second.first <= total)) return false;
      best[w] = {total, v};
      queue.emplace(total, w);
      return false;
    });
  }
  if (best.count(to) == 0) return {};
  std::vector<std::int32_t> path;
  for (std::int32_t v = to; v >= 0; v = best[v].second) path.push_back(v);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<std::int32_t> Imprint::regions() const {
  std::vector<std::int32_t> region(triangles_.size(), -1), reached;
  std::int32_t count = 0;
  for (std::size_t first = 0; first < triangles_.size(); ++first) {
    if (region[first] >= 0) continue;
    region[first] = count;
    reached.assign(1, static_cast<std::int32_t>(first));
    while (!reached.empty()) {
      const std::int32_t t = reached.back();
      reached.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Corner h = 3 * t + k;
        const std::int32_t other = opposite_[h] / 3;
        if (region[other] >= 0 || ownerOf(origin(h), target(h)) >= 0) continue;
        region[other] = count;
        reached.push_back(other);
      }
    }
    ++count;
  }
  return region;
}

std::int32_t Imprint::triangleBeside(std::int32_t from, std::int32_t to) const {
  std::int32_t found = -1;
  around(from, [&](Corner h) {
    if (target(h) == to) found = h / 3;
    return found >= 0;
  });
  return found;
}

int Imprint::ownerOf(std::int32_t a, std::int32_t b) const {
  const auto owner = owners_.find(edgeKey(a, b));
  return owner == owners_.end() ? -1 : owner->second;
}

template <class Use>
void Imprint::around(std::int32_t vertex, const Use& use) const {
  const Corner first = firstOf_[vertex];
  Corner h = first;
  do {
    if (use(h)) return;
    h = opposite_[previousHalfEdge(h)];
  } while (h != first);
}

Vector3d Imprint::normalAt(std::int32_t vertex) const {
  Vector3d sum = Vector3d::Zero();
  around(vertex, [&](Corner h) {
    const Vector3d p = on_[target(h)] - on_[vertex], q = on_[target(nextHalfEdge(h))] - on_[vertex];
    const Vector3d area = p.cross(q);
    const double lengths = p.norm() * q.norm();
    if (lengths > 0) sum += area / lengths;
    return false;
  });
  return sum.norm() > 0 ? Vector3d(sum.normalized()) : sum;
}

std::int32_t Imprint::addVertex(const Vector3d& p) {
  on_.push_back(p);
  points_.push_back(p);
  firstOf_.push_back(-1);
  isTaken_.push_back(0);
  return static_cast<std::int32_t>(on_.size()) - 1;
}

std::int32_t Imprint::addTriangle(std::int32_t root) {
  const auto t = static_cast<std::int32_t>(triangles_.size());
  triangles_.push_back({-1, -1, -1});
  opposite_.resize(opposite_.size() + 3, -1);
  rootOf_.push_back(root);
  parts_[root].push_back(t);
  return t;
}

void Imprint::link(Corner a, Corner b) {
  opposite_[a] = b;
  opposite_[b] = a;
}

void Imprint::setTriangle(std::int32_t t, std::int32_t a, std::int32_t b, std::int32_t c) {
  triangles_[t] = {a, b, c};
  for (int k = 0; k < 3; ++k) firstOf_[triangles_[t][k]] = 3 * t + k;
}

std::int32_t Imprint::splitTriangle(std::int32_t t, const Vector3d& p) {
  const auto [a, b, c] = triangles_[t];
  const Corner ab = opposite_[3 * t], bc = opposite_[3 * t + 1], ca = opposite_[3 * t + 2];
  const std::int32_t v = addVertex(p), r = addTriangle(rootOf_[t]), s = addTriangle(rootOf_[t]);
  setTriangle(t, a, b, v);
  setTriangle(r, b, c, v);
  setTriangle(s, c, a, v);
  link(3 * t, ab);
  link(3 * r, bc);
  link(3 * s, ca);
  link(3 * t + 1, 3 * r + 2);
  link(3 * r + 1, 3 * s + 2);
  link(3 * s + 1, 3 * t + 2);
  return v;
}

std::int32_t Imprint::splitEdge(Corner h, const Vector3d& p) {
  const Corner g = opposite_[h];
  const std::int32_t t = h / 3, s = g / 3;
  const std::int32_t a = origin(h), b = target(h), c = target(nextHalfEdge(h)),
                     d = target(nextHalfEdge(g));
  const Corner bc = opposite_[nextHalfEdge(h)], ca = opposite_[previousHalfEdge(h)],
               ad = opposite_[nextHalfEdge(g)], db = opposite_[previousHalfEdge(g)];
  const std::int32_t v = addVertex(p), t1 = addTriangle(rootOf_[t]), s1 = addTriangle(rootOf_[s]);
  setTriangle(t, a, v, c);
  setTriangle(t1, v, b, c);
  setTriangle(s, b, v, d);
  setTriangle(s1, v, a, d);
  link(3 * t + 2, ca);
  link(3 * t1 + 1, bc);
  link(3 * s + 2, db);
  link(3 * s1 + 1, ad);
  link(3 * t, 3 * s1);
  link(3 * t1, 3 * s);
  link(3 * t + 1, 3 * t1 + 2);
  link(3 * s + 1, 3 * s1 + 2);
  return v;
}

}  // namespace swept::step
