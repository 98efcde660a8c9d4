// Tools for all searches for surfaces: connected regions of triangles, samples of them, and tests
// of triangles against a surface.
// In:      HalfEdgeMesh and the shapes of its triangles.
// Units:   mm.
// Cost:    O(triangles visited).
// Threads: one object per thread, since it marks visited triangles and vertices.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

#include "solid/mesh/patches.h"
#include "solid/recognise/fit.h"

namespace swept::step {

/// A curved patch with fewer triangles becomes facets.
constexpr std::size_t kMinTriangles = 24;
/// Cosine of the largest angle (26 degrees) between a triangle and its surface.
constexpr double kSurfaceCosine = 0.90;
/// Largest median distance of the vertices from their surface, as a fraction of the tolerance.
constexpr double kExactFraction = 0.1;

class RegionFinder {
 public:
  RegionFinder(const HalfEdgeMesh& mesh, const TriangleShapes& shapes)
      : mesh_(mesh),
        shapes_(shapes),
        stampOf_(mesh.triangles.size(), 0),
        pointStampOf_(mesh.points.size(), 0) {}

  /// Clears the marks and starts a region with the seed.
  std::vector<std::int32_t> start(std::int32_t seed) {
    stampOf_[seed] = ++stamp_;
    return {seed};
  }
  /// Appends to the region every neighbour of its members [begin, end) that was not added since
  /// start() and for which accepts(neighbour, member) is true.
  template <class Accepts>
  void extend(std::vector<std::int32_t>& region, std::size_t begin, std::size_t end,
              const Accepts& accepts) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const std::int32_t other : mesh_.neighbours(region[i])) {
        if (stampOf_[other] == stamp_ || !accepts(other, region[i])) continue;
        stampOf_[other] = stamp_;
        region.push_back(other);
      }
    }
  }
  /// Grows a region breadth first from a seed until it has `maxCount` triangles.
  template <class Accepts>
  std::vector<std::int32_t> grow(std::int32_t seed, std::size_t maxCount, const Accepts& accepts) {
    std::vector<std::int32_t> region = start(seed);
    for (std::size_t i = 0; i < region.size() && region.size() < maxCount; ++i)
      extend(region, i, i + 1, accepts);
    return region;
  }
  /// Returns one sample for each vertex of about `maxCount` triangles. Needles, whose normals are
  /// unreliable, are used only if `needles` is true. A body may consist of needles.
  Samples samplesOf(const std::vector<std::int32_t>& region, std::size_t maxCount, bool needles);

  /// Whether the edge between two adjacent triangles is smooth (less than 28 degrees).
  bool isSmooth(std::int32_t a, std::int32_t b) const {
    constexpr double kCreaseCosine = 0.88;
    return shapes_.normal[a].dot(shapes_.normal[b]) >= kCreaseCosine;
  }
  /// Whether the normals turn enough (11 degrees) to distinguish a curved surface from a plane.
  bool bends(const std::vector<std::int32_t>& region) const;

 private:
  const HalfEdgeMesh& mesh_;
  const TriangleShapes& shapes_;
  // Stamp of the last visit of each triangle and vertex.
  std::vector<std::int32_t> stampOf_, pointStampOf_;
  std::int32_t stamp_ = 0, pointStamp_ = 0;
};

/// Returns the connected pieces of a set of triangles, each in breadth-first order. Neighbours a
/// and b are connected if connects(a, b) is true.
template <class Connects>
std::vector<std::vector<std::int32_t>> connectedPieces(const HalfEdgeMesh& mesh,
                                                       const std::vector<std::int32_t>& triangles,
                                                       const Connects& connects) {
  std::unordered_set<std::int32_t> open(triangles.begin(), triangles.end());
  std::vector<std::vector<std::int32_t>> pieces;
  for (const std::int32_t first : triangles) {
    if (open.erase(first) == 0) continue;
    std::vector<std::int32_t> piece{first};
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const std::int32_t t : mesh.neighbours(piece[i])) {
        if (connects(piece[i], t) && open.erase(t) != 0) piece.push_back(t);
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Whether the vertices of a triangle lie on a surface, and the two normals there differ by at most
/// the angle with the cosine `minCosine`. Needles may have any normal.
bool liesOn(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, std::int32_t t,
            const Carrier& surface, double tolerance, double minCosine);

/// Returns the median distance from a surface, mm, of the first vertex of each triangle. The median
/// ignores a few triangles of a neighbouring surface. Returns 0 without triangles.
double medianDistance(const HalfEdgeMesh& mesh, const Carrier& surface,
                      const std::vector<std::int32_t>& triangles);

/// Calls use(i, t) for all triangles t in a fixed scattered order; i counts from 0. Scattering
/// avoids successive triangles that are neighbours on the mesh.
template <class Use>
void forScattered(std::int32_t count, const Use& use) {
  std::int32_t stride = static_cast<std::int32_t>(0.618 * count) | 1;
  while (std::gcd(stride, count) != 1) stride += 2;
  std::int64_t at = 0;
  for (std::int32_t i = 0; i < count; ++i, at = (at + stride) % count)
    use(i, static_cast<std::int32_t>(at));
}

}  // namespace swept::step
