// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/spread_points.h"

namespace swept {
namespace {

constexpr std::size_t kBlock = 2048;

/// The largest of part(begin, end, known), squared distances by block; `known` is a distance that
/// was found before: what lies nearer need not be known exactly.
template <class Part>
double largestOf(std::size_t n, std::size_t block, double known, const Part& part) {
  std::vector<double> largest((n + block - 1) / block, known);
  parallelBlocks(n, block, [&](std::size_t begin, std::size_t end) {
    largest[begin / block] = part(begin, end, known);
  });
  for (const double l : largest) known = std::max(known, l);
  return known;
}

double forward(const TriMesh& original, const TriMesh& result) {
  const NearestTriangle nearest(result.vertices, result.triangles);
  std::vector<std::int32_t> home(original.vertices.size());
  double known =
      largestOf(home.size(), kBlock, 0, [&](std::size_t begin, std::size_t end, double d) {
        std::int32_t hint = -1;
        for (std::size_t v = begin; v < end; ++v) {
          d = std::max(d, nearest.query(original.vertices[v], 1e300, d, hint));
          home[v] = hint;
        }
        return d;
      });
  // Where the corners lie near the same triangle, all between them does.
  return largestOf(
      original.triangles.size(), kBlock, known, [&](std::size_t begin, std::size_t end, double d) {
        constexpr std::array<std::array<double, 2>, 7> kInner = {
            {{1. / 3, 1. / 3}, {.5, 0}, {.5, .5}, {0, .5}, {.2, .2}, {.6, .2}, {.2, .6}}};
        for (std::size_t t = begin; t < end; ++t) {
          const auto& tri = original.triangles[t];
          std::int32_t hint = home[tri[0]];
          if (hint == home[tri[1]] && hint == home[tri[2]]) continue;
          const auto &a = original.vertices[tri[0]], &b = original.vertices[tri[1]],
                     &c = original.vertices[tri[2]];
          for (const auto& [u, w] : kInner) {
            const Eigen::Vector3d p = a + u * (b - a) + w * (c - a);
            d = std::max(d, nearest.query(p, 1e300, d, hint));
          }
        }
        return d;
      });
}

double backward(const NearestTriangle& original, const TriMesh& result, double spacing,
                double known) {
  constexpr std::size_t kTriangles = 64;
  return largestOf(result.triangles.size(), kTriangles, known,
                   [&](std::size_t begin, std::size_t end, double d) {
                     std::int32_t hint = -1;
                     for (std::size_t t = begin; t < end; ++t) {
                       const auto& c = result.triangles[t];
                       spreadPoints(result.vertices[c[0]], result.vertices[c[1]],
                                    result.vertices[c[2]], spacing, [&](const Eigen::Vector3d& p) {
                                      d = std::max(d, original.query(p, 1e300, d, hint));
                                      return false;
                                    });
                     }
                     return d;
                   });
}

}  // namespace

double measureDeviation(const TriMesh& original, const NearestTriangle& nearOriginal,
                        const TriMesh& result, double spacing) {
  return std::sqrt(backward(nearOriginal, result, spacing, forward(original, result)));
}

}  // namespace swept
