// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/sort_unique.h"
#include "solid/recognise/facets_saved.h"
#include "solid/recognise/fit_profile.h"
#include "solid/recognise/region_finder.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Largest numbers of triangles in a first and in a wide region around a seed.
constexpr std::size_t kMaxSeed = 600, kMaxWide = 1200;
constexpr std::size_t kFewSamples = 200, kMaxSamples = 1000;
constexpr double kMaxSpread = 0.03;  // sine: scatter of the normals about a direction or an axis
constexpr double kMaxLean = 0.08;    // sine: a single normal may deviate by this much
// tolerance of a quick first fit, as a fraction of the tolerance
constexpr double kRoughFraction = 0.2;
/// Spans are halved until their points are within this fraction of the tolerance.
constexpr double kFitFraction = 0.02;
/// Only patches whose median distance exceeds this fraction of the tolerance may give triangles to
/// a profile.
constexpr double kMinLoose = 0.02;
constexpr double kMinGain = 3;   // factor by which the profile must fit better than the patch
constexpr double kMinSaved = 8;  // facets that a patch must save
/// Triangles nearer to the axis than this many edge lengths belong to the pole and are left out.
constexpr double kMinAxisDistance = 6;

struct ProfileCandidate {
  Carrier surface;
  std::vector<std::int32_t> region;
  double area = 0, saved = 0;
};

class ProfileSeeker {
 public:
  ProfileSeeker(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                Partition& partition, RunContext& run)
      : mesh_(mesh),
        shapes_(shapes),
        tolerance_(tolerance),
        partition_(partition),
        run_(run),
        finder_(mesh, shapes),
        tried_(mesh.triangles.size(), 0) {}

  bool seek() {
    for (std::size_t p = 0; p < partition_.patches.size(); ++p)
      median_.push_back(
          medianDistance(mesh_, partition_.patches[p].surface, partition_.patches[p].triangles));
    bool any = false;
    forScattered(static_cast<std::int32_t>(mesh_.triangles.size()),
                 [&](std::int32_t, std::int32_t t) {
                   if (tried_[t] || shapes_.thin[t] || !isFree(t)) return;
                   run_.checkpoint(Phase::Export);
                   any = trySeed(t) || any;
                 });
    return any;
  }

 private:
  // Whether the triangle may join a profile: it has no patch, or its patch fits loosely and has no
  // profile.
  bool isFree(std::int32_t t) const {
    const std::int32_t p = partition_.patchOf[t];
    return p < 0 ||
           (median_[p] > kMinLoose * tolerance_ && !partition_.patches[p].surface.hasProfile());
  }

  // Grows a region breadth first over free triangles, not across creases, as far as `accepts`
  // allows.
  template <class Accepts>
  std::vector<std::int32_t> flood(std::int32_t seed, std::size_t maxCount, const Accepts& accepts) {
    return finder_.grow(seed, maxCount, [&](std::int32_t t, std::int32_t from) {
      return isFree(t) && (shapes_.thin[t] || shapes_.thin[from] || finder_.isSmooth(t, from)) &&
             accepts(t);
    });
  }

  bool trySeed(std::int32_t seed) {
    const auto all = [](std::int32_t) { return true; };
    const std::vector<std::int32_t> wide = flood(seed, kMaxWide, all);
    for (std::size_t i = 0; i < std::min(kMaxSeed, wide.size()); ++i) tried_[wide[i]] = 1;
    if (wide.size() < kMinTriangles || !finder_.bends(wide)) return false;
    std::optional<ProfileCandidate> best;
    for (const CarrierKind kind : {CarrierKind::Extrusion, CarrierKind::Revolution}) {
      std::optional<ProfileCandidate> candidate = tryKind(kind, seed, wide);
      if (candidate && (!best || candidate->area > 1.2 * best->area)) best = std::move(candidate);
    }
    if (!best) return false;
    take(*best);
    return true;
  }

  std::optional<ProfileCandidate> tryKind(CarrierKind kind, std::int32_t seed,
                                          const std::vector<std::int32_t>& wide) {
    double spread = 0;
    std::optional<Carrier> surface =
        guessAxis(kind, finder_.samplesOf(wide, kFewSamples, false), spread);
    if (!surface || spread > kMaxSpread) return std::nullopt;
    std::vector<std::int32_t> region = withinLean(*surface, seed);
    // Guesses again, now with triangles that lie farther along the axis.
    surface = guessAxis(kind, finder_.samplesOf(region, kMaxSamples, true), spread);
    if (!surface || spread > kMaxSpread) return std::nullopt;
    region = withinLean(*surface, seed);
    if (region.size() < kMinTriangles) return std::nullopt;
    ProfileCandidate candidate;
    candidate.surface = *surface;
    // A quick test first: most regions are not such a surface and need no fit to many points.
    const Samples few = finder_.samplesOf(region, kFewSamples, true);
    if (!fitAlong(few, kRoughFraction * tolerance_, candidate.surface) ||
        residuals(few, candidate.surface).median > kRoughFraction * tolerance_) {
      region.resize(std::min(region.size(), 2 * kMaxWide));
      markTried(region);
      return std::nullopt;
    }
    for (int round = 0; round < 2; ++round) {
      const Samples samples = finder_.samplesOf(region, kMaxSamples, true);
      if (!fitAlong(samples, kFitFraction * tolerance_, candidate.surface)) return std::nullopt;
      const double median = residuals(samples, candidate.surface).median;
      if (median > kExactFraction * tolerance_) return std::nullopt;
      region = grow(candidate.surface, seed,
                    std::clamp(8 * median, kExactFraction * tolerance_, tolerance_));
      if (region.size() < kMinTriangles) return std::nullopt;
    }
    markTried(region);
    candidate.region = settle(candidate.surface, region);
    return isWorthIt(candidate) ? std::optional(std::move(candidate)) : std::nullopt;
  }

