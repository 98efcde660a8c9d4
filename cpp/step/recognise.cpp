// SPDX-License-Identifier: LGPL-2.1-or-later
#include "recognise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "fit.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kSeedTriangles = 60;      // size of the first guess
constexpr int kLargestSeed = 4000;      // and of the largest
constexpr int kLeastTriangles = 24;     // a curved patch smaller than this stays facets
constexpr double kCreaseCosine = 0.88;  // seeds do not cross edges sharper than about 28 degrees
constexpr double kSurfaceCosine =
    0.90;                            // a triangle may lean this much (26 degrees) from its surface
constexpr double kLeastShare = 0.1;  // of the tolerance, that is always allowed
constexpr double kExactShare = 0.1;  // of the tolerance: how closely half of the vertices must lie
constexpr int kRimRings = 3;
constexpr double kWorthMore = 1.25;   // a more complicated surface must cover this much more
constexpr double kWorthMuchMore = 4;  // and this much more if it fits less exactly

constexpr std::array<SurfaceKind, 5> kKinds{SurfaceKind::Plane, SurfaceKind::Cylinder,
                                            SurfaceKind::Sphere, SurfaceKind::Cone,
                                            SurfaceKind::Torus};

constexpr char bitOf(SurfaceKind kind) { return static_cast<char>(1 << static_cast<int>(kind)); }
constexpr char kAllTried = static_cast<char>(
    bitOf(SurfaceKind::Plane) | bitOf(SurfaceKind::Cylinder) | bitOf(SurfaceKind::Cone) |
    bitOf(SurfaceKind::Sphere) | bitOf(SurfaceKind::Torus));

struct Candidate {
  Surface surface;
  std::vector<std::int32_t> region;
  double area = 0;
  double median = 0;  // mm, of the distances of its vertices
};

