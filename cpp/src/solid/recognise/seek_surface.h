// The surface that a mesh was made of about one triangle.
// In: HalfEdgeMesh, the shapes of its triangles, a partition (triangles of patches are not
// touched), tolerance in mm. Out: the best of plane, cylinder, sphere, cone, torus and the
// triangles it covers. Reads only what is shared, so several can seek at the same time. Cost:
// O(triangles covered x surfaces tried).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "solid/mesh/patches.h"
#include "solid/recognise/fit.h"
#include "solid/recognise/tidy_patches.h"

namespace swept::step {

constexpr char bitOf(SurfaceKind kind) { return static_cast<char>(1 << static_cast<int>(kind)); }
constexpr char kAllTried = static_cast<char>(
    bitOf(SurfaceKind::Plane) | bitOf(SurfaceKind::Cylinder) | bitOf(SurfaceKind::Cone) |
    bitOf(SurfaceKind::Sphere) | bitOf(SurfaceKind::Torus));

struct Candidate {
  Surface surface;
  std::vector<std::int32_t> region;
  double area = 0;
  double median = 0;  ///< mm, of the distances of its vertices
};

struct Found {
  std::optional<Candidate> best;
  /// The same kind of surface need not be tried again from anywhere in here.
  std::vector<std::pair<SurfaceKind, std::vector<std::int32_t>>> tried;
  std::vector<std::int32_t> fruitless;  ///< nothing found, and no use in asking here again
};

class SurfaceSeeker {
 public:
  SurfaceSeeker(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                const Partition& partition);
  /// tried: the kinds, as bits, that were tried at the seed before.
  Found seek(std::int32_t seed, char tried);

 private:
  std::vector<std::int32_t> seedRegion(std::int32_t seed, std::size_t size);
  Samples samplesOf(const std::vector<std::int32_t>& region);
  bool accepts(std::int32_t t, const Surface& surface, double tolerance) const;
  std::vector<std::int32_t> grow(std::int32_t seed, Surface& surface, double tolerance,
                                 std::size_t refitAt);
  double areaOf(const std::vector<std::int32_t>& region) const;
  std::optional<Candidate> tryKind(SurfaceKind kind, std::int32_t seed, const Samples& first);
  double tightOf(double median) const;
  void addRim(Candidate& candidate);
  bool isWorthIt(const Candidate& candidate) const;
  std::optional<Candidate> bestSurface(std::int32_t seed, const std::vector<std::int32_t>& around);
  void preferFlats(Candidate& best);

  const HalfEdgeMesh& mesh_;
  const std::vector<Eigen::Vector3d>& normal_;
  const std::vector<double>& area_;
  const std::vector<char>& thin_;
  double tolerance_;
  const Partition& partition_;
  Found found_;
  std::int32_t asked_ = -1;  // the seed asked for
  char asks_ = 0;            // kinds that were tried there
  std::vector<std::int32_t> stampOf_, pointStamp_;
  std::int32_t stamp_ = 0, pointMark_ = 0;
};

}  // namespace swept::step
