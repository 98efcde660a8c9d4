// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/recognise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "solid/recognise/fit.h"
#include "solid/recognise/seek_surface.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

// Number of seeds that are tried in parallel. It does not depend on the number of threads, so the
// result does not either.
constexpr std::size_t kBatch = 16;

class Recogniser {
 public:
  Recogniser(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
             Partition& partition, RunContext& run)
      : thin_(shapes.thin), partition_(partition), run_(run), tried_(mesh.triangles.size(), 0) {
    seekers_.reserve(kBatch);
    for (std::size_t i = 0; i < kBatch; ++i)
      seekers_.emplace_back(mesh, shapes, tolerance, partition);
  }

  void recognise() {
    const auto count = static_cast<std::int32_t>(tried_.size());
    std::vector<std::int32_t> seeds;
    forScattered(count, [&](std::int32_t i, std::int32_t t) {
      if ((i & 255) == 0) run_.checkpoint(Phase::Export, i, 12ULL * count);
      if (isOpen(t)) seeds.push_back(t);
      if (seeds.size() < kBatch && i + 1 < count) return;
      trySeeds(seeds);
      seeds.clear();
    });
  }

 private:
  bool isOpen(std::int32_t t) const {
    return tried_[t] != kAllTried && partition_.patchOf[t] < 0 && !thin_[t];
  }

  // All seeds of a batch are tried with the same patches. A triangle goes to the first seed that
  // claims it; a later seed then searches again.
  void trySeeds(const std::vector<std::int32_t>& seeds) {
    std::vector<Found> found(seeds.size());
    parallelFor(seeds.size(),
                [&](std::size_t i) { found[i] = seekers_[i].seek(seeds[i], tried_[seeds[i]]); });
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (!isOpen(seeds[i])) continue;
      if (found[i].best && isTaken(found[i].best->region))
        found[i] = seekers_[i].seek(seeds[i], tried_[seeds[i]]);
      record(found[i]);
    }
  }

  bool isTaken(const std::vector<std::int32_t>& region) const {
    return std::any_of(region.begin(), region.end(),
                       [&](std::int32_t t) { return partition_.patchOf[t] >= 0; });
  }

  void record(Found& found) {
    for (const auto& [kind, region] : found.tried) {
      for (const std::int32_t t : region) tried_[t] = static_cast<char>(tried_[t] | bitOf(kind));
    }
    for (const std::int32_t t : found.fruitless) tried_[t] = kAllTried;
    if (!found.best) return;
    const auto id = static_cast<std::int32_t>(partition_.patches.size());
    for (const std::int32_t t : found.best->region) partition_.patchOf[t] = id;
    partition_.patches.push_back({found.best->surface, std::move(found.best->region), 0, id});
  }

  const std::vector<char>& thin_;
  Partition& partition_;
  RunContext& run_;
  std::vector<char> tried_;  // by triangle: kinds that were tried there, as bits
  std::vector<SurfaceSeeker> seekers_;
};

/// Least Bend::scatter, as a fraction of Bend::height. Below it, the vertices lie exactly on the
/// surface.
constexpr double kMinScatter = 0.03;
constexpr double kMaxMoved = 0.2;  // fraction of the tolerance: largest shift of a surface
constexpr std::size_t kMaxFitSamples = 5000;
/// Vertices farther away than this multiple of the median distance belong to a neighbour.
constexpr double kMaxMedians = 5;

void offsetSurface(Carrier& surface, double outward) {
  const double grow = surface.reversed ? -outward : outward;
  if (surface.hasProfile()) {
    surface.profile = std::make_shared<const Profile>(surface.profile->offset(grow));
    return;
  }
  if (surface.kind == CarrierKind::Torus) {
    surface.minor += grow;
  } else {
    surface.radius += surface.kind == CarrierKind::Cone ? grow / surface.cosine : grow;
  }
}

