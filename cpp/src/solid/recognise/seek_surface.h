// Finds the surface from which a mesh was made near one triangle.
// In:      HalfEdgeMesh, the shapes of its triangles, a partition (triangles of its patches are not
//          used), tolerance.
// Out:     the best of plane, cylinder, sphere, cone and torus, and the triangles that it covers.
// Units:   mm.
// Cost:    O(triangles covered x surfaces tried).
// Threads: a seeker only reads shared data, so several seekers can work in parallel.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "solid/recognise/region_finder.h"

namespace swept::step {

constexpr char bitOf(CarrierKind kind) { return static_cast<char>(1 << static_cast<int>(kind)); }
constexpr char kAllTried = static_cast<char>(
    bitOf(CarrierKind::Plane) | bitOf(CarrierKind::Cylinder) | bitOf(CarrierKind::Cone) |
    bitOf(CarrierKind::Sphere) | bitOf(CarrierKind::Torus));

struct Candidate {
  Carrier surface;
  std::vector<std::int32_t> region;
  double area = 0;
  double median = 0;  ///< mm, median distance of its vertices from the surface
};

struct Found {
  std::optional<Candidate> best;
  /// No seed in these regions needs to try this kind of surface again.
  std::vector<std::pair<CarrierKind, std::vector<std::int32_t>>> tried;
  /// If nothing was found: triangles that need not be tried again as seeds.
  std::vector<std::int32_t> fruitless;
};

class SurfaceSeeker {
 public:
  SurfaceSeeker(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                const Partition& partition);
  /// `tried`: kinds, as bits, that were tried at this seed before.
  Found seek(std::int32_t seed, char tried);

 private:
  std::vector<std::int32_t> seedRegion(std::int32_t seed, std::size_t size);
  Samples samplesOf(const std::vector<std::int32_t>& region);
  bool accepts(std::int32_t t, const Carrier& surface, double tolerance) const;
  std::vector<std::int32_t> grow(std::int32_t seed, Carrier& surface, double tolerance,
                                 std::size_t refitAt);
  std::optional<Candidate> tryKind(CarrierKind kind, std::int32_t seed, const Samples& first);
  double tightTolerance(double median) const;
  void addRim(Candidate& candidate);
  bool isWorthIt(const Candidate& candidate) const;
  std::optional<Candidate> bestSurface(std::int32_t seed, const std::vector<std::int32_t>& around);
  void preferFlats(Candidate& best);

  const HalfEdgeMesh& mesh_;
  const TriangleShapes& shapes_;
  double tolerance_;
  const Partition& partition_;
  Found found_;
  std::int32_t seed_ = -1;  // the current seed
  char triedAtSeed_ = 0;    // kinds that were tried at the seed
  RegionFinder finder_;
};

}  // namespace swept::step
