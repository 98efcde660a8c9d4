// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simplify/collapse.h"
#include "simplify/thin.h"
#include "solid/carrier/curve.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Spacing of sample points, in tolerances. It is larger than for envelopes, because the solid later
// gets new vertices where the mesh is too far from it. (The distance of the facets from the mesh is
// not measured then.) With 1.5, the gripper test mesh moved over 34 keys takes an eighth more time
// and gets a fiftieth more facets.
constexpr double kCoarseness = 5;

// The surface of a patch, in the form that the simplifier needs.
class PatchSurface final : public LabelSurface {
 public:
  explicit PatchSurface(const Carrier& surface) : surface_(surface) {}
  bool isPlanar() const override { return surface_.isPlanar(); }
  double distance(const Vector3d& p) const override { return surface_.distance(p); }
  Vector3d normal(const Vector3d& p) const override { return surface_.normal(p); }

 private:
  const Carrier& surface_;
};

// Copies the patches of `before`. Their triangles follow from now.patchOf.
void listPatches(const Partition& before, Partition& now) {
  now.patches = before.patches;
  now.cuts = before.cuts;
  for (Patch& patch : now.patches) patch.triangles.clear();
  for (std::size_t t = 0; t < now.patchOf.size(); ++t) {
    const std::int32_t p = now.patchOf[t];
    if (p >= 0) now.patches[p].triangles.push_back(static_cast<std::int32_t>(t));
  }
}

class Decimator {
 public:
  Decimator(Decimated start, double tolerance, const NearestTriangle& original, Effort effort,
            RunContext& run)
      : in_(std::move(start.mesh)),
        partition_(std::move(start.partition)),
        fixed_(std::move(start.fixed)),
        effort_(effort),
        run_(run) {
    state_.tolerance = tolerance;
    state_.coarseness = kCoarseness;
    state_.denserAtFolds = false;
    state_.phase = Phase::Export;
    state_.original = &original;
    state_.mesh = {in_.points, in_.triangles};
    state_.label = partition_.patchOf;
    for (const Patch& patch : partition_.patches)
      state_.surfaces.push_back(std::make_unique<PatchSurface>(patch.surface));
    state_.attached = std::move(start.attached);
    start.watched.resize(in_.triangles.size(), 0);
    watchLongEdges(state_, start.watched);
    classify();
    if (fixed_.empty()) putBordersOnSurfaces();
  }

  Decimated work() {
    collapseEdges(state_, effort_ == Effort::Rough, run_);
    return result();
  }

