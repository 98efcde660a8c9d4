// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "solid/recognise/facets_saved.h"
#include "solid/recognise/region_finder.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Fraction of the area of the mesh. A smaller patch must save kMinSavedToStay facets.
constexpr double kMinArea = 1.0 / 400;
constexpr double kMinSavedToStay = 8;
/// Cosine of the largest angle between a triangle and the surface that it joins.
constexpr double kMinCosine = 0.5;
// number of smooth border edges that add one facet outside the patch
constexpr double kBorderPerFacet = 3;
constexpr std::size_t kMaxSpeck = 6;  // largest number of triangles of a speck
constexpr double kMaxSpeckArea = 30;  // largest area of a speck, in squared tolerances
constexpr double kMaxSpeckReach = 6;  // in tolerances: distance from the surface that a speck joins
constexpr int kStepsBeyond = 6;       // triangles beyond a border that are examined
// sine of about 7 degrees: the mesh turns away steeply if its angle is larger
constexpr double kMinSteep = 0.12;
/// Distance from the surface, in tolerances, beyond which the steepness counts.
constexpr double kSteepFrom = 0.25;

// Prepares the patches of a partition to become faces, step by step.
class Tidier {
 public:
  Tidier(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
         Partition& partition)
      : mesh_(mesh), shapes_(shapes), tolerance_(tolerance), partition_(partition) {}

  void tidy() {
    absorbLeftovers();
    mergePatches();
    absorbLeftovers();
    fillHoles();
    assignSpecks();
    dropCostly();
  }

