// SPDX-License-Identifier: LGPL-2.1-or-later
#include "decimate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "curve.h"
#include "simplify/nearest_triangle.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Points of long edges that are watched like vertices: their distance, in tolerances, and number.
constexpr double kWatchSpacing = 3;
constexpr int kMostWatched = 3;

struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  double c = 0;

  void addPlane(const Vector3d& normal, const Vector3d& point, double weight) {
    const double d = -normal.dot(point);
    a += weight * normal * normal.transpose();
    b += weight * d * normal;
    c += weight * d * d;
  }
  Quadric operator+(const Quadric& o) const { return {a + o.a, b + o.b, c + o.c}; }
  double at(const Vector3d& p) const { return p.dot(a * p) + 2 * b.dot(p) + c; }
};

struct Entry {
  double cost;
  std::int32_t from, to;  // `from` disappears into `to`
  std::uint32_t stampFrom, stampTo;
  bool operator<(const Entry& o) const {
    if (cost != o.cost) return cost > o.cost;
    return std::tie(from, to) > std::tie(o.from, o.to);
  }
};

class Decimator {
 public:
  Decimator(Decimated start, double tolerance, RunContext& run)
      : in_(std::move(start.mesh)),
        partition_(std::move(start.partition)),
        tolerance_(tolerance),
        run_(run),
        attached_(std::move(start.attached)),
        watched_(std::move(start.watched)) {}

  Decimated work() {
    prepare();
    for (std::size_t v = 0; v < points_.size(); ++v) pushAround(static_cast<std::int32_t>(v), true);
    std::uint64_t steps = 0;
    const std::uint64_t total = 5 * points_.size();
    while (!queue_.empty()) {
      if ((++steps & 2047U) == 0) run_.checkpoint(Phase::Export, std::min(steps, total), 8 * total);
      const Entry entry = queue_.top();
      queue_.pop();
      if (gone_[entry.from] || gone_[entry.to]) continue;
      if (stamp_[entry.from] != entry.stampFrom || stamp_[entry.to] != entry.stampTo) continue;
      collapse(entry.from, entry.to);
    }
    return result();
  }

 private:
  enum Kind : char { kFree, kBorder, kFixed };