 private:
  // Moves border vertices onto the surfaces of their patches, where facets will end in the solid.
  // This is done before the collapses, so that this movement counts within the tolerance of the
  // facets.
  void putBordersOnSurfaces() {
    std::vector<std::vector<std::int32_t>> around(in_.points.size());
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) {
      for (const std::int32_t v : in_.triangles[t]) {
        if (state_.kind[v] != VertexKind::Free) around[v].push_back(static_cast<std::int32_t>(t));
      }
    }
    std::vector<const Carrier*> surfaces;
    for (std::size_t v = 0; v < around.size(); ++v) {
      if (around[v].empty()) continue;
      surfaces.clear();
      std::int32_t open = -1;
      for (const std::int32_t t : around[v]) {
        if (state_.label[t] < 0) {
          open = t;
          continue;
        }
        const Carrier* surface = &partition_.patches[state_.label[t]].surface;
        if (std::find(surfaces.begin(), surfaces.end(), surface) == surfaces.end())
          surfaces.push_back(surface);
      }
      if (open < 0) continue;
      const Vector3d moved = meetingPoint(state_.mesh.vertices[v], surfaces);
      const double off = (moved - state_.mesh.vertices[v]).norm();
      if (off <= 1e-9 || !(off <= state_.tolerance) ||
          !keepsAttachedNear(around[v], static_cast<std::int32_t>(v), moved))
        continue;
      state_.attached[open].push_back(state_.mesh.vertices[v]);
      state_.mesh.vertices[v] = moved;
    }
  }

  // Returns whether the points attached to triangles around v stay near these triangles if v moves
  // to `position`.
  bool keepsAttachedNear(const std::vector<std::int32_t>& around, std::int32_t v,
                         const Vector3d& position) const {
    const double limit = state_.tolerance * state_.tolerance;
    for (const std::int32_t t : around) {
      if (state_.label[t] >= 0) continue;
      std::array<Vector3d, 3> c;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t w = state_.mesh.triangles[t][k];
        c[k] = w == v ? position : state_.mesh.vertices[w];
      }
      for (const Vector3d& p : state_.attached[t]) {
        if (!(squaredDistance(p, c[0], c[1], c[2]) <= limit)) return false;
      }
    }
    return true;
  }

  // Sets the kind of each vertex. Border: one patch and open ground lie around the vertex, and two
  // border edges meet there. Fixed: all other vertices of patches. Free: vertices without a patch.
  void classify() {
    std::vector<std::int32_t> borders(state_.mesh.vertices.size(), 0),
        patch(state_.mesh.vertices.size(), -1);
    std::vector<char> open(state_.mesh.vertices.size(), 0), several(state_.mesh.vertices.size(), 0);
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
    state_.kind.assign(state_.mesh.vertices.size(), VertexKind::Free);
    for (std::size_t v = 0; v < state_.mesh.vertices.size(); ++v) {
      if (patch[v] < 0) continue;
      const bool slides = open[v] && !several[v] && borders[v] == 2 && effort_ != Effort::Again &&
                          (fixed_.empty() || !fixed_[v]);
      state_.kind[v] = slides ? VertexKind::Border : VertexKind::Fixed;
    }
  }

  Decimated result() {
    Decimated out;
    std::vector<std::int32_t> left;
    const TriMesh small = takeMesh(state_, &left);
    for (std::size_t t = 0; t < left.size(); ++t) {
      std::vector<Vector3d>& points = state_.attached[left[t]];
      for (const Vector3d& p : points) {
        out.deviation =
            std::max(out.deviation, squaredDistance(p, small, static_cast<std::int32_t>(t)));
      }
      const std::int32_t label = state_.label[left[t]];
      out.partition.patchOf.push_back(label);
      out.watched.push_back(label < 0);
      out.attached.push_back(std::move(points));
    }
    out.deviation = std::sqrt(out.deviation);
    if (!fixed_.empty()) {
      out.fixed.assign(small.vertices.size(), 0);
      for (std::size_t t = 0; t < left.size(); ++t) {
        for (int k = 0; k < 3; ++k)
          out.fixed[small.triangles[t][k]] = fixed_[state_.mesh.triangles[left[t]][k]];
      }
    }
    out.mesh = buildHalfEdges(small, run_);
    listPatches(partition_, out.partition);
    return out;
  }

  const HalfEdgeMesh in_;
  const Partition partition_;
  const std::vector<char> fixed_;
  const Effort effort_;
  RunContext& run_;
  CollapseState state_;
};

}  // namespace

Decimated asOpenGround(HalfEdgeMesh mesh) {
  Decimated result{std::move(mesh), {}, {}, {}, 0};
  result.partition.patchOf.assign(result.mesh.triangles.size(), -1);
  return result;
}

Decimated thinOpenGround(Decimated start, double limit, RunContext& run) {
  const HalfEdgeMesh& mesh = start.mesh;
  std::vector<char> kept(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (start.partition.patchOf[t] < 0) continue;
    for (const std::int32_t v : mesh.triangles[t]) kept[v] = 1;
  }
  const Thinned thin = thinOut({mesh.points, mesh.triangles}, limit, ThinFor::Collapse,
                               Phase::Export, run, std::move(kept));
  Decimated out;
  for (const std::int32_t t : thin.triangle)
    out.partition.patchOf.push_back(start.partition.patchOf[t]);
  out.mesh = buildHalfEdges(thin.mesh, run);
  listPatches(start.partition, out.partition);
  return out;
}

Decimated decimate(Decimated start, double tolerance, const NearestTriangle& original,
                   RunContext& run, Effort effort) {
  Decimated once = Decimator(std::move(start), tolerance, original, effort, run).work();
  if (effort == Effort::Rough) return once;
  // The second pass starts with the planes of the reduced mesh. They allow collapses that the
  // planes of the original mesh did not allow.
  return Decimator(std::move(once), tolerance, original, effort, run).work();
}

}  // namespace swept::step