  // Marks all triangles of the region, since they would give the same result as seeds.
  void markTried(const std::vector<std::int32_t>& region) {
    for (const std::int32_t t : region) tried_[t] = 1;
  }

  // Returns the typical length of an edge of a triangle, mm.
  double edgeAt(std::int32_t t) const { return 1.5 * std::sqrt(shapes_.area[t]); }

  bool isByThePole(const Carrier& surface, std::int32_t t) const {
    return surface.kind == CarrierKind::Revolution &&
           surface.inProfile(mesh_.points[mesh_.triangles[t][0]]).x() <
               std::max(kMinAxisDistance * edgeAt(t), 5 * tolerance_);
  }

  std::vector<std::int32_t> withinLean(const Carrier& surface, std::int32_t seed) {
    return flood(seed, mesh_.triangles.size(), [&](std::int32_t t) {
      if (isByThePole(surface, t)) return false;
      const double maxSine = shapes_.thin[t] ? 3 * kMaxLean : kMaxLean;
      const Vector3d& n = shapes_.normal[t];
      if (surface.kind == CarrierKind::Extrusion) return std::abs(n.dot(surface.axis)) < maxSine;
      const Vector3d out = mesh_.points[mesh_.triangles[t][0]] - surface.point;
      return std::abs(surface.axis.cross(out).normalized().dot(n)) < maxSine;
    });
  }

  bool accepts(const Carrier& surface, std::int32_t t, double tolerance) const {
    if (!liesOn(mesh_, shapes_, t, surface, tolerance, kSurfaceCosine)) return false;
    Vector3d centre = Vector3d::Zero();
    for (const std::int32_t v : mesh_.triangles[t]) centre += mesh_.points[v] / 3;
    return surface.profile->covers(surface.inProfile(centre));
  }

  std::vector<std::int32_t> grow(const Carrier& surface, std::int32_t seed, double tolerance) {
    if (!accepts(surface, seed, tolerance)) return {};
    return flood(seed, mesh_.triangles.size(), [&](std::int32_t t) {
      return !isByThePole(surface, t) && accepts(surface, t, tolerance);
    });
  }

  // Removes the triangles of patches that stay. A patch stays if part of it lies outside the
  // surface, or if its own surface fits nearly as well. Returns the largest connected piece of the
  // remaining triangles.
  std::vector<std::int32_t> settle(const Carrier& surface,
                                   const std::vector<std::int32_t>& region) {
    std::vector<std::int32_t> patches;
    for (const std::int32_t t : region) {
      if (partition_.patchOf[t] >= 0) patches.push_back(partition_.patchOf[t]);
    }
    sortUnique(patches);
    std::vector<std::int32_t> taken;
    for (const std::int32_t p : patches) {
      const std::vector<std::int32_t>& triangles = partition_.patches[p].triangles;
      const bool here = std::all_of(triangles.begin(), triangles.end(), [&](std::int32_t t) {
        return !isByThePole(surface, t) && accepts(surface, t, tolerance_);
      });
      if (here && median_[p] > kMinGain * medianDistance(mesh_, surface, triangles))
        taken.push_back(p);
    }
    std::vector<std::int32_t> kept;
    for (const std::int32_t t : region) {
      if (partition_.patchOf[t] < 0) kept.push_back(t);
    }
    for (const std::int32_t p : taken) {
      const std::vector<std::int32_t>& triangles = partition_.patches[p].triangles;
      kept.insert(kept.end(), triangles.begin(), triangles.end());
    }
    auto pieces = connectedPieces(mesh_, kept, [](std::int32_t, std::int32_t) { return true; });
    const auto bySize = [](const auto& a, const auto& b) { return a.size() < b.size(); };
    const auto largest = std::max_element(pieces.begin(), pieces.end(), bySize);
    return largest != pieces.end() ? std::move(*largest) : std::vector<std::int32_t>();
  }

  bool isWorthIt(ProfileCandidate& candidate) const {
    if (candidate.region.size() < kMinTriangles || !finder_.bends(candidate.region)) return false;
    candidate.area = areaOf(mesh_, candidate.region);
    Patch patch;
    patch.surface = candidate.surface;
    patch.triangles = candidate.region;
    candidate.saved = facetsSaved(mesh_, patch, tolerance_);
    return candidate.saved >= kMinSaved;
  }

  void take(ProfileCandidate& candidate) {
    const auto id = static_cast<std::int32_t>(partition_.patches.size());
    for (const std::int32_t t : candidate.region) {
      if (partition_.patchOf[t] < 0) continue;
      std::vector<std::int32_t>& before = partition_.patches[partition_.patchOf[t]].triangles;
      for (const std::int32_t other : before) partition_.patchOf[other] = -1;
      before.clear();
    }
    for (const std::int32_t t : candidate.region) {
      partition_.patchOf[t] = id;
      tried_[t] = 1;
    }
    median_.push_back(0);
    partition_.patches.push_back({candidate.surface, std::move(candidate.region), 0, id});
  }

  const HalfEdgeMesh& mesh_;
  const TriangleShapes& shapes_;
  double tolerance_;
  Partition& partition_;
  RunContext& run_;
  std::vector<double> median_;  // by patch, median distance in mm
  RegionFinder finder_;
  std::vector<char> tried_;
};

}  // namespace

bool seekProfiles(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                  Partition& partition, RunContext& run) {
  return ProfileSeeker(mesh, shapes, tolerance, partition, run).seek();
}

}  // namespace swept::step