 private:
  // Unassigned triangles beside a patch join it while their vertices lie on its surface. Repeats,
  // so that strips along creases close. Needles may have any normal.
  void absorbLeftovers() {
    std::vector<std::int32_t> front, next;
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const auto t = static_cast<std::int32_t>(h / 3);
      if (partition_.patchOf[t] >= 0 || partition_.patchOf[mesh_.opposite[h] / 3] < 0) continue;
      if (front.empty() || front.back() != t) front.push_back(t);
    }
    for (; !front.empty(); front.swap(next)) {
      next.clear();
      for (const std::int32_t t : front) {
        const std::int32_t patch = partition_.patchOf[t] < 0 ? hostOf(t, 1) : -1;
        if (patch < 0) continue;
        join(t, patch);
        for (const std::int32_t other : mesh_.neighbours(t)) {
          if (partition_.patchOf[other] < 0) next.push_back(other);
        }
      }
      sortUnique(next);
    }
  }

  // Returns the patch beside t whose surface is nearest to its vertices; -1 if none is within
  // `tolerances` times the tolerance.
  std::int32_t hostOf(std::int32_t t, double tolerances) const {
    std::int32_t best = -1;
    double smallest = tolerances * tolerance_;
    for (const std::int32_t other : mesh_.neighbours(t)) {
      const std::int32_t patch = partition_.patchOf[other];
      if (patch < 0) continue;
      const Carrier& surface = partition_.patches[patch].surface;
      double worst = 0;
      Vector3d centre = Vector3d::Zero();
      for (const std::int32_t v : mesh_.triangles[t]) {
        worst = std::max(worst, std::abs(surface.distance(mesh_.points[v])));
        centre += mesh_.points[v] / 3;
      }
      if (tolerances <= 1 && !shapes_.thin[t] &&
          surface.normal(centre).dot(shapes_.normal[t]) < kMinCosine)
        continue;
      if (worst > smallest) continue;
      smallest = worst;
      best = patch;
    }
    return best;
  }

  // Small islands inside one patch join it if their vertices lie on its surface, whatever their
  // normals.
  void fillHoles() {
    std::vector<char> seen(mesh_.triangles.size(), 0);
    for (std::size_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (seen[first]) continue;
      const std::int32_t own = partition_.patchOf[first];
      if (own >= 0 && partition_.patches[own].triangles.size() > kMinTriangles) continue;
      std::int32_t around = -1;
      bool mixed = false;
      const auto island = flood(static_cast<std::int32_t>(first), seen, [&](std::int32_t t) {
        const std::int32_t patch = partition_.patchOf[t];
        if (patch == own) return true;
        mixed = mixed || patch < 0 || (around >= 0 && around != patch);
        around = patch;
        return false;
      });
      if (mixed || around < 0 || island.size() > kMinTriangles) continue;
      const Carrier& surface = partition_.patches[around].surface;
      if (!(largestDistance(mesh_, island, surface) <= tolerance_)) continue;
      if (own >= 0) partition_.patches[own].triangles.clear();
      for (const std::int32_t t : island) join(t, around);
    }
    dropEmptyPatches();
  }

  // Assigns specks: a few small triangles between patches, where contouring blunted a crease or
  // corner. Each joins a patch beside it, which then ends where the surfaces intersect. All
  // vertices of specks are already vertices of patches.
  void assignSpecks() {
    std::vector<char> seen(mesh_.triangles.size(), 0);
    for (std::size_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (seen[first] || partition_.patchOf[first] >= 0) continue;
      const auto speck = flood(static_cast<std::int32_t>(first), seen,
                               [&](std::int32_t t) { return partition_.patchOf[t] < 0; });
      if (speck.size() > kMaxSpeck ||
          areaOf(mesh_, speck) > kMaxSpeckArea * tolerance_ * tolerance_)
        continue;
      for (std::size_t left = speck.size(), before = 0; left != before;) {
        before = left;
        for (const std::int32_t t : speck) {
          const std::int32_t host = partition_.patchOf[t] < 0 ? hostOf(t, kMaxSpeckReach) : -1;
          if (host < 0) continue;
          join(t, host);
          --left;
        }
      }
    }
  }

  // Returns the connected triangles that `accepts` allows, starting with `first`, and marks them as
  // seen.
  template <class Accepts>
  std::vector<std::int32_t> flood(std::int32_t first, std::vector<char>& seen,
                                  const Accepts& accepts) const {
    std::vector<std::int32_t> region{first};
    seen[first] = 1;
    for (std::size_t i = 0; i < region.size(); ++i) {
      for (const std::int32_t t : mesh_.neighbours(region[i])) {
        if (!accepts(t) || seen[t]) continue;
        seen[t] = 1;
        region.push_back(t);
      }
    }
    return region;
  }

  void join(std::int32_t t, std::int32_t patch) {
    partition_.patchOf[t] = patch;
    partition_.patches[patch].triangles.push_back(t);
  }

  bool patchLiesOn(std::int32_t patch, const Carrier& surface) const {
    const std::vector<std::int32_t>& triangles = partition_.patches[patch].triangles;
    return std::all_of(triangles.begin(), triangles.end(), [&](std::int32_t t) {
      return liesOn(mesh_, shapes_, t, surface, tolerance_, kMinCosine);
    });
  }

  // Joins pieces of one surface that were found separately. The smaller piece joins the larger one.
  void mergePatches() {
    std::vector<std::int32_t> order(partition_.patches.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return partition_.patches[a].triangles.size() < partition_.patches[b].triangles.size();
    });
    for (const std::int32_t p : order) {
      std::vector<std::int32_t> neighbours;
      for (const std::int32_t t : partition_.patches[p].triangles) {
        for (const std::int32_t other : mesh_.neighbours(t)) {
          const std::int32_t q = partition_.patchOf[other];
          if (q >= 0 && q != p) neighbours.push_back(q);
        }
      }
      sortUnique(neighbours);
      std::int32_t best = -1;
      for (const std::int32_t q : neighbours) {
        const std::size_t size = partition_.patches[q].triangles.size();
        if (size < partition_.patches[p].triangles.size()) continue;
        if (best >= 0 && size <= partition_.patches[best].triangles.size()) continue;
        if (patchLiesOn(p, partition_.patches[q].surface)) best = q;
      }
      if (best < 0) continue;
      for (const std::int32_t t : partition_.patches[p].triangles) partition_.patchOf[t] = best;
      auto& into = partition_.patches[best].triangles;
      into.insert(into.end(), partition_.patches[p].triangles.begin(),
                  partition_.patches[p].triangles.end());
      partition_.patches[p].triangles.clear();
    }
    dropEmptyPatches();
  }

  // Drops patches that cost more facets than they save. Many free forms come near a plane or
  // cylinder in places. Such a patch ends in a jagged line where the body continues smoothly. The
  // vertices of that line create more facets outside than the patch saves inside. The border of a
  // real surface of the body follows creases or other patches.
  void dropCostly() {
    const std::vector<char> turns = turningBorders();
    std::vector<double> saved;
    for (Patch& patch : partition_.patches) {
      saved.push_back(facetsSaved(mesh_, patch, tolerance_));
      if (areaOf(mesh_, patch.triangles) < kMinArea * mesh_.area && saved.back() < kMinSavedToStay)
        release(patch);
    }
    std::vector<std::int32_t> smooth(partition_.patches.size());
    for (bool changed = true; changed;) {
      changed = false;
      std::fill(smooth.begin(), smooth.end(), 0);
      for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
        const std::int32_t own = partition_.patchOf[h / 3];
        if (own >= 0 && !turns[h] && partition_.patchOf[mesh_.opposite[h] / 3] < 0) ++smooth[own];
      }
      for (std::size_t p = 0; p < partition_.patches.size(); ++p) {
        if (smooth[p] <= kBorderPerFacet * saved[p] || partition_.patches[p].triangles.empty())
          continue;
        release(partition_.patches[p]);
        changed = true;
      }
    }
    dropEmptyPatches();
  }

  void release(Patch& patch) {
    for (const std::int32_t t : patch.triangles) partition_.patchOf[t] = -1;
    patch.triangles.clear();
  }

  // By half-edge: 1 if the mesh turns away steeply from the patch's surface just beyond the border.
  std::vector<char> turningBorders() const {
    std::vector<char> turns(mesh_.opposite.size(), 0);
    parallelBlocks(turns.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t h = begin; h < end; ++h) {
        const std::int32_t own = partition_.patchOf[h / 3];
        if (own >= 0 && own != partition_.patchOf[mesh_.opposite[h] / 3])
          turns[h] = turnsAway(static_cast<std::int32_t>(h), partition_.patches[own].surface);
      }
    });
    return turns;
  }

  bool turnsAway(std::int32_t border, const Carrier& surface) const {
    const Vector3d from =
        (mesh_.points[mesh_.origin(border)] + mesh_.points[mesh_.target(border)]) / 2;
    std::int32_t h = mesh_.opposite[border];
    for (int step = 0; step < kStepsBeyond; ++step) {
      const Vector3d& p = mesh_.points[mesh_.origin(HalfEdgeMesh::previous(h))];
      const double distance = std::abs(surface.distance(p));
      if (distance > kMinSteep * (p - from).norm() + kSteepFrom * tolerance_) return true;
      h = mesh_.opposite[step % 2 == 0 ? HalfEdgeMesh::next(h) : HalfEdgeMesh::previous(h)];
    }
    return false;
  }

  void dropEmptyPatches() {
    std::vector<Patch> left;
    for (Patch& patch : partition_.patches) {
      if (patch.triangles.empty()) continue;
      const auto id = static_cast<std::int32_t>(left.size());
      for (const std::int32_t t : patch.triangles) partition_.patchOf[t] = id;
      patch.surfaceId = id;
      left.push_back(std::move(patch));
    }
    partition_.patches.swap(left);
  }

  const HalfEdgeMesh& mesh_;
  const TriangleShapes& shapes_;
  double tolerance_;
  Partition& partition_;
};

}  // namespace

void tidyPatches(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                 Partition& partition) {
  Tidier(mesh, shapes, tolerance, partition).tidy();
}

}  // namespace swept::step
