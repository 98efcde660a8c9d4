// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/decimate.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"
#include "solid/carrier/curve.h"
#include "solid/mesh/collapse.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Points of long edges that are watched like vertices: their distance, in tolerances, and number.
constexpr double kWatchSpacing = 3;
constexpr int kMaxWatched = 3;
// Parts of a mesh that are worked on at the same time: fixed, so that the result does not depend on
// the number of threads.
constexpr std::int32_t kParts = 16;
constexpr std::size_t kWorthParts = 20000;  // triangles

class Decimator {
 public:
  Decimator(Decimated start, double tolerance, Effort effort, RunContext& run)
      : in_(std::move(start.mesh)),
        partition_(std::move(start.partition)),
        effort_(effort),
        run_(run),
        watched_(std::move(start.watched)) {
    state_.tolerance = tolerance;
    state_.patches = &partition_.patches;
    state_.attached = std::move(start.attached);
  }

  Decimated work() {
    prepare();
    if (state_.triangles.size() > kWorthParts) {
      const std::vector<std::vector<std::int32_t>> members = findParts();
      parallelFor(members.size(), [&](std::size_t part) {
        Collapser(state_, static_cast<std::int32_t>(part), run_).work(members[part]);
      });
    }
    if (effort_ == Effort::Rough) return result();
    std::vector<std::int32_t> all;
    for (std::size_t v = 0; v < state_.points.size(); ++v) {
      if (!state_.gone[v]) all.push_back(static_cast<std::int32_t>(v));
    }
    Collapser(state_, -1, run_).work(all);
    return result();
  }