class Recogniser {
 public:
  Recogniser(const HalfEdgeMesh& mesh, double tolerance, Partition& partition, RunContext& run)
      : mesh_(mesh), tolerance_(tolerance), partition_(partition), run_(run) {
    const std::size_t count = mesh.triangles.size();
    normal_.resize(count);
    area_.resize(count);
    thin_.resize(count);
    for (std::size_t t = 0; t < count; ++t) {
      const Vector3d vector = mesh.areaVector(static_cast<std::int32_t>(t));
      const double twice = vector.norm();
      double longest = 0;
      for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (mesh.points[mesh.triangles[t][k]] -
                                     mesh.points[mesh.triangles[t][(k + 1) % 3]])
                                        .norm());
      }
      area_[t] = 0.5 * twice;
      normal_[t] = twice > 0 ? Vector3d(vector / twice) : Vector3d::Zero();
      thin_[t] = twice < 0.05 * longest * longest;
    }
    stampOf_.assign(count, 0);
    pointStamp_.assign(mesh.points.size(), 0);
  }

  void recognise() {
    const auto count = static_cast<std::int32_t>(mesh_.triangles.size());
    tried_.assign(count, 0);
    // Seeds in a fixed scattered order: neighbours in the list are neighbours on the mesh.
    std::int32_t stride = static_cast<std::int32_t>(0.618 * count) | 1;
    while (std::gcd(stride, count) != 1) stride += 2;
    std::int64_t at = 0;
    for (std::int32_t i = 0; i < count; ++i, at = (at + stride) % count) {
      const auto seed = static_cast<std::int32_t>(at);
      if ((i & 255) == 0) run_.checkpoint(Phase::Export, i, 12ULL * count);
      if (tried_[seed] == kAllTried || partition_.patchOf[seed] >= 0 || thin_[seed]) continue;
      const std::vector<std::int32_t> around = seedRegion(seed, kSeedTriangles);
      std::optional<Candidate> best = bestSurface(seed, around);
      if (best) {
        accept(*best);
      } else {
        const auto fruitless = std::clamp<std::size_t>(count / 1500, kSeedTriangles, 400);
        for (const std::int32_t t : seedRegion(seed, fruitless)) tried_[t] = kAllTried;
      }
    }
    absorbLeftovers();
    mergePatches();
    absorbLeftovers();
    fillHoles();
  }

 private:
  std::vector<std::int32_t> seedRegion(std::int32_t seed, std::size_t size) {
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

  // One sample a vertex, with the mean normal of the region's triangles there.
  Samples samplesOf(const std::vector<std::int32_t>& region) {
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

  bool accepts(std::int32_t t, const Surface& surface, double tolerance) const {
    if (partition_.patchOf[t] >= 0) return false;
    Vector3d centre = Vector3d::Zero();
    for (const std::int32_t v : mesh_.triangles[t]) {
      if (!(std::abs(surface.distance(mesh_.points[v])) <= tolerance)) return false;
      centre += mesh_.points[v] / 3;
    }
    return thin_[t] || surface.normal(centre).dot(normal_[t]) >= kSurfaceCosine;
  }

  // Breadth first; the surface follows when the region has reached refitAt, and each time it has
  // doubled.
  std::vector<std::int32_t> grow(std::int32_t seed, Surface& surface, double tolerance,
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
        // Not this surface after all: no use in following it further.
        if (residuals(samples, surface).median > 2 * kExactShare * tolerance_) return region;
        refitAt = 2 * region.size();
      }
    }
    return region;
  }

  double areaOf(const std::vector<std::int32_t>& region) const {
    double sum = 0;
    for (const std::int32_t t : region) sum += area_[t];
    return sum;
  }

  std::optional<Candidate> tryKind(SurfaceKind kind, std::int32_t seed, const Samples& first) {
    std::optional<Surface> surface = guessSurface(kind, first);
    if (!surface) return std::nullopt;
    refineSurface(first, *surface);
    const Residuals start = residuals(first, *surface);
    if (start.largest > tolerance_ || start.median > 2 * kExactShare * tolerance_)
      return std::nullopt;
    Candidate candidate;
    candidate.surface = *surface;
    candidate.region = grow(seed, candidate.surface, tolerance_, 2 * first.points.size());
    // Tighten to what the surface really reaches, so that it does not run on into its neighbours.
    std::size_t before = 0;
    for (int round = 0; round < 8; ++round) {
      if (candidate.region.size() < 4) return std::nullopt;
      if (round > 2 && candidate.region.size() < before + before / 20) break;
      before = candidate.region.size();
      const Samples samples = samplesOf(candidate.region);
      refineSurface(samples, candidate.surface);
      candidate.median = residuals(samples, candidate.surface).median;
      if (candidate.median > 2 * kExactShare * tolerance_) break;
      const double tight = std::clamp(8 * candidate.median, kLeastShare * tolerance_, tolerance_);
      candidate.region = grow(seed, candidate.surface, tight, candidate.region.size() * 5 / 4);
    }
    // The same surface need not be tried again from anywhere in here.
    for (const std::int32_t t : candidate.region)
      tried_[t] = static_cast<char>(tried_[t] | bitOf(kind));
    if (!isWorthIt(candidate)) return std::nullopt;
    addRim(candidate);
    candidate.area = areaOf(candidate.region);
    return candidate;
  }

  // A few rings at the full tolerance: near creases the mesh is less exact than inside the region.
  void addRim(Candidate& candidate) {
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

  bool isWorthIt(const Candidate& candidate) const {
    if (candidate.surface.kind == SurfaceKind::Plane) {
      return candidate.region.size() >= 4 && candidate.median <= kExactShare * tolerance_;
    }
    if (candidate.region.size() < kLeastTriangles) return false;
    // Many a free form comes within the tolerance of something; only what fits far better is
    // recognised.
    if (candidate.median > kExactShare * tolerance_) return false;
    // Enough turn of the normals to tell the surface from a plane.
    const Vector3d first = normal_[candidate.region.front()];
    double least = 1;
    for (const std::int32_t t : candidate.region) {
      if (!thin_[t]) least = std::min(least, first.dot(normal_[t]));
    }
    return least < 0.98;
  }

  // A later candidate must cover more; much more if it fits less exactly.
  static bool isBetter(const Candidate& next, const Candidate& best, double tolerance) {
    const bool exact = next.median <= 3 * best.median + 0.02 * tolerance;
    return next.area > (exact ? kWorthMore : kWorthMuchMore) * best.area;
  }

  std::optional<Candidate> bestSurface(std::int32_t seed, const std::vector<std::int32_t>& around) {
    if (around.size() < 4) return std::nullopt;
    std::optional<Candidate> best;
    auto tryAll = [&](const Samples& samples) {
      for (const SurfaceKind kind : kKinds) {
        if ((tried_[seed] & bitOf(kind)) != 0) continue;
        std::optional<Candidate> candidate = tryKind(kind, seed, samples);
        if (!candidate) continue;
        if (!best || isBetter(*candidate, *best, tolerance_)) best = std::move(candidate);
      }
    };
    tryAll(samplesOf(around));
    // A round body made of flats shows its curvature only in a wider view.
    for (int scale = 0; scale < 2; ++scale) {
      if (best && best->surface.kind != SurfaceKind::Plane) break;
      const std::size_t size = std::max<std::size_t>(6 * around.size() << (2 * scale),
                                                     best ? 3 * best->region.size() : 0);
      if (size > kLargestSeed) break;
      const std::vector<std::int32_t> wider = seedRegion(seed, size);
      if (wider.size() < size / 2) break;
      tryAll(samplesOf(wider));
    }
    if (best && best->surface.kind != SurfaceKind::Plane) preferFlats(*best);
    return best;
  }

  // Large flats at small angles also fit a wide curved surface; where they fit far better, they
  // win.
  void preferFlats(Candidate& best) {
    for (int i = 1; i < 6; ++i) {
      const std::int32_t seed = best.region[best.region.size() * i / 6];
      std::optional<Candidate> flat =
          tryKind(SurfaceKind::Plane, seed, samplesOf(seedRegion(seed, 16)));
      if (!flat || flat->median > 0.1 * best.median || flat->area < 0.1 * best.area) continue;
      best = std::move(*flat);
      return;
    }
  }

  void accept(Candidate& candidate) {
    const auto id = static_cast<std::int32_t>(partition_.patches.size());
    for (const std::int32_t t : candidate.region) partition_.patchOf[t] = id;
    Patch patch;
    patch.surface = candidate.surface;
    patch.surfaceId = id;
    patch.triangles = std::move(candidate.region);
    partition_.patches.push_back(std::move(patch));
  }

  // Unassigned triangles beside a patch go to it while their corners lie on its surface; repeated,
  // so that strips along creases close. Thin ones may lean as they like.
  void absorbLeftovers() {
    std::vector<std::int32_t> front;
    for (std::size_t t = 0; t < partition_.patchOf.size(); ++t) {
      if (partition_.patchOf[t] < 0) front.push_back(static_cast<std::int32_t>(t));
    }
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<std::int32_t> rest;
      for (const std::int32_t t : front) {
        std::int32_t best = -1;
        double least = tolerance_;
        for (int k = 0; k < 3; ++k) {
          const std::int32_t patch = partition_.patchOf[mesh_.opposite[3 * t + k] / 3];
          if (patch < 0) continue;
          const Surface& surface = partition_.patches[patch].surface;
          double worst = 0;
          Vector3d centre = Vector3d::Zero();
          for (const std::int32_t v : mesh_.triangles[t]) {
            worst = std::max(worst, std::abs(surface.distance(mesh_.points[v])));
            centre += mesh_.points[v] / 3;
          }
          if (!thin_[t] && surface.normal(centre).dot(normal_[t]) < 0.5) continue;
          if (worst <= least) {
            least = worst;
            best = patch;
          }
        }
        if (best < 0) {
          rest.push_back(t);
          continue;
        }
        partition_.patchOf[t] = best;
        partition_.patches[best].triangles.push_back(t);
        changed = true;
      }
      front.swap(rest);
    }
  }

  // Small islands inside one patch go to it if their corners lie on its surface, however they lean.
  void fillHoles() {
    std::vector<char> seen(mesh_.triangles.size(), 0);
    for (std::size_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (seen[first]) continue;
      const std::int32_t own = partition_.patchOf[first];
      if (own >= 0 && partition_.patches[own].triangles.size() > kLeastTriangles) continue;
      std::vector<std::int32_t> island{static_cast<std::int32_t>(first)};
      seen[first] = 1;
      std::int32_t around = -1;
      bool mixed = false;
      for (std::size_t i = 0; i < island.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
          const std::int32_t t = mesh_.opposite[3 * island[i] + k] / 3;
          if (partition_.patchOf[t] == own) {
            if (!seen[t]) island.push_back(t);
            seen[t] = 1;
          } else {
            mixed = mixed || partition_.patchOf[t] < 0 ||
                    (around >= 0 && around != partition_.patchOf[t]);
            around = partition_.patchOf[t];
          }
        }
      }
      if (mixed || around < 0 || island.size() > kLeastTriangles) continue;
      const Surface& surface = partition_.patches[around].surface;
      const bool near = std::all_of(island.begin(), island.end(), [&](std::int32_t t) {
        return std::all_of(mesh_.triangles[t].begin(), mesh_.triangles[t].end(),
                           [&](std::int32_t v) {
                             return std::abs(surface.distance(mesh_.points[v])) <= tolerance_;
                           });
      });
      if (!near) continue;
      if (own >= 0) partition_.patches[own].triangles.clear();
      for (const std::int32_t t : island) {
        partition_.patchOf[t] = around;
        partition_.patches[around].triangles.push_back(t);
      }
    }
    dropEmptyPatches();
  }

  bool liesOn(const std::vector<std::int32_t>& triangles, const Surface& surface) const {
    for (const std::int32_t t : triangles) {
      Vector3d centre = Vector3d::Zero();
      for (const std::int32_t v : mesh_.triangles[t]) {
        if (!(std::abs(surface.distance(mesh_.points[v])) <= tolerance_)) return false;
        centre += mesh_.points[v] / 3;
      }
      if (!thin_[t] && surface.normal(centre).dot(normal_[t]) < 0.5) return false;
    }
    return true;
  }

  // Pieces of one surface that were found apart become one patch, the smaller joining the larger.
  void mergePatches() {
    std::vector<std::int32_t> order(partition_.patches.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return partition_.patches[a].triangles.size() < partition_.patches[b].triangles.size();
    });
    for (const std::int32_t p : order) {
      std::vector<std::int32_t> neighbours;
      for (const std::int32_t t : partition_.patches[p].triangles) {
        for (int k = 0; k < 3; ++k) {
          const std::int32_t q = partition_.patchOf[mesh_.opposite[3 * t + k] / 3];
          if (q >= 0 && q != p) neighbours.push_back(q);
        }
      }
      std::sort(neighbours.begin(), neighbours.end());
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      std::int32_t best = -1;
      for (const std::int32_t q : neighbours) {
        const std::size_t size = partition_.patches[q].triangles.size();
        if (size < partition_.patches[p].triangles.size()) continue;
        if (best >= 0 && size <= partition_.patches[best].triangles.size()) continue;
        if (liesOn(partition_.patches[p].triangles, partition_.patches[q].surface)) best = q;
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
  double tolerance_;
  Partition& partition_;
  RunContext& run_;
  std::vector<char> tried_;  // kinds that failed here, as bits
  std::vector<Vector3d> normal_;
  std::vector<double> area_;
  std::vector<char> thin_;
  std::vector<std::int32_t> stampOf_, pointStamp_;
  std::int32_t stamp_ = 0, pointMark_ = 0;
};

// --- cutting

Vector3d centreOf(const HalfEdgeMesh& mesh, std::int32_t t) {
  const auto& tri = mesh.triangles[t];
  return (mesh.points[tri[0]] + mesh.points[tri[1]] + mesh.points[tri[2]]) / 3;
}

// Largest free range of an angle, and the middle of it.
double largestGap(std::vector<double> angles, double& middle) {
  std::sort(angles.begin(), angles.end());
  double gap = 2 * M_PI - angles.back() + angles.front();
  middle = angles.back() + gap / 2;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] - angles[i - 1] > gap) {
      gap = angles[i] - angles[i - 1];
      middle = angles[i - 1] + gap / 2;
    }
  }
  return gap;
}

