// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/deviation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/spread_points.h"

namespace swept {
namespace {

constexpr std::size_t kBlock = 2048;
constexpr double kLong = 3;  ///< cells: longer triangles are of a surface already simplified

struct Part {
  double largest = 0;
  std::vector<std::int32_t> bad;
};

double gather(std::vector<Part>& parts, std::vector<std::int32_t>& bad) {
  double largest = 0;
  for (const Part& p : parts) {
    largest = std::max(largest, p.largest);
    bad.insert(bad.end(), p.bad.begin(), p.bad.end());
  }
  return std::sqrt(largest);
}

double forward(const DeviationInput& in, std::vector<std::int32_t>& bad) {
  const NearestTriangle nearest(in.points, in.triangles);
  const double allowed = in.tolerance * in.tolerance, floor = in.known * in.known;
  const std::size_t n = in.originalPoints.size();
  std::vector<Part> parts((n + kBlock - 1) / kBlock);
  parallelBlocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
    Part& part = parts[begin / kBlock];
    std::int32_t hint = -1;
    for (std::size_t v = begin; v < end; ++v) {
      const double d = nearest.query(in.originalPoints[v], 1e300, floor, hint);
      part.largest = std::max(part.largest, d);
      if (d > allowed) part.bad.push_back(static_cast<std::int32_t>(v));
    }
  });
  // Between the vertices: only where they lie unevenly can the surface lie farther than they do.
  std::vector<Part> inner((in.originalTriangles.size() + kBlock - 1) / kBlock);
  parallelBlocks(in.originalTriangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    Part& part = inner[begin / kBlock];
    std::int32_t hint = -1;
    for (std::size_t t = begin; t < end; ++t) {
      const auto& tri = in.originalTriangles[t];
      const auto &a = in.originalPoints[tri[0]], &b = in.originalPoints[tri[1]],
                 &c = in.originalPoints[tri[2]];
      double farthest = 0;
      const auto ask = [&](const Eigen::Vector3d& p) {
        farthest = std::max(farthest, nearest.query(p, 1e300, floor, hint));
        return false;
      };
      if (std::max({(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()}) >
          kLong * kLong) {
        spreadPoints(a, b, c, ask);
      } else if (in.creased[t]) {
        constexpr std::array<std::array<double, 2>, 7> kInner = {
            {{1. / 3, 1. / 3}, {.5, 0}, {.5, .5}, {0, .5}, {.2, .2}, {.6, .2}, {.2, .6}}};
        for (const auto& [u, w] : kInner) ask(a + u * (b - a) + w * (c - a));
      }
      part.largest = std::max(part.largest, farthest);
      if (farthest > allowed) part.bad.insert(part.bad.end(), tri.begin(), tri.end());
    }
  });
  return std::max(gather(parts, bad), gather(inner, bad));
}

double backward(const DeviationInput& in, double enough, std::vector<std::int32_t>& bad) {
  const double allowed = in.tolerance * in.tolerance, floor = enough * enough;
  constexpr std::size_t kTriangles = 64;
  std::vector<Part> parts((in.triangles.size() + kTriangles - 1) / kTriangles);
  parallelBlocks(in.triangles.size(), kTriangles, [&](std::size_t begin, std::size_t end) {
    Part& part = parts[begin / kTriangles];
    std::int32_t hint = -1;
    for (std::size_t t = begin; t < end; ++t) {
      const auto& c = in.triangles[t];
      double farthest = 0;
      spreadPoints(in.points[c[0]], in.points[c[1]], in.points[c[2]],
                   [&](const Eigen::Vector3d& p) {
                     farthest = std::max(farthest, in.original.query(p, 1e300, floor, hint));
                     return false;
                   });
      part.largest = std::max(part.largest, farthest);
      if (farthest > allowed) part.bad.push_back(static_cast<std::int32_t>(t));
    }
  });
  return gather(parts, bad);
}

}  // namespace

Deviation measureDeviation(const DeviationInput& in) {
  Deviation out;
  out.forward = forward(in, out.vertices);
  out.backward = backward(in, std::min(out.forward, in.tolerance), out.triangles);
  return out;
}

}  // namespace swept