// Fits the surface again without outliers. For example, a sphere may contain a ring of an adjacent
// cylinder.
void fitToMost(const HalfEdgeMesh& mesh, Patch& patch) {
  for (int round = 0; round < 2; ++round) {
    const double limit = kMaxMedians * medianDistance(mesh, patch.surface, patch.triangles);
    Samples samples;
    for (const std::int32_t t : patch.triangles) {
      const Eigen::Vector3d& p = mesh.points[mesh.triangles[t][0]];
      if (std::abs(patch.surface.distance(p)) <= limit) samples.points.push_back(p);
    }
    refineSurface(samples, patch.surface, kMaxFitSamples);
  }
}

struct Bend {
  double height = 0;   // mm: height of triangle centres above their corners, along the normal
  double scatter = 0;  // mm: root mean square distance of the corners from the surface
  double size = 0;     // mm^2: mean squared distance of corners from the centre
};

double sizeOf(const HalfEdgeMesh& mesh, std::int32_t t, Eigen::Vector3d& middle) {
  const auto& tri = mesh.triangles[t];
  middle = (mesh.points[tri[0]] + mesh.points[tri[1]] + mesh.points[tri[2]]) / 3;
  double sum = 0;
  for (const std::int32_t v : tri) sum += (mesh.points[v] - middle).squaredNorm() / 3;
  return sum;
}

double meanSize(const HalfEdgeMesh& mesh) {
  constexpr std::size_t kEvery = 5;
  double sum = 0, count = 0;
  Eigen::Vector3d middle;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += kEvery, ++count)
    sum += sizeOf(mesh, static_cast<std::int32_t>(t), middle);
  return sum / count;
}

Bend bendOf(const HalfEdgeMesh& mesh, const Patch& patch) {
  Bend bend;
  for (const std::int32_t t : patch.triangles) {
    Eigen::Vector3d middle;
    bend.size += sizeOf(mesh, t, middle);
    bend.height += patch.surface.distance(middle);
    for (const std::int32_t v : mesh.triangles[t]) {
      const double distance = patch.surface.distance(mesh.points[v]);
      bend.height -= distance / 3;
      bend.scatter += distance * distance / 3;
    }
  }
  const auto count = static_cast<double>(patch.triangles.size());
  return {bend.height / count, std::sqrt(bend.scatter / count), bend.size / count};
}

// Vertices of a contoured mesh lie outside a curved surface. So a surface fitted to them is moved
// to the centres of the triangles, where the exact surface is. If the vertices lie exactly on the
// surface, it stays.
void centreSurfaces(const HalfEdgeMesh& mesh, const HalfEdgeMesh& whole, double tolerance,
                    Partition& partition) {
  const double size = meanSize(whole);
  parallelFor(partition.patches.size(), [&](std::size_t p) {
    Patch& patch = partition.patches[p];
    if (patch.surface.isPlanar() || patch.triangles.empty()) return;
    fitToMost(mesh, patch);
    const Bend bend = bendOf(mesh, patch);
    // Thinning made the triangles larger and higher, but their vertices stayed in place.
    const double move = bend.height * std::min(1.0, size / bend.size);
    if (bend.scatter > kMinScatter * std::abs(move) && std::abs(move) <= kMaxMoved * tolerance)
      offsetSurface(patch.surface, move);
  });
}

}  // namespace

void recogniseSurfaces(const HalfEdgeMesh& mesh, const HalfEdgeMesh& whole, double tolerance,
                       Partition& partition, RunContext& run) {
  const TriangleShapes shapes = shapesOf(mesh);
  Recogniser(mesh, shapes, tolerance, partition, run).recognise();
  tidyPatches(mesh, shapes, tolerance, partition);
  if (seekProfiles(mesh, shapes, tolerance, partition, run))
    tidyPatches(mesh, shapes, tolerance, partition);
  centreSurfaces(mesh, whole, tolerance, partition);
  cutRoundPatches(mesh, partition);
  for (Patch& patch : partition.patches)
    patch.deviation = largestDistance(mesh, patch.triangles, patch.surface);
}

}  // namespace swept::step
