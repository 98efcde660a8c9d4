// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/deviation.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/spread_points.h"
#include "geometry/triangle_distance.h"

namespace swept {
namespace {

using Eigen::Vector3d;

// Distances below a floor are not measured, as it suffices to know that they are smaller than the
// largest one. If none is above the floor, the next floor is tried. Fractions of the squared
// tolerance. A simplified surface mostly deviates by more than half of the tolerance.
constexpr std::array<double, 3> kFloors = {0.25, 0.01, 0};

constexpr std::size_t kOriginalBlock = 256;  // vertices or triangles of the original
constexpr std::size_t kResultBlock = 64;     // triangles of the result

// Points within a triangle, as fractions of two of its sides.
constexpr std::array<std::array<double, 2>, 7> kInner = {
    {{1. / 3, 1. / 3}, {.5, 0}, {.5, .5}, {0, .5}, {.2, .2}, {.6, .2}, {.2, .6}}};

// Returns the squared distance of p from a mesh; 0 if it is at most `enough`. `hint`: the triangle
// that the last search found.
double distanceAbove(double enough, const Vector3d& p, const NearestTriangle& nearest,
                     std::int32_t& hint) {
  return nearest.isNear(p, enough, hint) ? 0 : nearest.query(p, 1e300, enough, hint);
}

}  // namespace

// Searches for the nearest points of the result.
class DeviationMeter::Forward {
 public:
  Forward(const DeviationMeter& meter, const TriMesh& result)
      : meter_(meter),
        result_(result),
        nearest_(result.vertices, result.triangles, NearestTriangle::Walks::Yes) {
    const auto& triangles = meter.triangles_;
    if (!triangles.empty()) indexOf_.assign(triangles.back().number + 1, -1);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      indexOf_[triangles[i].number] = static_cast<std::int32_t>(i);
  }

  std::int32_t numberOf(std::int32_t index) const { return meter_.triangles_[index].number; }
  // Returns the index of a triangle in the result, or -1.
  std::int32_t indexOf(std::int32_t number) const {
    return number < static_cast<std::int32_t>(indexOf_.size()) ? indexOf_[number] : -1;
  }

  // `hint`: index of the triangle that the last search found.
  void measure(const Vector3d& p, Block& to, std::int32_t& hint) const {
    const double d = distanceAbove(meter_.enough(to.largest), p, nearest_, hint);
    to.largest = std::max(to.largest, d);
    if (d > meter_.limit_)
      to.missed.push_back({p, footOnTriangle(p, result_, hint).point, numberOf(hint)});
  }

  void measureTriangle(std::size_t t, Block& to) const {
    const TriMesh& original = meter_.original_;
    const auto& tri = original.triangles[t];
    const Vector3d &a = original.vertices[tri[0]], &b = original.vertices[tri[1]],
                   &c = original.vertices[tri[2]];
    // If all three vertices lie near the same triangle, so does the inside, since the distance from
    // a triangle is convex.
    const auto& of = meter_.nearestOf_;
    if (of[tri[0]] == of[tri[1]] && of[tri[0]] == of[tri[2]]) return;
    const double enough = meter_.enough(to.largest);
    for (const std::int32_t v : tri) {
      const std::int32_t near = indexOf(of[v]);
      const auto isNear = [&](const Vector3d& p) {
        return squaredDistance(p, result_, near) <= enough;
      };
      if (near >= 0 && isNear(a) && isNear(b) && isNear(c)) return;
    }
    std::int32_t hint = indexOf(of[tri[0]]);
    for (const auto& [u, w] : kInner) {
      measure(a + u * (b - a) + w * (c - a), to, hint);
      const std::int32_t number = numberOf(hint);
      if (to.near.empty() || to.near.back() != number) to.near.push_back(number);
    }
  }

