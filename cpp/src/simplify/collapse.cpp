// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/collapse.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "geometry/half_edges.h"
#include "geometry/mesh_parts.h"
#include "simplify/collapser.h"
#include "simplify/folds.h"

namespace swept {
namespace {

using Eigen::Vector3d;

// Spacing (in tolerances) and largest number of the points that are attached along a long edge.
struct Watch {
  double spacing;
  int most;
};
constexpr Watch kWatch = {3, 3};
// At folds. On a surface of many folds (the station test mesh moved over 16 keys, 512 cells,
// tolerance 50 mm), 512 points of the original deviated too much after the first round with kWatch,
// and 259 with these values.
constexpr Watch kWatchFolds = {1, 7};
// Number of slabs that are processed in parallel; fixed, so that the result does not depend on the
// number of threads. Each further axis has half as many, as fewer vertices are left. With slabs
// across one axis only, and shifted ones around their limits, the single thread at the end took
// twice as long as all slabs; the results had up to 6 % fewer triangles.
constexpr std::size_t kSlabs = 16;
// Meshes with fewer triangles are processed in one piece.
constexpr std::size_t kWorthSlabs = 4000;

// Finds the vertices with triangles that are turned away from the mean of the triangles there.
void findFolds(CollapseState& state) {
  state.care.assign(state.around.size(), Care::Normal);
  if (!state.denserAtFolds) return;
  for (std::size_t v = 0; v < state.around.size(); ++v) {
    const auto area = [&](std::int32_t t) {
      return areaVector(state.mesh, state.mesh.triangles[t]);
    };
    Vector3d mean = Vector3d::Zero();
    for (const std::int32_t t : state.around[v]) mean += area(t);
    const bool isFolded = std::any_of(state.around[v].begin(), state.around[v].end(),
                                      [&](std::int32_t t) { return isFold(area(t), mean); });
    if (isFolded) state.care[v] = Care::Folded;
  }
}

void prepare(CollapseState& state) {
  const std::size_t count = state.mesh.vertices.size(), triangles = state.mesh.triangles.size();
  state.gone.assign(count, 0);
  state.dead.assign(triangles, 0);
  state.stamp.assign(count, 0);
  state.kind.resize(count, VertexKind::Free);
  state.label.resize(triangles, -1);
  state.attached.resize(triangles);
  state.around.assign(count, {});
  state.quadric.assign(count, {});
  state.nearby.resize(count, -1);
  state.origin.setZero();
  for (const Vector3d& p : state.mesh.vertices) state.origin += p;
  state.origin /= static_cast<double>(count);
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto& tri = state.mesh.triangles[t];
    const Vector3d& a = state.mesh.vertices[tri[0]];
    const Vector3d area = areaVector(state.mesh, tri);
    const double twice = area.norm();
    Quadric plane;
    if (twice > 0) plane.addPlane(area / twice, a - state.origin, twice);
    for (const std::int32_t v : tri) {
      state.around[v].push_back(static_cast<std::int32_t>(t));
      state.quadric[v] += plane;
    }
  }
  findFolds(state);
}

// Slabs across one axis, with about the same number of unfinished vertices each.
class Slabs {
 public:
  /// `done`: for each vertex, 0 or more if an earlier pass has finished the vertex. Keeps a
  /// reference to it.
  Slabs(const CollapseState& state, int axis, std::size_t count,
        const std::vector<std::int32_t>& done)
      : state_(state), done_(done), axis_(axis) {
    std::vector<std::int32_t> left;
    std::vector<double> along;
    for (std::size_t v = 0; v < state.mesh.vertices.size(); ++v) {
      if (state.gone[v]) continue;
      left.push_back(static_cast<std::int32_t>(v));
      if (done[v] < 0) along.push_back(state.mesh.vertices[v][axis]);
    }
    tbb::parallel_sort(along.begin(), along.end());
    for (std::size_t i = 1; i < count && !along.empty(); ++i)
      limits_.push_back(along[i * along.size() / count]);
    partOf_.assign(state.mesh.vertices.size(), -1);
    for (const std::int32_t v : left) {
      const std::size_t own = slabOf(v);
      const bool inside =
          std::all_of(state.around[v].begin(), state.around[v].end(), [&](std::int32_t t) {
            const auto& tri = state.mesh.triangles[t];
            return slabOf(tri[0]) == own && slabOf(tri[1]) == own && slabOf(tri[2]) == own;
          });
      if (inside) partOf_[v] = static_cast<std::int32_t>(own);
    }
  }

  const std::vector<std::int32_t>& partOf() const { return partOf_; }

  /// Returns one part per slab.
  std::vector<WorkPart> parts() const {
    std::vector<WorkPart> parts(limits_.size() + 1);
    for (std::size_t s = 0; s < parts.size(); ++s) {
      parts[s].partOf = &partOf_;
      parts[s].number = static_cast<std::int32_t>(s);
      parts[s].axis = axis_;
      if (s > 0) parts[s].low = limits_[s - 1];
      if (s < limits_.size()) parts[s].high = limits_[s];
    }
    for (std::size_t v = 0; v < partOf_.size(); ++v) {
      if (partOf_[v] >= 0 && done_[v] < 0)
        parts[partOf_[v]].vertices.push_back(static_cast<std::int32_t>(v));
    }
    for (std::size_t t = 0; t < state_.mesh.triangles.size(); ++t) {
      if (state_.dead[t]) continue;
      const auto& tri = state_.mesh.triangles[t];
      const auto [low, high] = std::minmax({slabOf(tri[0]), slabOf(tri[1]), slabOf(tri[2])});
      for (std::size_t s = low; s <= high; ++s)
        parts[s].triangles.push_back(static_cast<std::int32_t>(t));
    }
    return parts;
  }

