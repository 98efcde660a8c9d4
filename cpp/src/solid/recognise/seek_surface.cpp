// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/seek_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swept::step {
namespace {

constexpr int kSeedTriangles = 60;       // number of triangles for the first guess
constexpr int kMaxSeedTriangles = 4000;  // number of triangles for the largest guess
constexpr double kMinFraction = 0.1;     // smallest fraction to which the tolerance is reduced
constexpr int kRimRings = 3;
// number of samples for a first guess; few, since most guesses fail
constexpr std::size_t kGuessSamples = 80;
// factor by which a more complicated surface must cover more area
constexpr double kMinMore = 1.25;
constexpr double kMinMuchMore = 4;  // the same for a surface that fits less exactly

constexpr std::array<CarrierKind, 5> kKinds{CarrierKind::Plane, CarrierKind::Cylinder,
                                            CarrierKind::Sphere, CarrierKind::Cone,
                                            CarrierKind::Torus};

// Whether a later candidate covers enough more area than the best one. If it fits less exactly, it
// must cover much more.
bool isBetter(const Candidate& next, const Candidate& best, double tolerance) {
  const bool exact = next.median <= 3 * best.median + 0.02 * tolerance;
  return next.area > (exact ? kMinMore : kMinMuchMore) * best.area;
}

}  // namespace

SurfaceSeeker::SurfaceSeeker(const HalfEdgeMesh& mesh, const TriangleShapes& shapes,
                             double tolerance, const Partition& partition)
    : mesh_(mesh),
      shapes_(shapes),
      tolerance_(tolerance),
      partition_(partition),
      finder_(mesh, shapes) {}

Found SurfaceSeeker::seek(std::int32_t seed, char tried) {
  found_ = {};
  seed_ = seed;
  triedAtSeed_ = tried;
  found_.best = bestSurface(seed, seedRegion(seed, kSeedTriangles));
  if (!found_.best) {
    const auto size = std::clamp<std::size_t>(mesh_.triangles.size() / 150, kSeedTriangles, 1600);
    found_.fruitless = seedRegion(seed, size);
  }
  return std::move(found_);
}

std::vector<std::int32_t> SurfaceSeeker::seedRegion(std::int32_t seed, std::size_t size) {
  return finder_.grow(seed, size, [&](std::int32_t t, std::int32_t from) {
    return partition_.patchOf[t] < 0 && !shapes_.thin[t] && finder_.isSmooth(t, from);
  });
}

Samples SurfaceSeeker::samplesOf(const std::vector<std::int32_t>& region) {
  return finder_.samplesOf(region, 400, true);
}

bool SurfaceSeeker::accepts(std::int32_t t, const Carrier& surface, double tolerance) const {
  return partition_.patchOf[t] < 0 && liesOn(mesh_, shapes_, t, surface, tolerance, kSurfaceCosine);
}

// Grows breadth first. Fits the surface again when the region has reached `refitAt` triangles, and
// then each time it has doubled.
std::vector<std::int32_t> SurfaceSeeker::grow(std::int32_t seed, Carrier& surface, double tolerance,
                                              std::size_t refitAt) {
  if (!accepts(seed, surface, tolerance)) return {};
  std::vector<std::int32_t> region = finder_.start(seed);
  for (std::size_t i = 0; i < region.size(); ++i) {
    finder_.extend(region, i, i + 1,
                   [&](std::int32_t t, std::int32_t) { return accepts(t, surface, tolerance); });
    if (region.size() >= refitAt) {
      const Samples samples = samplesOf(region);
      refineSurface(samples, surface);
      // The surface is not of this kind, so growing stops.
      if (residuals(samples, surface).median > 2 * kExactFraction * tolerance_) return region;
      refitAt = 2 * region.size();
    }
  }
  return region;
}

