// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/seek_profile.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "solid/recognise/facets_saved.h"
#include "solid/recognise/fit_profile.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMaxSeed = 600, kMaxWide = 1200;  // triangles
constexpr std::size_t kFewSamples = 200, kMaxSamples = 1000;
constexpr double kMaxSpread = 0.03;      // sine: normals about a direction or an axis
constexpr double kMaxLean = 0.08;        // sine: a single normal
constexpr double kSmoothCosine = 0.88;   // as for seeds of simpler surfaces (seek_surface.cpp)
constexpr double kSurfaceCosine = 0.90;  // a triangle may lean by this much from its surface
constexpr double kExactFraction = 0.1;   // of the tolerance: half of the vertices must be this near
constexpr double kRoughFraction = 0.2;   // of the tolerance: the same in a quick first test
/// Of the tolerance: spans are halved until their points are this near.
constexpr double kFitFraction = 0.02;
/// Of the tolerance: a patch with a larger median distance may be taken over.
constexpr double kMinLoose = 0.02;
constexpr double kMinGain = 3;     // ... if the profile fits this much better
constexpr double kMinSaved = 8;    // facets
constexpr double kMinTurn = 0.98;  // cosine: flatter regions are planes
/// Edges: a surface nearer to the axis than this has its pole inside.
constexpr double kMinAxisDistance = 6;

struct Candidate {
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
        stampOf_(mesh.triangles.size(), 0),
        pointStamp_(mesh.points.size(), 0),
        tried_(mesh.triangles.size(), 0) {}

  bool seek() {
    for (std::size_t p = 0; p < partition_.patches.size(); ++p)
      median_.push_back(
          medianDistance(partition_.patches[p].surface, partition_.patches[p].triangles));
    const auto count = static_cast<std::int32_t>(mesh_.triangles.size());
    std::int32_t stride = static_cast<std::int32_t>(0.618 * count) | 1;
    while (std::gcd(stride, count) != 1) stride += 2;
    std::int64_t at = 0;
    bool any = false;
    for (std::int32_t i = 0; i < count; ++i, at = (at + stride) % count) {
      const auto t = static_cast<std::int32_t>(at);
      if (tried_[t] || shapes_.thin[t] || !isFree(t)) continue;
      run_.checkpoint(Phase::Export);
      any = trySeed(t) || any;
    }
    return any;
  }

 private:
  // Whether the triangle is open ground, or belongs to a patch that fits loosely.
  bool isFree(std::int32_t t) const {
    const std::int32_t p = partition_.patchOf[t];
    return p < 0 ||
           (median_[p] > kMinLoose * tolerance_ && !partition_.patches[p].surface.hasProfile());
  }

  // The median distance of the corners: a surface may have taken in some of its neighbour.
  double medianDistance(const Carrier& surface, const std::vector<std::int32_t>& triangles) const {
    if (triangles.empty()) return 0;
    std::vector<double> distances;
    distances.reserve(triangles.size());
    for (const std::int32_t t : triangles)
      distances.push_back(std::abs(surface.distance(mesh_.points[mesh_.triangles[t][0]])));
    std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
    return distances[distances.size() / 2];
  }

  // Grows breadth first over free ground, not across creases, as far as `accepts` allows.
  template <class Accepts>
  std::vector<std::int32_t> flood(std::int32_t seed, std::size_t maxCount, const Accepts& accepts) {
    ++stamp_;
    std::vector<std::int32_t> region{seed};
    stampOf_[seed] = stamp_;
    for (std::size_t i = 0; i < region.size() && region.size() < maxCount; ++i) {
      for (int k = 0; k < 3; ++k) {
        const std::int32_t other = mesh_.opposite[3 * region[i] + k] / 3;
        if (stampOf_[other] == stamp_ || !isFree(other)) continue;
        if (!shapes_.thin[other] && !shapes_.thin[region[i]] &&
            shapes_.normal[other].dot(shapes_.normal[region[i]]) < kSmoothCosine)
          continue;
        if (!accepts(other)) continue;
        stampOf_[other] = stamp_;
        region.push_back(other);
      }
    }
    return region;
  }

