// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/seek_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kSeedTriangles = 60;       // size of the first guess
constexpr int kMaxSeedTriangles = 4000;  // and of the largest
constexpr double kCreaseCosine = 0.88;   // seeds do not cross edges sharper than about 28 degrees
constexpr double kSurfaceCosine =
    0.90;                             // a triangle may lean this much (26 degrees) from its surface
constexpr double kMinFraction = 0.1;  // of the tolerance; this much is always allowed
constexpr double kExactFraction =
    0.1;  // of the tolerance: how closely half of the vertices must lie
constexpr int kRimRings = 3;
constexpr std::size_t kFewSamples = 80;  // for a first guess; most guesses fail
constexpr double kMinMore = 1.25;        // a more complicated surface must cover this much more
constexpr double kMinMuchMore = 4;       // and this much more if it fits less exactly

constexpr std::array<CarrierKind, 5> kKinds{CarrierKind::Plane, CarrierKind::Cylinder,
                                            CarrierKind::Sphere, CarrierKind::Cone,
                                            CarrierKind::Torus};

// A later candidate must cover more area; much more if it fits less exactly.
bool isBetter(const Candidate& next, const Candidate& best, double tolerance) {
  const bool exact = next.median <= 3 * best.median + 0.02 * tolerance;
  return next.area > (exact ? kMinMore : kMinMuchMore) * best.area;
}

}  // namespace

SurfaceSeeker::SurfaceSeeker(const HalfEdgeMesh& mesh, const TriangleShapes& shapes,
                             double tolerance, const Partition& partition)
    : mesh_(mesh),
      normal_(shapes.normal),
      area_(shapes.area),
      thin_(shapes.thin),
      tolerance_(tolerance),
      partition_(partition),
      stampOf_(mesh.triangles.size(), 0),
      pointStamp_(mesh.points.size(), 0) {}

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
  ++stamp_;
  std::vector<std::int32_t> region{seed};
  stampOf_[seed] = stamp_;
  for (std::size_t i = 0; i < region.size() && region.size() < size; ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t other = mesh_.opposite[3 * region[i] + k] / 3;
      if (stampOf_[other] == stamp_ || partition_.patchOf[other] >= 0 || thin_[other]) continue;
      if (normal_[other].dot(normal_[region[i]]) < kCreaseCosine) continue;
      stampOf_[other] = stamp_;
      region.push_back(other);
    }
  }
  return region;
}

// One sample per vertex, with the mean normal of the region's triangles there.
Samples SurfaceSeeker::samplesOf(const std::vector<std::int32_t>& region) {
  ++pointMark_;
  Samples samples;
  const std::size_t stride = std::max<std::size_t>(1, region.size() / 400);
  for (std::size_t i = 0; i < region.size(); i += stride) {
    const std::int32_t t = region[i];
    for (const std::int32_t v : mesh_.triangles[t]) {
      if (pointStamp_[v] >= pointMark_) {
        continue;
      }
      pointStamp_[v] = pointMark_;
      samples.points.push_back(mesh_.points[v]);
      samples.normals.push_back(normal_[t]);
    }
  }
  return samples;
}

bool SurfaceSeeker::accepts(std::int32_t t, const Carrier& surface, double tolerance) const {
  if (partition_.patchOf[t] >= 0) return false;
  Vector3d centre = Vector3d::Zero();
  for (const std::int32_t v : mesh_.triangles[t]) {
    if (!(std::abs(surface.distance(mesh_.points[v])) <= tolerance)) return false;
    centre += mesh_.points[v] / 3;
  }
  return thin_[t] || surface.normal(centre).dot(normal_[t]) >= kSurfaceCosine;
}

// Grows breadth first; the surface is fitted again when the region has reached refitAt, and each
// time it has doubled.
std::vector<std::int32_t> SurfaceSeeker::grow(std::int32_t seed, Carrier& surface, double tolerance,
                                              std::size_t refitAt) {
  ++stamp_;
  std::vector<std::int32_t> region;
  if (!accepts(seed, surface, tolerance)) return region;
  region.push_back(seed);
  stampOf_[seed] = stamp_;
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t other = mesh_.opposite[3 * region[i] + k] / 3;
      if (stampOf_[other] == stamp_ || !accepts(other, surface, tolerance)) continue;
      stampOf_[other] = stamp_;
      region.push_back(other);
    }
    if (region.size() >= refitAt) {
      const Samples samples = samplesOf(region);
      refineSurface(samples, surface);
      // It is not this kind of surface; stop growing.
      if (residuals(samples, surface).median > 2 * kExactFraction * tolerance_) return region;
      refitAt = 2 * region.size();
    }
  }
  return region;
}