std::optional<Candidate> SurfaceSeeker::tryKind(CarrierKind kind, std::int32_t seed,
                                                const Samples& first) {
  std::optional<Carrier> surface = guessSurface(kind, first);
  if (!surface) return std::nullopt;
  refineSurface(first, *surface, kGuessSamples);
  const Residuals start = residuals(first, *surface);
  if (start.largest > tolerance_ || start.median > 2 * kExactFraction * tolerance_)
    return std::nullopt;
  Candidate candidate;
  candidate.surface = *surface;
  candidate.region = grow(seed, candidate.surface, tolerance_, 2 * first.points.size());
  // Reduces the tolerance to what the surface really needs, so that the region does not grow into
  // neighbouring surfaces.
  std::size_t before = 0;
  for (int round = 0; round < 8; ++round) {
    if (candidate.region.size() < 4) return std::nullopt;
    if (round > 2 && candidate.region.size() < before + before / 20) break;
    before = candidate.region.size();
    const Samples samples = samplesOf(candidate.region);
    refineSurface(samples, candidate.surface);
    candidate.median = residuals(samples, candidate.surface).median;
    if (candidate.median > 2 * kExactFraction * tolerance_) break;
    candidate.region = grow(seed, candidate.surface, tightTolerance(candidate.median),
                            candidate.region.size() * 5 / 4);
  }
  // No seed in this region needs to try this kind again.
  found_.tried.emplace_back(kind, candidate.region);
  if (std::find(candidate.region.begin(), candidate.region.end(), seed_) !=
      candidate.region.end()) {
    triedAtSeed_ = static_cast<char>(triedAtSeed_ | bitOf(kind));
  }
  if (!isWorthIt(candidate)) return std::nullopt;
  addRim(candidate);
  candidate.area = areaOf(mesh_, candidate.region);
  return candidate;
}

double SurfaceSeeker::tightTolerance(double median) const {
  return std::clamp(8 * median, kMinFraction * tolerance_, tolerance_);
}

// Adds a few rings with the full tolerance, since the mesh is less exact near creases than inside
// the region.
void SurfaceSeeker::addRim(Candidate& candidate) {
  std::size_t from = 0;
  for (int ring = 0; ring < kRimRings; ++ring) {
    const std::size_t to = candidate.region.size();
    finder_.extend(candidate.region, from, to, [&](std::int32_t t, std::int32_t) {
      return accepts(t, candidate.surface, tolerance_);
    });
    from = ring == 0 ? 0 : to;
  }
}

bool SurfaceSeeker::isWorthIt(const Candidate& candidate) const {
  if (candidate.surface.kind == CarrierKind::Plane) {
    return candidate.region.size() >= 4 && candidate.median <= kExactFraction * tolerance_;
  }
  if (candidate.region.size() < kMinTriangles) return false;
  // Many free forms come within the tolerance of some surface. Only a surface that fits much better
  // is accepted.
  return candidate.median <= kExactFraction * tolerance_ && finder_.bends(candidate.region);
}

std::optional<Candidate> SurfaceSeeker::bestSurface(std::int32_t seed,
                                                    const std::vector<std::int32_t>& around) {
  if (around.size() < 4) return std::nullopt;
  std::optional<Candidate> best;
  auto tryAll = [&](const Samples& samples) {
    for (const CarrierKind kind : kKinds) {
      if ((triedAtSeed_ & bitOf(kind)) != 0) continue;
      std::optional<Candidate> candidate = tryKind(kind, seed, samples);
      if (!candidate) continue;
      if (!best || isBetter(*candidate, *best, tolerance_)) best = std::move(candidate);
    }
  };
  tryAll(samplesOf(around));
  // A round body made of plane strips shows its curvature only in a larger region.
  for (int scale = 0; scale < 2; ++scale) {
    if (best && best->surface.kind != CarrierKind::Plane) break;
    const std::size_t size =
        std::max<std::size_t>(6 * around.size() << (2 * scale), best ? 3 * best->region.size() : 0);
    if (size > kMaxSeedTriangles) break;
    const std::vector<std::int32_t> wider = seedRegion(seed, size);
    if (wider.size() < size / 2) break;
    tryAll(samplesOf(wider));
  }
  if (best && best->surface.kind != CarrierKind::Plane) preferFlats(*best);
  return best;
}

// Replaces a wide curved surface by a plane if the plane fits much better. A wide curved surface
// also fits large planes that meet at small angles.
void SurfaceSeeker::preferFlats(Candidate& best) {
  for (int i = 1; i < 6; ++i) {
    const std::int32_t seed = best.region[best.region.size() * i / 6];
    std::optional<Candidate> flat =
        tryKind(CarrierKind::Plane, seed, samplesOf(seedRegion(seed, 16)));
    if (!flat || flat->median > 0.1 * best.median || flat->area < 0.1 * best.area) continue;
    best = std::move(*flat);
    return;
  }
}

}  // namespace swept::step
