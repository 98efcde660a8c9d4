// SPDX-License-Identifier: LGPL-2.1-or-later
#include "recognise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "cut_patches.h"
#include "seek_surface.h"
#include "tidy_patches.h"

namespace swept::step {
namespace {

// Seeds that are asked at the same time, whatever the number of threads.
constexpr std::size_t kBatch = 8;

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
    // Seeds in a fixed scattered order: neighbours in the list are neighbours on the mesh.
    std::int32_t stride = static_cast<std::int32_t>(0.618 * count) | 1;
    while (std::gcd(stride, count) != 1) stride += 2;
    std::int64_t at = 0;
    std::vector<std::int32_t> seeds;
    for (std::int32_t i = 0; i < count; ++i, at = (at + stride) % count) {
      if ((i & 255) == 0) run_.checkpoint(Phase::Export, i, 12ULL * count);
      if (isOpen(static_cast<std::int32_t>(at))) seeds.push_back(static_cast<std::int32_t>(at));
      if (seeds.size() == kBatch || i + 1 == count) {
        ask(seeds);
        seeds.clear();
      }
    }
  }

 private:
  bool isOpen(std::int32_t t) const {
    return tried_[t] != kAllTried && partition_.patchOf[t] < 0 && !thin_[t];
  }

  // All seeds see the patches as they were before; the first to claim a triangle gets it.
  void ask(const std::vector<std::int32_t>& seeds) {
    std::vector<Found> found(seeds.size());
    parallelFor(seeds.size(),
                [&](std::size_t i) { found[i] = seekers_[i].seek(seeds[i], tried_[seeds[i]]); });
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (!isOpen(seeds[i])) continue;
      if (found[i].best && isTaken(found[i].best->region))
        found[i] = seekers_[i].seek(seeds[i], tried_[seeds[i]]);
      note(found[i]);
    }
  }

  bool isTaken(const std::vector<std::int32_t>& region) const {
    return std::any_of(region.begin(), region.end(),
                       [&](std::int32_t t) { return partition_.patchOf[t] >= 0; });
  }

  void note(Found& found) {
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

}  // namespace

void recogniseSurfaces(const HalfEdgeMesh& mesh, double tolerance, Partition& partition,
                       RunContext& run) {
  const TriangleShapes shapes = shapesOf(mesh);
  Recogniser(mesh, shapes, tolerance, partition, run).recognise();
  tidyPatches(mesh, shapes, tolerance, partition);
  cutRoundPatches(mesh, partition);
  for (Patch& patch : partition.patches) {
    patch.deviation = 0;
    for (const std::int32_t t : patch.triangles) {
      for (const std::int32_t v : mesh.triangles[t]) {
        patch.deviation =
            std::max(patch.deviation, std::abs(patch.surface.distance(mesh.points[v])));
      }
    }
  }
}

}  // namespace swept::step