double SurfaceSeeker::areaOf(const std::vector<std::int32_t>& region) const {
  double sum = 0;
  for (const std::int32_t t : region) sum += area_[t];
  return sum;
}

std::optional<Candidate> SurfaceSeeker::tryKind(CarrierKind kind, std::int32_t seed,
                                                const Samples& first) {
  std::optional<Carrier> surface = guessSurface(kind, first);
  if (!surface) return std::nullopt;
  refineSurface(first, *surface, kFewSamples);
  const Residuals start = residuals(first, *surface);
  if (start.largest > tolerance_ || start.median > 2 * kExactFraction * tolerance_)
    return std::nullopt;
  Candidate candidate;
  candidate.surface = *surface;
  candidate.region = grow(seed, candidate.surface, tolerance_, 2 * first.points.size());
  // Reduce the tolerance to what the surface really needs, so that it does not run on into its
  // neighbours.
  std::size_t before = 0;
  for (int round = 0; round < 8; ++round) {
    if (candidate.region.size() < 4) return std::nullopt;
    if (round > 2 && candidate.region.size() < before + before / 20) break;
    before = candidate.region.size();
    const Samples samples = samplesOf(candidate.region);
    refineSurface(samples, candidate.surface);
    candidate.median = residuals(samples, candidate.surface).median;
    if (candidate.median > 2 * kExactFraction * tolerance_) break;
    candidate.region =
        grow(seed, candidate.surface, tightOf(candidate.median), candidate.region.size() * 5 / 4);
  }
  // The same surface need not be tried again from any seed in this region.
  found_.tried.emplace_back(kind, candidate.region);
  if (std::find(candidate.region.begin(), candidate.region.end(), seed_) !=
      candidate.region.end()) {
    triedAtSeed_ = static_cast<char>(triedAtSeed_ | bitOf(kind));
  }
  if (!isWorthIt(candidate)) return std::nullopt;
  addRim(candidate);
  candidate.area = areaOf(candidate.region);
  return candidate;
}

double SurfaceSeeker::tightOf(double median) const {
  return std::clamp(8 * median, kMinFraction * tolerance_, tolerance_);
}

// Adds a few rings at the full tolerance: near creases the mesh is less exact than inside the
// region.
void SurfaceSeeker::addRim(Candidate& candidate) {
  std::size_t from = 0;
  for (int ring = 0; ring < kRimRings; ++ring) {
    const std::size_t to = candidate.region.size();
    for (std::size_t i = from; i < to; ++i) {
      for (int k = 0; k < 3; ++k) {
        const std::int32_t other = mesh_.opposite[3 * candidate.region[i] + k] / 3;
        if (stampOf_[other] == stamp_ || !accepts(other, candidate.surface, tolerance_)) continue;
        stampOf_[other] = stamp_;
        candidate.region.push_back(other);
      }
    }
    from = ring == 0 ? 0 : to;
  }
}

bool SurfaceSeeker::isWorthIt(const Candidate& candidate) const {
  if (candidate.surface.kind == CarrierKind::Plane) {
    return candidate.region.size() >= 4 && candidate.median <= kExactFraction * tolerance_;
  }
  if (candidate.region.size() < kMinTriangles) return false;
  // Many free forms come within the tolerance of some surface; only one that fits much better is
  // recognised.
  if (candidate.median > kExactFraction * tolerance_) return false;
  // The normals must turn enough to distinguish the surface from a plane.
  const Vector3d first = normal_[candidate.region.front()];
  double smallest = 1;
  for (const std::int32_t t : candidate.region) {
    if (!thin_[t]) smallest = std::min(smallest, first.dot(normal_[t]));
  }
  return smallest < 0.98;
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
  // A round body made of plane strips shows its curvature only in a wider region.
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

// Large plane areas at small angles also fit a wide curved surface; if the planes fit much better,
// they are preferred.
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