 private:
  const DeviationMeter& meter_;
  const TriMesh& result_;
  NearestTriangle nearest_;
  std::vector<std::int32_t> indexOf_;  // by number
};

DeviationMeter::DeviationMeter(const TriMesh& original, const NearestTriangle& nearOriginal,
                               double spacing, double tolerance)
    : original_(original),
      nearOriginal_(nearOriginal),
      spacing_(spacing),
      limit_(tolerance * tolerance),
      vertexBlocks_((original.vertices.size() + kOriginalBlock - 1) / kOriginalBlock),
      triangleBlocks_((original.triangles.size() + kOriginalBlock - 1) / kOriginalBlock),
      nearestOf_(original.vertices.size(), -1) {}

double DeviationMeter::enough(double largest) const {
  return std::clamp(largest, kFloors[floor_] * limit_, limit_);
}

Deviation DeviationMeter::measure(const TriMesh& result, const std::vector<std::int32_t>& numbers) {
  takeResult(result, numbers);
  double largest = 0;
  for (;; ++floor_) {
    measureOriginal(result);
    measureResult();
    for (const auto* blocks : {&vertexBlocks_, &triangleBlocks_}) {
      for (const Block& block : *blocks) largest = std::max(largest, block.largest);
    }
    for (const ResultTriangle& triangle : triangles_) largest = std::max(largest, triangle.largest);
    if (largest > 0 || floor_ + 1 == kFloors.size()) break;
    forgetAll();
  }
  Deviation deviation;
  deviation.largest = std::sqrt(largest);
  for (const auto* blocks : {&vertexBlocks_, &triangleBlocks_}) {
    for (const Block& block : *blocks)
      deviation.missed.insert(deviation.missed.end(), block.missed.begin(), block.missed.end());
  }
  for (const ResultTriangle& triangle : triangles_) {
    if (triangle.stray.triangle >= 0) deviation.strays.push_back(triangle.stray);
  }
  return deviation;
}

// Takes the triangles of the result. Those that have not changed stay measured.
void DeviationMeter::takeResult(const TriMesh& result, const std::vector<std::int32_t>& numbers) {
  std::vector<ResultTriangle> before = std::move(triangles_);
  triangles_.clear();
  std::vector<char> hasChanged(before.empty() ? 0 : before.back().number + 1, 1);
  auto old = before.begin();
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    const auto& tri = result.triangles[t];
    ResultTriangle& triangle = triangles_.emplace_back(ResultTriangle{
        numbers[t], {result.vertices[tri[0]], result.vertices[tri[1]], result.vertices[tri[2]]}});
    while (old != before.end() && old->number < triangle.number) ++old;
    if (old == before.end() || old->number != triangle.number || old->corners != triangle.corners)
      continue;
    triangle = *old;
    hasChanged[triangle.number] = 0;
  }
  if (!before.empty()) forgetBlocksNear(hasChanged);
}

// Points that were near an unchanged triangle need not be measured again. If a changed triangle is
// nearer now, the distance that was measured is an upper limit.
void DeviationMeter::forgetBlocksNear(const std::vector<char>& hasChanged) {
  const auto isChanged = [&](std::int32_t number) { return hasChanged[number] != 0; };
  const auto forgetIf = [](Block& block, bool isAffected) {
    if (isAffected || !block.missed.empty()) block = Block();
  };
  parallelBlocks(nearestOf_.size(), kOriginalBlock, [&](std::size_t begin, std::size_t end) {
    forgetIf(vertexBlocks_[begin / kOriginalBlock],
             std::any_of(nearestOf_.begin() + begin, nearestOf_.begin() + end, isChanged));
  });
  const auto& triangles = original_.triangles;
  parallelBlocks(triangles.size(), kOriginalBlock, [&](std::size_t begin, std::size_t end) {
    Block& block = triangleBlocks_[begin / kOriginalBlock];
    const auto hasChangedVertex = [&](const std::array<std::int32_t, 3>& tri) {
      return std::any_of(tri.begin(), tri.end(),
                         [&](std::int32_t v) { return isChanged(nearestOf_[v]); });
    };
    forgetIf(block,
             std::any_of(block.near.begin(), block.near.end(), isChanged) ||
                 std::any_of(triangles.begin() + begin, triangles.begin() + end, hasChangedVertex));
  });
}

void DeviationMeter::forgetAll() {
  for (auto* blocks : {&vertexBlocks_, &triangleBlocks_}) {
    for (Block& block : *blocks) block = Block();
  }
  for (ResultTriangle& triangle : triangles_) triangle.isMeasured = false;
}

void DeviationMeter::measureOriginal(const TriMesh& result) {
  const Forward forward(*this, result);
  parallelBlocks(nearestOf_.size(), kOriginalBlock, [&](std::size_t begin, std::size_t end) {
    Block& block = vertexBlocks_[begin / kOriginalBlock];
    if (block.isMeasured) return;
    block.isMeasured = true;
    std::int32_t hint = -1;
    for (std::size_t v = begin; v < end; ++v) {
      forward.measure(original_.vertices[v], block, hint);
      nearestOf_[v] = forward.numberOf(hint);
    }
  });
  parallelBlocks(original_.triangles.size(), kOriginalBlock,
                 [&](std::size_t begin, std::size_t end) {
                   Block& block = triangleBlocks_[begin / kOriginalBlock];
                   if (block.isMeasured) return;
                   block.isMeasured = true;
                   for (std::size_t t = begin; t < end; ++t) forward.measureTriangle(t, block);
                 });
}

void DeviationMeter::measureResult() {
  parallelBlocks(triangles_.size(), kResultBlock, [&](std::size_t begin, std::size_t end) {
    std::int32_t hint = -1;
    double largest = 0;
    for (std::size_t t = begin; t < end; ++t) {
      ResultTriangle& triangle = triangles_[t];
      if (triangle.isMeasured) continue;
      triangle.isMeasured = true;
      double farthest = limit_;
      const auto& [a, b, c] = triangle.corners;
      spreadPoints(a, b, c, spacing_, [&](const Vector3d& p) {
        const double d = distanceAbove(enough(largest), p, nearOriginal_, hint);
        triangle.largest = std::max(triangle.largest, d);
        largest = std::max(largest, d);
        if (d > farthest) {
          farthest = d;
          triangle.stray = {footOnTriangle(p, original_, hint).point, p, triangle.number};
        }
        return false;
      });
    }
  });
}

}  // namespace swept
