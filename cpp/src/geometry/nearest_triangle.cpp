// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/nearest_triangle.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "geometry/morton.h"

namespace swept {
namespace {

/// 0 also where an edge or the triangle has no extent.
double share(double part, double whole) { return part > 0 ? part / whole : 0; }

}  // namespace

double squaredDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                       const Eigen::Vector3d& c) {
  // Regions of the triangle's plane, by barycentric signs.
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - ab * share(d1, d1 - d3)).squaredNorm();
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - ac * share(d2, d2 - d6)).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return (bp - (c - b) * share(d4 - d3, (d4 - d3) + (d5 - d6))).squaredNorm();
  }
  const double scale = va + vb + vc > 0 ? 1 / (va + vb + vc) : 0;
  return (ap - ab * (vb * scale) - ac * (vc * scale)).squaredNorm();
}

NearestTriangle::NearestTriangle(const std::vector<Eigen::Vector3d>& vertices,
                                 const Triangles& triangles)
    : vertices_(vertices), triangles_(triangles) {
  const std::size_t n = triangles.size();
  if (n == 0) return;
  Eigen::Vector3d low = vertices[0], high = vertices[0];
  for (const auto& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double scale = 1023 / std::max((high - low).maxCoeff(), 1e-300);
  std::vector<std::uint64_t> keys(n);
  parallelBlocks(n, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& tri = triangles[t];
      // Far from the origin the mean may round to a point beside the box.
      const Eigen::Vector3d m =
          (((vertices[tri[0]] + vertices[tri[1]] + vertices[tri[2]]) / 3 - low) * scale)
              .cwiseMax(0)
              .cwiseMin(1023);
      keys[t] = mortonCode(static_cast<std::uint32_t>(m[0]), static_cast<std::uint32_t>(m[1]),
                           static_cast<std::uint32_t>(m[2]))
                    << 32 |
                t;
    }
  });
  tbb::parallel_sort(keys);
  order_.resize(n);
  for (std::size_t t = 0; t < n; ++t) order_[t] = static_cast<std::int32_t>(keys[t] & 0xffffffffu);
  levels_.emplace_back((n + 3) / 4);
  parallelBlocks(levels_[0].size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      Box& box = levels_[0][leaf];
      box.low.setConstant(1e300);
      box.high.setConstant(-1e300);
      for (std::size_t t = 4 * leaf; t < std::min(n, 4 * leaf + 4); ++t) {
        for (const std::int32_t v : triangles[order_[t]]) {
          box.low = box.low.cwiseMin(vertices[v]);
          box.high = box.high.cwiseMax(vertices[v]);
        }
      }
    }
  });
  while (levels_.back().size() > 1) {
    const auto& below = levels_.back();
    std::vector<Box> level((below.size() + 3) / 4);
    for (std::size_t i = 0; i < level.size(); ++i) {
      level[i] = below[4 * i];
      for (std::size_t c = 4 * i + 1; c < std::min(below.size(), 4 * i + 4); ++c) {
        level[i].low = level[i].low.cwiseMin(below[c].low);
        level[i].high = level[i].high.cwiseMax(below[c].high);
      }
    }
    levels_.push_back(std::move(level));
  }
}

double NearestTriangle::query(const Eigen::Vector3d& p, double limit, double enough,
                              std::int32_t& hint) const {
  struct Item {
    double distance;
    std::int32_t level;
    std::uint32_t index;
  };
  std::array<Item, 128> stack;
  int size = 0;
  double best = limit;
  const auto ask = [&](std::int32_t t) {
    const auto& tri = triangles_[t];
    const double d = squaredDistance(p, vertices_[tri[0]], vertices_[tri[1]], vertices_[tri[2]]);
    if (d >= best) return;
    best = d;
    hint = t;
  };
  if (hint >= 0) ask(hint);
  if (best <= enough) return best;
  const auto toBox = [&](const Box& box) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).squaredNorm();
  };
  if (!levels_.empty()) stack[size++] = {0, static_cast<std::int32_t>(levels_.size()) - 1, 0};
  while (size > 0) {
    const Item item = stack[--size];
    if (item.distance >= best) continue;
    if (item.level == 0) {
      const std::size_t end = std::min(order_.size(), std::size_t{4} * item.index + 4);
      for (std::size_t t = std::size_t{4} * item.index; t < end; ++t) {
        ask(order_[t]);
      }
      if (best <= enough) return best;
      continue;
    }
    const auto& below = levels_[item.level - 1];
    std::array<Item, 4> children;
    int n = 0;
    for (std::uint32_t c = 4 * item.index;
         c < std::min<std::size_t>(below.size(), 4 * item.index + 4); ++c) {
      const Item child{toBox(below[c]), item.level - 1, c};
      if (child.distance >= best) continue;
      int at = n++;
      for (; at > 0 && children[at - 1].distance < child.distance; --at)
        children[at] = children[at - 1];
      children[at] = child;
    }
    for (int c = 0; c < n; ++c) stack[size++] = children[c];  // nearest last: taken first
  }
  return best;
}

}  // namespace swept