 private:
  // Slabs across the longest side, with the same number of vertices each.
  std::vector<std::vector<std::int32_t>> findParts() {
    const std::size_t count = state_.points.size();
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : state_.points) box.extend(p);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    std::vector<std::int32_t> order(count), slab(count);
    std::iota(order.begin(), order.end(), 0);
    tbb::parallel_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      const double x = state_.points[a][axis], y = state_.points[b][axis];
      return x != y ? x < y : a < b;
    });
    for (std::size_t i = 0; i < count; ++i)
      slab[order[i]] = static_cast<std::int32_t>(i * kParts / count);
    state_.part.assign(count, -1);
    std::vector<std::vector<std::int32_t>> members(kParts);
    for (std::size_t v = 0; v < count; ++v) {
      const bool inside =
          std::all_of(state_.around[v].begin(), state_.around[v].end(), [&](std::int32_t t) {
            const auto& tri = state_.triangles[t];
            return slab[tri[0]] == slab[v] && slab[tri[1]] == slab[v] && slab[tri[2]] == slab[v];
          });
      if (!inside) continue;
      state_.part[v] = slab[v];
      members[slab[v]].push_back(static_cast<std::int32_t>(v));
    }
    return members;
  }

  void prepare() {
    state_.points = in_.points;
    state_.triangles = in_.triangles;
    state_.label = partition_.patchOf;
    const std::size_t count = state_.points.size();
    state_.around.resize(count);
    state_.quadric.resize(count);
    state_.attached.resize(state_.triangles.size());
    watched_.resize(state_.triangles.size(), 0);
    watchLongEdges();
    state_.gone.assign(count, 0);
    state_.dead.assign(state_.triangles.size(), 0);
    state_.stamp.assign(count, 0);
    state_.kind.assign(count, VertexKind::Free);
    for (std::size_t t = 0; t < state_.triangles.size(); ++t) {
      const Vector3d area = in_.areaVector(static_cast<std::int32_t>(t));
      const double twice = area.norm();
      for (const std::int32_t v : state_.triangles[t]) {
        state_.around[v].push_back(static_cast<std::int32_t>(t));
        if (twice > 0) state_.quadric[v].addPlane(area / twice, state_.points[v], twice);
      }
    }
    classify();
    putBordersOnSurfaces();
  }

  // Corners near the new triangles do not yet keep the inside of a long triangle near them.
  void watchLongEdges() {
    const double spacing = kWatchSpacing * state_.tolerance;
    for (std::size_t t = 0; t < state_.triangles.size(); ++t) {
      if (state_.label[t] >= 0 || watched_[t]) continue;
      bool isLong = false;
      for (int k = 0; k < 3; ++k) {
        const Vector3d &a = state_.points[state_.triangles[t][k]],
                       &b = state_.points[state_.triangles[t][(k + 1) % 3]];
        const auto between =
            static_cast<int>(std::min<double>(kMaxWatched, (b - a).norm() / spacing));
        isLong = isLong || between > 0;
        const std::size_t h = 3 * t + k;
        if (static_cast<std::int32_t>(h) > in_.opposite[h] && state_.label[in_.opposite[h] / 3] < 0)
          continue;
        for (int i = 1; i <= between; ++i)
          state_.attached[t].push_back(a + (b - a) * (static_cast<double>(i) / (between + 1)));
      }
      if (!isLong) continue;
      const auto& tri = state_.triangles[t];
      state_.attached[t].push_back(
          (state_.points[tri[0]] + state_.points[tri[1]] + state_.points[tri[2]]) / 3);
    }
  }

  // Facets beside a patch will end on its surface: counted from here, that is part of what they may
  // be off.
  void putBordersOnSurfaces() {
    std::vector<const Carrier*> surfaces;
    for (std::size_t v = 0; v < state_.points.size(); ++v) {
      if (state_.kind[v] == VertexKind::Free) continue;
      surfaces.clear();
      std::int32_t open = -1;
      for (const std::int32_t t : state_.around[v]) {
        if (state_.label[t] < 0) {
          open = t;
          continue;
        }
        const Carrier* surface = &partition_.patches[state_.label[t]].surface;
        if (std::find(surfaces.begin(), surfaces.end(), surface) == surfaces.end())
          surfaces.push_back(surface);
      }
      if (open < 0) continue;
      const Vector3d moved = meetingPoint(state_.points[v], surfaces);
      const double off = (moved - state_.points[v]).norm();
      if (off <= 1e-9 || !(off <= state_.tolerance) || !holdsAttached(v, moved)) continue;
      state_.attached[open].push_back(state_.points[v]);
      state_.points[v] = moved;
    }
  }

  // Whether what must stay near the triangles around v does so with v somewhere else.
  bool holdsAttached(std::size_t v, const Vector3d& place) const {
    const double limit = state_.tolerance * state_.tolerance;
    for (const std::int32_t t : state_.around[v]) {
      if (state_.label[t] >= 0) continue;
      std::array<Vector3d, 3> c;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t w = state_.triangles[t][k];
        c[k] = static_cast<std::size_t>(w) == v ? place : state_.points[w];
      }
      for (const Vector3d& p : state_.attached[t]) {
        if (!(squaredDistance(p, c[0], c[1], c[2]) <= limit)) return false;
      }
    }
    return true;
  }

  // Border: exactly one patch and open ground around it, passed once. Fixed: anything more
  // involved.
  void classify() {
    std::vector<std::int32_t> borders(state_.points.size(), 0), patch(state_.points.size(), -1);
    std::vector<char> open(state_.points.size(), 0), several(state_.points.size(), 0);
    for (std::size_t h = 0; h < in_.opposite.size(); ++h) {
      const std::int32_t own = state_.label[h / 3], other = state_.label[in_.opposite[h] / 3];
      const std::int32_t v = in_.origin(static_cast<std::int32_t>(h));
      if (own != other) ++borders[v];
      if (own < 0) {
        open[v] = 1;
      } else {
        several[v] = several[v] || (patch[v] >= 0 && patch[v] != own);
        patch[v] = own;
      }
    }
    for (std::size_t v = 0; v < state_.points.size(); ++v) {
      if (patch[v] < 0) continue;
      const bool slides = open[v] && !several[v] && borders[v] == 2 && effort_ != Effort::Again;
      state_.kind[v] = slides ? VertexKind::Border : VertexKind::Fixed;
    }
  }

  Decimated result() {
    TriMesh small;
    std::vector<std::int32_t> id(state_.points.size(), -1);
    Decimated out;
    for (std::size_t t = 0; t < state_.triangles.size(); ++t) {
      if (state_.dead[t]) continue;
      for (const Vector3d& p : state_.attached[t]) {
        out.deviation =
            std::max(out.deviation, squaredDistance(p, state_.points[state_.triangles[t][0]],
                                                    state_.points[state_.triangles[t][1]],
                                                    state_.points[state_.triangles[t][2]]));
      }
      std::array<std::int32_t, 3> tri{};
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = state_.triangles[t][k];
        if (id[v] < 0) {
          id[v] = static_cast<std::int32_t>(small.vertices.size());
          small.vertices.push_back(state_.points[v]);
        }
        tri[k] = id[v];
      }
      small.triangles.push_back(tri);
      out.partition.patchOf.push_back(state_.label[t]);
      out.watched.push_back(state_.label[t] < 0);
      out.attached.push_back(std::move(state_.attached[t]));
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
  const Effort effort_;
  RunContext& run_;
  CollapseState state_;
  std::vector<char> watched_;
};

}  // namespace

Decimated decimate(Decimated start, double tolerance, RunContext& run, Effort effort) {
  Decimated once = Decimator(std::move(start), tolerance, effort, run).work();
  if (effort == Effort::Rough) return once;
  // The second time starts from the planes of what the first has left, which shows edges to
  // collapse that the planes of the mesh before did not.
  return Decimator(std::move(once), tolerance, effort, run).work();
}

}  // namespace swept::step