  // Normals of needles are unreliable, but a body may consist of needles.
  Samples samplesOf(const std::vector<std::int32_t>& region, std::size_t maxCount, bool needles) {
    ++pointMark_;
    Samples samples;
    const std::size_t stride = std::max<std::size_t>(1, region.size() / maxCount);
    for (std::size_t i = 0; i < region.size(); i += stride) {
      if (shapes_.thin[region[i]] && !needles) continue;
      for (const std::int32_t v : mesh_.triangles[region[i]]) {
        if (pointStamp_[v] == pointMark_) continue;
        pointStamp_[v] = pointMark_;
        samples.points.push_back(mesh_.points[v]);
        samples.normals.push_back(shapes_.normal[region[i]]);
      }
    }
    return samples;
  }

  bool trySeed(std::int32_t seed) {
    const auto all = [](std::int32_t) { return true; };
    const std::vector<std::int32_t> wide = flood(seed, kMaxWide, all);
    for (std::size_t i = 0; i < std::min(kMaxSeed, wide.size()); ++i) tried_[wide[i]] = 1;
    if (wide.size() < kMinTriangles || !bends(wide)) return false;
    std::optional<Candidate> best;
    for (const CarrierKind kind : {CarrierKind::Extrusion, CarrierKind::Revolution}) {
      std::optional<Candidate> candidate = tryKind(kind, seed, wide);
      if (candidate && (!best || candidate->area > 1.2 * best->area)) best = std::move(candidate);
    }
    if (!best) return false;
    take(*best);
    return true;
  }

  bool bends(const std::vector<std::int32_t>& region) const {
    const Vector3d& first = shapes_.normal[region.front()];
    return std::any_of(region.begin(), region.end(), [&](std::int32_t t) {
      return !shapes_.thin[t] && first.dot(shapes_.normal[t]) < kMinTurn;
    });
  }