  void prepare() {
    points_ = in_.points;
    triangles_ = in_.triangles;
    label_ = partition_.patchOf;
    const std::size_t count = points_.size();
    around_.resize(count);
    quadric_.resize(count);
    attached_.resize(triangles_.size());
    watched_.resize(triangles_.size(), 0);
    watchLongEdges();
    gone_.assign(count, 0);
    dead_.assign(triangles_.size(), 0);
    stamp_.assign(count, 0);
    kind_.assign(count, kFree);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Vector3d area = in_.areaVector(static_cast<std::int32_t>(t));
      const double twice = area.norm();
      for (const std::int32_t v : triangles_[t]) {
        around_[v].push_back(static_cast<std::int32_t>(t));
        if (twice > 0) quadric_[v].addPlane(area / twice, points_[v], twice);
      }
    }
    classify();
    putBordersOnSurfaces();
  }

  // Corners near the new triangles do not yet keep the inside of a long triangle near them.
  void watchLongEdges() {
    const double spacing = kWatchSpacing * tolerance_;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (label_[t] >= 0 || watched_[t]) continue;
      bool isLong = false;
      for (int k = 0; k < 3; ++k) {
        const Vector3d &a = points_[triangles_[t][k]], &b = points_[triangles_[t][(k + 1) % 3]];
        const auto between = std::min(kMostWatched, static_cast<int>((b - a).norm() / spacing));
        isLong = isLong || between > 0;
        const std::size_t h = 3 * t + k;
        if (static_cast<std::int32_t>(h) > in_.opposite[h] && label_[in_.opposite[h] / 3] < 0)
          continue;
        for (int i = 1; i <= between; ++i)
          attached_[t].push_back(a + (b - a) * (static_cast<double>(i) / (between + 1)));
      }
      if (!isLong) continue;
      const auto& tri = triangles_[t];
      attached_[t].push_back((points_[tri[0]] + points_[tri[1]] + points_[tri[2]]) / 3);
    }
  }

  // Facets beside a patch will end on its surface: counted from here, that is part of what they may
  // be off.
  void putBordersOnSurfaces() {
    std::vector<const Surface*> surfaces;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (kind_[v] == kFree) continue;
      surfaces.clear();
      std::int32_t open = -1;
      for (const std::int32_t t : around_[v]) {
        if (label_[t] < 0) {
          open = t;
          continue;
        }
        const Surface* surface = &partition_.patches[label_[t]].surface;
        if (std::find(surfaces.begin(), surfaces.end(), surface) == surfaces.end())
          surfaces.push_back(surface);
      }
      if (open < 0) continue;
      const Vector3d moved = meetingPoint(points_[v], surfaces);
      const double off = (moved - points_[v]).norm();
      if (off <= 1e-9 || !(off <= tolerance_)) continue;
      attached_[open].push_back(points_[v]);
      points_[v] = moved;
    }
  }

  // Border: exactly one patch and open ground around it, passed once. Fixed: anything more
  // involved.
  void classify() {
    std::vector<std::int32_t> borders(points_.size(), 0), patch(points_.size(), -1);
    std::vector<char> open(points_.size(), 0), several(points_.size(), 0);
    for (std::size_t h = 0; h < in_.opposite.size(); ++h) {
      const std::int32_t own = label_[h / 3], other = label_[in_.opposite[h] / 3];
      const std::int32_t v = in_.origin(static_cast<std::int32_t>(h));
      if (own != other) ++borders[v];
      if (own < 0) {
        open[v] = 1;
      } else {
        several[v] = several[v] || (patch[v] >= 0 && patch[v] != own);
        patch[v] = own;
      }
    }
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (patch[v] < 0) continue;
      kind_[v] = open[v] && !several[v] && borders[v] == 2 ? kBorder : kFixed;
    }
  }

  std::vector<std::int32_t> neighbours(std::int32_t v) const {
    std::vector<std::int32_t> result;
    for (const std::int32_t t : around_[v]) {
      for (const std::int32_t w : triangles_[t]) {
        if (w != v) result.push_back(w);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  bool isBorderEdge(std::int32_t a, std::int32_t b) const {
    bool open = false, patch = false;
    for (const std::int32_t t : around_[a]) {
      const auto& tri = triangles_[t];
      if (tri[0] != b && tri[1] != b && tri[2] != b) continue;
      (label_[t] < 0 ? open : patch) = true;
    }
    return open && patch;
  }

  bool mayGo(std::int32_t from, std::int32_t to) const {
    if (kind_[from] == kFree) return true;
    return kind_[from] == kBorder && kind_[to] != kFree && isBorderEdge(from, to);
  }

  Vector3d placeFor(std::int32_t from, std::int32_t to) const {
    if (kind_[from] != kFree || kind_[to] != kFree) return points_[to];
    const Quadric q = quadric_[from] + quadric_[to];
    Eigen::Matrix3d a = q.a;
    a.diagonal().array() += 1e-6 * q.a.trace();
    const Vector3d middle = 0.5 * (points_[from] + points_[to]);
    const Vector3d best = middle + a.ldlt().solve(-q.b - q.a * middle);
    const double length = (points_[from] - points_[to]).norm();
    return best.allFinite() && (best - middle).norm() <= 2 * length ? best : middle;
  }

  void push(std::int32_t a, std::int32_t b) {
    if (!mayGo(a, b)) {
      if (!mayGo(b, a)) return;
      std::swap(a, b);
    } else if (kind_[a] == kFree && kind_[b] == kFree && b < a) {
      std::swap(a, b);
    }
    const Vector3d place = placeFor(a, b);
    const Quadric q = quadric_[a] + quadric_[b];
    // The small length term makes flat regions collapse evenly.
    const double cost =
        std::max(0.0, q.at(place)) + 1e-9 * q.a.trace() * (points_[a] - points_[b]).squaredNorm();
    queue_.push({cost, a, b, stamp_[a], stamp_[b]});
  }

  void pushAround(std::int32_t v, bool once) {
    for (const std::int32_t w : neighbours(v)) {
      if (!once || v < w) push(v, w);
    }
  }

  bool linkIsSimple(std::int32_t from, std::int32_t to) const {
    const std::vector<std::int32_t> a = neighbours(from), b = neighbours(to);
    std::vector<std::int32_t> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != 2) return false;
    // A tetrahedron would fold flat.
    return around_[from].size() > 3 || around_[to].size() > 3;
  }

  static bool has(const std::array<std::int32_t, 3>& tri, std::int32_t v) {
    return tri[0] == v || tri[1] == v || tri[2] == v;
  }

  bool collapse(std::int32_t from, std::int32_t to) {
    if (!mayGo(from, to) || !linkIsSimple(from, to)) return false;
    const Vector3d place = placeFor(from, to);
    std::vector<std::int32_t> staying, dying;
    for (const std::int32_t v : {from, to}) {
      for (const std::int32_t t : around_[v]) {
        if (has(triangles_[t], from) && has(triangles_[t], to)) {
          if (v == from) dying.push_back(t);
        } else if (v == from || place != points_[to]) {
          staying.push_back(t);
        }
      }
    }
    // Two triangles of different kinds would fall on one another when the third corners agree.
    std::vector<std::array<Vector3d, 3>> corners;
    for (const std::int32_t t : staying) {
      std::array<Vector3d, 3> now, next;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = triangles_[t][k];
        now[k] = points_[v];
        next[k] = v == from || v == to ? place : points_[v];
      }
      corners.push_back(next);
      if (label_[t] >= 0) continue;
      const Vector3d before = (now[1] - now[0]).cross(now[2] - now[0]);
      const Vector3d after = (next[1] - next[0]).cross(next[2] - next[0]);
      const double longest =
          std::max({(next[1] - next[0]).squaredNorm(), (next[2] - next[1]).squaredNorm(),
                    (next[0] - next[2]).squaredNorm()});
      if (!(after.norm() > 0.01 * longest)) return false;
      if (before.dot(after) < 0.3 * before.norm() * after.norm()) return false;
    }
    if (!reattach(from, to, staying, dying, corners)) return false;
    apply(from, to, place, dying);
    return true;
  }

  // Points that lie on the triangles about to change find their nearest new one, within the
  // tolerance.
  bool reattach(std::int32_t from, std::int32_t to, const std::vector<std::int32_t>& staying,
                const std::vector<std::int32_t>& dying,
                const std::vector<std::array<Vector3d, 3>>& corners) {
    std::vector<Vector3d> moved{points_[from]};
    if (kind_[to] == kFree) moved.push_back(points_[to]);
    for (const auto* list : {&staying, &dying}) {
      for (const std::int32_t t : *list) {
        if (label_[t] < 0) moved.insert(moved.end(), attached_[t].begin(), attached_[t].end());
      }
    }
    std::vector<std::int32_t> home(moved.size(), -1);
    const double limit = tolerance_ * tolerance_;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      double least = limit;
      for (std::size_t k = 0; k < staying.size(); ++k) {
        if (label_[staying[k]] >= 0) continue;
        const double d = squaredDistance(moved[i], corners[k][0], corners[k][1], corners[k][2]);
        if (d > least) continue;
        least = d;
        home[i] = static_cast<std::int32_t>(k);
        if (d < 1e-4 * limit) break;
      }
      if (home[i] < 0) return false;
    }
    for (const std::int32_t t : staying) attached_[t].clear();
    for (const std::int32_t t : dying) attached_[t].clear();
    for (std::size_t i = 0; i < moved.size(); ++i) attached_[staying[home[i]]].push_back(moved[i]);
    return true;
  }

  void apply(std::int32_t from, std::int32_t to, const Vector3d& place,
             const std::vector<std::int32_t>& dying) {
    for (const std::int32_t t : dying) {
      dead_[t] = 1;
      for (const std::int32_t v : triangles_[t]) std::erase(around_[v], t);
    }
    for (const std::int32_t t : around_[from]) {
      for (std::int32_t& v : triangles_[t]) {
        if (v == from) v = to;
      }
      around_[to].push_back(t);
    }
    around_[from].clear();
    gone_[from] = 1;
    points_[to] = place;
    quadric_[to] = quadric_[from] + quadric_[to];
    ++stamp_[to];
    pushAround(to, false);
  }

  Decimated result() {
    TriMesh small;
    std::vector<std::int32_t> id(points_.size(), -1);
    Decimated out;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (dead_[t]) continue;
      for (const Vector3d& p : attached_[t]) {
        out.deviation = std::max(
            out.deviation, squaredDistance(p, points_[triangles_[t][0]], points_[triangles_[t][1]],
                                           points_[triangles_[t][2]]));
      }
      std::array<std::int32_t, 3> tri{};
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = triangles_[t][k];
        if (id[v] < 0) {
          id[v] = static_cast<std::int32_t>(small.vertices.size());
          small.vertices.push_back(points_[v]);
        }
        tri[k] = id[v];
      }
      small.triangles.push_back(tri);
      out.partition.patchOf.push_back(label_[t]);
      out.watched.push_back(label_[t] < 0);
      out.attached.push_back(std::move(attached_[t]));
    }
    out.deviation = std::sqrt(out.deviation);
    out.mesh = buildHalfEdges(small, run_);
    out.partition.patches = partition_.patches;
    out.partition.cuts = partition_.cuts;
    for (Patch& patch : out.partition.patches) patch.triangles.clear();
    for (std::size_t t = 0; t < out.partition.patchOf.size(); ++t) {
      const std::int32_t p = out.partition.patchOf[t];
      if (p >= 0) out.partition.patches[p].triangles.push_back(static_cast<std::int32_t>(t));
    }
    return out;
  }

  const HalfEdgeMesh in_;
  const Partition partition_;
  double tolerance_;
  RunContext& run_;
  std::vector<std::vector<Vector3d>>
      attached_;  // removed vertices, by the triangle nearest to them
  std::vector<char> watched_;
  std::vector<Vector3d> points_;
  std::vector<std::array<std::int32_t, 3>> triangles_;
  std::vector<std::int32_t> label_;
  std::vector<std::vector<std::int32_t>> around_;
  std::vector<Quadric> quadric_;
  std::vector<char> gone_, dead_, kind_;
  std::vector<std::uint32_t> stamp_;
  std::priority_queue<Entry> queue_;
};

}  // namespace

Decimated decimate(Decimated start, double tolerance, RunContext& run) {
  return Decimator(std::move(start), tolerance, run).work();
}

}  // namespace swept::step