 private:
  std::size_t slabOf(std::int32_t v) const {
    return std::upper_bound(limits_.begin(), limits_.end(), state_.mesh.vertices[v][axis_]) -
           limits_.begin();
  }

  const CollapseState& state_;
  const std::vector<std::int32_t>& done_;
  int axis_;
  std::vector<double> limits_;
  std::vector<std::int32_t> partOf_;
};

// Returns the axes in the order of the sides of the bounding box, the longest one first.
std::array<int, 3> axesByLength(const TriMesh& mesh) {
  const Vector3d sides = boxOf(mesh).sizes();
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return sides[a] > sides[b]; });
  return axes;
}

std::vector<std::int32_t> trianglesLeft(const CollapseState& state) {
  std::vector<std::int32_t> left;
  for (std::size_t t = 0; t < state.dead.size(); ++t) {
    if (!state.dead[t]) left.push_back(static_cast<std::int32_t>(t));
  }
  return left;
}

}  // namespace

void watchLongEdges(CollapseState& state, const std::vector<char>& watched) {
  const TriMesh& mesh = state.mesh;
  state.attached.resize(mesh.triangles.size());
  const RawArray<std::uint32_t> across = findAdjacency(mesh).across;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (state.label[t] >= 0 || watched[t]) continue;
    const auto& tri = mesh.triangles[t];
    bool isLong = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d &a = mesh.vertices[tri[k]], &b = mesh.vertices[tri[(k + 1) % 3]];
      const std::size_t h = 3 * t + k;
      const Watch& watch =
          state.denserAtFolds &&
                  isFold(areaVector(mesh, tri), areaVector(mesh, mesh.triangles[across[h] / 3]))
              ? kWatchFolds
              : kWatch;
      const auto between = static_cast<int>(
          std::min<double>(watch.most, (b - a).norm() / (watch.spacing * state.tolerance)));
      isLong = isLong || between > 0;
      if (h > across[h] && state.label[across[h] / 3] < 0) continue;
      for (int i = 1; i <= between; ++i)
        state.attached[t].push_back(a + (b - a) * (static_cast<double>(i) / (between + 1)));
    }
    if (!isLong) continue;
    state.attached[t].push_back(
        (mesh.vertices[tri[0]] + mesh.vertices[tri[1]] + mesh.vertices[tri[2]]) / 3);
  }
}

void collapseEdges(CollapseState& state, bool quick, RunContext& run, CollapseLog* log) {
  prepare(state);
  std::vector<std::int32_t> done(state.mesh.vertices.size(), -1);
  if (state.mesh.triangles.size() > kWorthSlabs) {
    std::size_t count = kSlabs;
    for (const int axis : axesByLength(state.mesh)) {
      const Slabs slabs(state, axis, count, done);
      count /= 2;
      const std::vector<WorkPart> parts = slabs.parts();
      std::vector<CollapseLog> logs(parts.size());
      parallelFor(parts.size(), [&](std::size_t p) {
        Collapser(state, parts[p], run, log != nullptr ? &logs[p] : nullptr).work();
      });
      for (std::size_t p = 0; log != nullptr && p < logs.size(); ++p) log->append(logs[p]);
      for (std::size_t v = 0; v < done.size(); ++v) done[v] = std::max(done[v], slabs.partOf()[v]);
    }
  }
  if (quick) return;
  WorkPart all;
  for (std::size_t v = 0; v < done.size(); ++v) {
    if (!state.gone[v] && done[v] < 0) all.vertices.push_back(static_cast<std::int32_t>(v));
  }
  all.triangles = trianglesLeft(state);
  Collapser(state, all, run, log).work();
}

void collapseAgain(CollapseState& state, const std::vector<std::int32_t>& triangles,
                   RunContext& run, CollapseLog& log) {
  WorkPart all;
  for (const std::int32_t t : triangles) {
    if (state.dead[t]) continue;
    const auto& tri = state.mesh.triangles[t];
    all.vertices.insert(all.vertices.end(), tri.begin(), tri.end());
  }
  sortUnique(all.vertices);
  all.triangles = trianglesLeft(state);
  Collapser(state, all, run, &log).work();
}

TriMesh takeMesh(const CollapseState& state, std::vector<std::int32_t>* triangles) {
  TriMesh mesh;
  std::vector<std::int32_t> id(state.mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < state.dead.size(); ++t) {
    if (state.dead[t]) continue;
    takeTriangle(state.mesh, t, id, mesh);
    if (triangles != nullptr) triangles->push_back(static_cast<std::int32_t>(t));
  }
  return mesh;
}

}  // namespace swept