constexpr double kWantedGap = 1.2;  // rad: room for the seam outside the face

class Cutter {
 public:
  Cutter(const HalfEdgeMesh& mesh, Partition& partition) : mesh_(mesh), partition_(partition) {}

  void cutAll() {
    const auto count = static_cast<std::int32_t>(partition_.patches.size());
    for (std::int32_t p = 0; p < count; ++p) cut(p);
  }

 private:
  static double angle(const Vector3d& d, const Vector3d& x, const Vector3d& y) {
    return std::atan2(d.dot(y), d.dot(x));
  }

  // Turns the surface's reference direction so that its seam lies in the largest gap. True if it
  // fits.
  bool placeSeam(Patch& patch) const {
    Surface& s = patch.surface;
    if (s.isPlanar()) return true;
    if (s.kind == SurfaceKind::Sphere) return placePoles(patch);
    const Vector3d x = anyOrthogonal(s.axis), y = s.axis.cross(x);
    std::vector<double> turn, tube;
    for (const std::int32_t t : patch.triangles) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        const Vector3d d = mesh_.points[v] - s.point;
        turn.push_back(angle(d, x, y));
        const double along = d.dot(s.axis);
        tube.push_back(std::atan2(along, (d - along * s.axis).norm() - s.radius));
      }
    }
    double middle = 0;
    bool fits = largestGap(turn, middle) > kWantedGap;
    s.xdir = std::cos(middle) * x + std::sin(middle) * y;
    if (s.kind == SurfaceKind::Torus) {
      fits = fits && largestGap(tube, middle) > kWantedGap;
      s.tubeMid = middle + M_PI;
    }
    return fits;
  }

  bool placePoles(Patch& patch) const {
    Surface& s = patch.surface;
    std::vector<Vector3d> directions;
    for (const std::int32_t t : patch.triangles) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        directions.push_back((mesh_.points[v] - s.point).normalized());
      }
    }
    const std::size_t stride = std::max<std::size_t>(1, directions.size() / 3000);
    constexpr int kDirections = 200;
    double best = 1;
    for (int i = 0; i < kDirections; ++i) {
      const double z = (i + 0.5) / kDirections, phi = 2.399963229728653 * i;
      const double r = std::sqrt(1 - z * z);
      const Vector3d axis(r * std::cos(phi), r * std::sin(phi), z);
      double nearest = 0;
      for (std::size_t k = 0; k < directions.size(); k += stride) {
        nearest = std::max(nearest, std::abs(directions[k].dot(axis)));
      }
      if (nearest < best) {
        best = nearest;
        s.axis = axis;
      }
    }
    const Vector3d x = anyOrthogonal(s.axis), y = s.axis.cross(x);
    std::vector<double> turn;
    for (const Vector3d& d : directions) turn.push_back(angle(d, x, y));
    double middle = 0;
    const bool fits = largestGap(turn, middle) > kWantedGap && best < 0.97;
    s.xdir = std::cos(middle) * x + std::sin(middle) * y;
    return fits;
  }

  // The planes by which a patch of this surface may be cut, in the order in which they are used.
  std::vector<Surface> planesFor(const Patch& patch) const {
    const Surface& s = patch.surface;
    Vector3d mean = Vector3d::Zero();
    for (const std::int32_t t : patch.triangles) mean += mesh_.areaVector(t);
    Vector3d axis = s.axis;
    if (s.kind == SurfaceKind::Sphere && mean.norm() > 1e-6 * mesh_.area) axis = mean.normalized();
    Surface plane;
    plane.kind = SurfaceKind::Plane;
    plane.point = s.point;
    std::vector<Surface> planes;
    // An odd angle, so that the cut does not run along rows of vertices lying on both sides of it.
    const Vector3d e1 = anyOrthogonal(axis), e2 = axis.cross(e1);
    const Vector3d x = std::cos(0.3) * e1 + std::sin(0.3) * e2;
    plane.axis = x;
    planes.push_back(plane);
    if (s.kind == SurfaceKind::Sphere) {
      plane.axis = axis.cross(x);
      planes.push_back(plane);
    }
    if (s.kind == SurfaceKind::Sphere || s.kind == SurfaceKind::Torus) {
      plane.axis = axis;
      planes.push_back(plane);
    }
    return planes;
  }

  void cut(std::int32_t first) {
    if (placeSeam(partition_.patches[first])) return;
    const std::int32_t surfaceId = partition_.patches[first].surfaceId;
    std::vector<std::int32_t> pieces{first};
    for (const Surface& plane : planesFor(partition_.patches[first])) {
      std::vector<std::int32_t> next;
      for (const std::int32_t p : pieces) {
        for (const std::int32_t q : halve(p, plane)) next.push_back(q);
      }
      partition_.cuts.push_back({surfaceId, plane});
      pieces.swap(next);
      bool fits = true;
      for (const std::int32_t p : pieces) fits = placeSeam(partition_.patches[p]) && fits;
      if (fits) return;
    }
  }

  // Connected pieces on either side. A piece of a few triangles goes to the side around it.
  std::vector<std::int32_t> halve(std::int32_t p, const Surface& plane) {
    const std::vector<std::int32_t> members = partition_.patches[p].triangles;
    std::vector<char> side(members.size());
    local_.resize(mesh_.triangles.size(), -1);
    for (std::size_t i = 0; i < members.size(); ++i) {
      side[i] = plane.distance(centreOf(mesh_, members[i])) > 0;
      local_[members[i]] = static_cast<std::int32_t>(i);
    }
    std::vector<std::int32_t> component(members.size(), -1);
    std::vector<std::vector<std::int32_t>> components;
    auto collect = [&] {
      std::fill(component.begin(), component.end(), -1);
      components.clear();
      for (std::size_t i = 0; i < members.size(); ++i) {
        if (component[i] >= 0) continue;
        std::vector<std::int32_t> stack{static_cast<std::int32_t>(i)};
        component[i] = static_cast<std::int32_t>(components.size());
        for (std::size_t at = 0; at < stack.size(); ++at) {
          for (int k = 0; k < 3; ++k) {
            const std::int32_t t = mesh_.opposite[3 * members[stack[at]] + k] / 3;
            if (partition_.patchOf[t] != p) continue;
            const std::int32_t j = local_[t];
            if (component[j] >= 0 || side[j] != side[i]) continue;
            component[j] = component[i];
            stack.push_back(j);
          }
        }
        components.push_back(std::move(stack));
      }
    };
    collect();
    bool changed = false;
    for (const auto& piece : components) {
      if (piece.size() * 50 >= members.size()) continue;
      for (const std::int32_t i : piece) side[i] = !side[i];
      changed = true;
    }
    if (changed) collect();
    std::vector<std::int32_t> result;
    for (std::size_t c = 0; c < components.size(); ++c) {
      std::int32_t target = p;
      if (c > 0) {
        target = static_cast<std::int32_t>(partition_.patches.size());
        const Patch copy{partition_.patches[p].surface, {}, 0, partition_.patches[p].surfaceId};
        partition_.patches.push_back(copy);
      }
      partition_.patches[target].triangles.clear();
      for (const std::int32_t i : components[c]) {
        partition_.patches[target].triangles.push_back(members[i]);
      }
      result.push_back(target);
    }
    for (const std::int32_t q : result) {
      for (const std::int32_t t : partition_.patches[q].triangles) partition_.patchOf[t] = q;
    }
    return result;
  }

  const HalfEdgeMesh& mesh_;
  Partition& partition_;
  std::vector<std::int32_t> local_;
};

}  // namespace

void recogniseSurfaces(const HalfEdgeMesh& mesh, double tolerance, Partition& partition,
                       RunContext& run) {
  Recogniser(mesh, tolerance, partition, run).recognise();
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

void cutRoundPatches(const HalfEdgeMesh& mesh, Partition& partition) {
  Cutter(mesh, partition).cutAll();
}

}  // namespace swept::step
