// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/spread_points.h"
#include "geometry/triangle_distance.h"

namespace swept {
namespace {

using Eigen::Vector3d;

// Result for one block of the work.
struct Found {
  double largest = 0;  // squared, mm^2
  std::vector<FarPoint> missed, strays;
};

class Measurement {
 public:
  Measurement(const TriMesh& original, const NearestTriangle& nearOriginal, const TriMesh& result,
              double spacing, double tolerance)
      : original_(original),
        nearOriginal_(nearOriginal),
        result_(result),
        spacing_(spacing),
        limit_(tolerance * tolerance) {}

  Deviation work() {
    forward();
    backward();
    return {std::sqrt(all_.largest), std::move(all_.missed), std::move(all_.strays)};
  }

 private:
  // Calls part(i, found, hint) for each i < n, in blocks. `found` collects the results of a block
  // and starts with the largest distance of earlier passes. `hint`: the nearest triangle of the
  // last search.
  template <class Part>
  void forAll(std::size_t n, std::size_t block, const Part& part) {
    std::vector<Found> found((n + block - 1) / block);
    parallelBlocks(n, block, [&](std::size_t begin, std::size_t end) {
      Found& own = found[begin / block];
      own.largest = all_.largest;
      std::int32_t hint = -1;
      for (std::size_t i = begin; i < end; ++i) part(i, own, hint);
    });
    for (const Found& own : found) {
      all_.largest = std::max(all_.largest, own.largest);
      all_.missed.insert(all_.missed.end(), own.missed.begin(), own.missed.end());
      all_.strays.insert(all_.strays.end(), own.strays.begin(), own.strays.end());
    }
  }
  // Squared distances up to this need not be measured exactly.
  double enough(const Found& found) const { return std::min(found.largest, limit_); }

  void forward() {
    const NearestTriangle nearest(result_.vertices, result_.triangles, NearestTriangle::Walks::Yes);
    const auto measure = [&](const Vector3d& p, Found& found, std::int32_t& hint) {
      if (nearest.isNear(p, enough(found), hint)) return;
      const double d = nearest.query(p, 1e300, enough(found), hint);
      found.largest = std::max(found.largest, d);
      if (d > limit_) found.missed.push_back({p, footOnTriangle(p, result_, hint).point, hint});
    };
    std::vector<std::int32_t> nearestOf(original_.vertices.size());
    forAll(nearestOf.size(), 2048, [&](std::size_t v, Found& found, std::int32_t& hint) {
      measure(original_.vertices[v], found, hint);
      nearestOf[v] = hint;
    });
    // If all three vertices lie near the same triangle, so does the inside, since the distance from
    // a triangle is convex.
    constexpr std::array<std::array<double, 2>, 7> kInner = {
        {{1. / 3, 1. / 3}, {.5, 0}, {.5, .5}, {0, .5}, {.2, .2}, {.6, .2}, {.2, .6}}};
    forAll(original_.triangles.size(), 2048, [&](std::size_t t, Found& found, std::int32_t& hint) {
      const auto& tri = original_.triangles[t];
      if (nearestOf[tri[0]] == nearestOf[tri[1]] && nearestOf[tri[0]] == nearestOf[tri[2]]) return;
      const Vector3d &a = original_.vertices[tri[0]], &b = original_.vertices[tri[1]],
                     &c = original_.vertices[tri[2]];
      for (const std::int32_t v : tri) {
        const auto isNear = [&](const Vector3d& p) {
          return squaredDistance(p, result_, nearestOf[v]) <= enough(found);
        };
        if (isNear(a) && isNear(b) && isNear(c)) return;
      }
      hint = nearestOf[tri[0]];
      for (const auto& [u, w] : kInner) measure(a + u * (b - a) + w * (c - a), found, hint);
    });
  }

  void backward() {
    forAll(result_.triangles.size(), 64, [&](std::size_t t, Found& found, std::int32_t& hint) {
      const auto& c = result_.triangles[t];
      FarPoint stray;
      double farthest = limit_;
      const auto measure = [&](const Vector3d& p) {
        if (nearOriginal_.isNear(p, enough(found), hint)) return false;
        const double d = nearOriginal_.query(p, 1e300, enough(found), hint);
        found.largest = std::max(found.largest, d);
        if (d > farthest) {
          farthest = d;
          stray = {footOnTriangle(p, original_, hint).point, p, static_cast<std::int32_t>(t)};
        }
        return false;
      };
      spreadPoints(result_.vertices[c[0]], result_.vertices[c[1]], result_.vertices[c[2]], spacing_,
                   measure);
      if (stray.triangle >= 0) found.strays.push_back(stray);
    });
  }

  const TriMesh& original_;
  const NearestTriangle& nearOriginal_;
  const TriMesh& result_;
  const double spacing_, limit_;
  Found all_;
};

}  // namespace

Deviation measureDeviation(const TriMesh& original, const NearestTriangle& nearOriginal,
                           const TriMesh& result, double spacing, double tolerance) {
  return Measurement(original, nearOriginal, result, spacing, tolerance).work();
}

}  // namespace swept