  std::optional<Candidate> tryKind(CarrierKind kind, std::int32_t seed,
                                   const std::vector<std::int32_t>& wide) {
    double spread = 0;
    std::optional<Carrier> surface = guessAxis(kind, samplesOf(wide, kFewSamples, false), spread);
    if (!surface || spread > kMaxSpread) return std::nullopt;
    std::vector<std::int32_t> region = withinLean(*surface, seed);
    // Once more with the triangles that lie farther along the axis.
    surface = guessAxis(kind, samplesOf(region, kMaxSamples, true), spread);
    if (!surface || spread > kMaxSpread) return std::nullopt;
    region = withinLean(*surface, seed);
    if (region.size() < kMinTriangles) return std::nullopt;
    Candidate candidate;
    candidate.surface = *surface;
    // A quick test first: most regions are not such a surface, and no fit of many points is needed.
    const Samples few = samplesOf(region, kFewSamples, true);
    if (!fitAlong(few, kRoughFraction * tolerance_, candidate.surface) ||
        residuals(few, candidate.surface).median > kRoughFraction * tolerance_) {
      region.resize(std::min(region.size(), 2 * kMaxWide));
      markTried(region);
      return std::nullopt;
    }
    for (int round = 0; round < 2; ++round) {
      const Samples samples = samplesOf(region, kMaxSamples, true);
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

  // Seeds in this region would find the same.
  void markTried(const std::vector<std::int32_t>& region) {
    for (const std::int32_t t : region) tried_[t] = 1;
  }

  // Typical length of the edges at a triangle, mm.
  double edgeAt(std::int32_t t) const { return 1.5 * std::sqrt(shapes_.area[t]); }

  bool isByThePole(const Carrier& surface, std::int32_t t) const {
    return surface.kind == CarrierKind::Revolution &&
           surface.inProfile(mesh_.points[mesh_.triangles[t][0]]).x() <
               std::max(kMinAxisDistance * edgeAt(t), 5 * tolerance_);
  }

  std::vector<std::int32_t> withinLean(const Carrier& surface, std::int32_t seed) {
    return flood(seed, mesh_.triangles.size(), [&](std::int32_t t) {
      if (isByThePole(surface, t)) return false;
      const double maxCount = shapes_.thin[t] ? 3 * kMaxLean : kMaxLean;
      const Vector3d& n = shapes_.normal[t];
      if (surface.kind == CarrierKind::Extrusion) return std::abs(n.dot(surface.axis)) < maxCount;
      const Vector3d out = mesh_.points[mesh_.triangles[t][0]] - surface.point;
      return std::abs(surface.axis.cross(out).normalized().dot(n)) < maxCount;
    });
  }

  bool liesOn(const Carrier& surface, std::int32_t t, double tolerance) const {
    Vector3d centre = Vector3d::Zero();
    for (const std::int32_t v : mesh_.triangles[t]) {
      const Vector3d& p = mesh_.points[v];
      if (!(std::abs(surface.distance(p)) <= tolerance)) return false;
      centre += p / 3;
    }
    if (!surface.profile->covers(surface.inProfile(centre))) return false;
    return shapes_.thin[t] || surface.normal(centre).dot(shapes_.normal[t]) >= kSurfaceCosine;
  }

  std::vector<std::int32_t> grow(const Carrier& surface, std::int32_t seed, double tolerance) {
    if (!liesOn(surface, seed, tolerance)) return {};
    return flood(seed, mesh_.triangles.size(), [&](std::int32_t t) {
      return !isByThePole(surface, t) && liesOn(surface, t, tolerance);
    });
  }

  // Leaves out the triangles of patches that stay: patches that do not lie in the region as a
  // whole, and patches whose own surface fits as well.
  std::vector<std::int32_t> settle(const Carrier& surface,
                                   const std::vector<std::int32_t>& region) {
    std::vector<std::int32_t> patches;
    for (const std::int32_t t : region) {
      if (partition_.patchOf[t] >= 0) patches.push_back(partition_.patchOf[t]);
    }
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    std::vector<std::int32_t> taken;
    for (const std::int32_t p : patches) {
      const std::vector<std::int32_t>& triangles = partition_.patches[p].triangles;
      const bool here = std::all_of(triangles.begin(), triangles.end(), [&](std::int32_t t) {
        return !isByThePole(surface, t) && liesOn(surface, t, tolerance_);
      });
      if (here && median_[p] > kMinGain * medianDistance(surface, triangles)) taken.push_back(p);
    }
    std::vector<std::int32_t> kept;
    for (const std::int32_t t : region) {
      if (partition_.patchOf[t] < 0) kept.push_back(t);
    }
    for (const std::int32_t p : taken) {
      const std::vector<std::int32_t>& triangles = partition_.patches[p].triangles;
      kept.insert(kept.end(), triangles.begin(), triangles.end());
    }
    return largestPiece(kept);
  }

  std::vector<std::int32_t> largestPiece(const std::vector<std::int32_t>& triangles) {
    const std::int32_t open = ++stamp_, seen = ++stamp_;
    for (const std::int32_t t : triangles) stampOf_[t] = open;
    std::vector<std::int32_t> best;
    for (const std::int32_t first : triangles) {
      if (stampOf_[first] != open) continue;
      std::vector<std::int32_t> piece{first};
      stampOf_[first] = seen;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
          const std::int32_t other = mesh_.opposite[3 * piece[i] + k] / 3;
          if (stampOf_[other] != open) continue;
          stampOf_[other] = seen;
          piece.push_back(other);
        }
      }
      if (piece.size() > best.size()) best.swap(piece);
    }
    return best;
  }

  bool isWorthIt(Candidate& candidate) const {
    if (candidate.region.size() < kMinTriangles || !bends(candidate.region)) return false;
    for (const std::int32_t t : candidate.region) candidate.area += shapes_.area[t];
    Patch patch;
    patch.surface = candidate.surface;
    patch.triangles = candidate.region;
    candidate.saved = facetsSaved(mesh_, patch, tolerance_);
    return candidate.saved >= kMinSaved;
  }

  void take(Candidate& candidate) {
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
  std::vector<double> median_;  // per patch, mm
  std::vector<std::int32_t> stampOf_, pointStamp_;
  std::int32_t stamp_ = 0, pointMark_ = 0;
  std::vector<char> tried_;
};

}  // namespace

bool seekProfiles(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                  Partition& partition, RunContext& run) {
  return ProfileSeeker(mesh, shapes, tolerance, partition, run).seek();
}

}  // namespace swept::step
