// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/ray_columns.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "geometry/exact_predicates.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

/// Projects the segment a-b to (y, z). Returns +1 or -1 if it crosses the ray from (y, z) towards
/// +y, otherwise 0. The test is half-open in z, so each corner belongs to one of its two segments.
/// The segment is evaluated from its lower end, so both triangles of an edge get the same result.
int crossingSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double y, double z) {
  const bool aboveA = a.z() > z;
  const bool aboveB = b.z() > z;
  if (aboveA == aboveB) return 0;
  const Eigen::Vector3d& low = aboveB ? a : b;
  const Eigen::Vector3d& high = aboveB ? b : a;
  if (orientation2d(low, high, {0, y, z}, 1, 2) <= 0) return 0;
  return aboveB ? 1 : -1;
}

/// Limits of the mean number of columns per triangle, and of the total number of pairs (triangle,
/// column), which are numbered with 32 bits. If a limit is exceeded, the columns become wider.
constexpr double kMaxColumns = 256, kMaxPairs = 4e9;
constexpr std::size_t kColumnBlock = 1 << 13;
constexpr double kColumnMargin = 1e-12;  ///< margin as a fraction of the largest coordinate

/// Returns the smallest and the largest coordinate of the corners along an axis.
std::pair<double, double> extent(const Corners& corners, int axis) {
  return std::minmax({(*corners[0])[axis], (*corners[1])[axis], (*corners[2])[axis]});
}

/// Returns the smallest and the largest y of the part of a triangle with z from `low` to `high`. If
/// there is no such part, the smallest exceeds the largest.
std::pair<double, double> between(const Corners& corners, double low, double high) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d &a = *corners[k], &b = *corners[(k + 1) % 3];
    if (std::min(a.z(), b.z()) > high || std::max(a.z(), b.z()) < low) continue;
    for (const double z : {low, high}) {
      const double along = b.z() == a.z() ? 0 : std::clamp((z - a.z()) / (b.z() - a.z()), 0.0, 1.0);
      const double y = a.y() + along * (b.y() - a.y());
      first = std::min(first, y);
      last = std::max(last, y);
    }
  }
  return {first, last};
}

}  // namespace

RayColumns::RayColumns(const TriMesh& mesh) : mesh_(mesh) {
  low_.setConstant(0);
  high_.setConstant(0);
  if (!mesh.vertices.empty()) low_ = high_ = mesh.vertices[0];
  for (const auto& v : mesh.vertices) {
    low_ = low_.cwiseMin(v);
    high_ = high_.cwiseMax(v);
  }
  build();
}

RayColumns::RayColumns(const TriMesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
    : mesh_(mesh), low_(low), high_(high) {
  build();
}

template <class Use>
void RayColumns::forRows(std::size_t triangle, const Use& use) const {
  const auto& tri = mesh_.triangles[triangle];
  const Corners corners{&mesh_.vertices[tri[0]], &mesh_.vertices[tri[1]], &mesh_.vertices[tri[2]]};
  const auto [yLow, yHigh] = extent(corners, 1);
  const auto [zLow, zHigh] = extent(corners, 2);
  if (yHigh < low_.y() || yLow > high_.y() || zHigh < low_.z() || zLow > high_.z()) return;
  const std::int32_t y0 = column(yLow, 1), y1 = column(yHigh, 1);
  const std::int32_t z0 = column(zLow, 2), z1 = column(zHigh, 2);
  const bool isNarrow = y1 - y0 < 2 || z1 - z0 < 2;
  // This margin is far above the rounding errors in the limits of a row and in a point on an edge.
  const Eigen::Vector3d margin = kColumnMargin * low_.cwiseAbs().cwiseMax(high_.cwiseAbs());
  const double row = (high_.z() - low_.z()) / columns_;
  for (std::int32_t z = z0; z <= z1; ++z) {
    if (isNarrow) {
      use(z, y0, y1);
      continue;
    }
    const double from = z == z0 ? zLow : low_.z() + z * row - margin.z();
    const double to = z == z1 ? zHigh : low_.z() + (z + 1) * row + margin.z();
    const auto [first, last] = between(corners, from, to);
    if (first <= last) use(z, column(first - margin.y(), 1), column(last + margin.y(), 1));
  }
}

std::int64_t RayColumns::countPairs() const {
  std::atomic<std::int64_t> pairs{0};
  parallelBlocks(mesh_.triangles.size(), kColumnBlock, [&](std::size_t begin, std::size_t end) {
    std::int64_t sum = 0;
    for (std::size_t t = begin; t < end; ++t) {
      forRows(t, [&](std::int32_t, std::int32_t y0, std::int32_t y1) { sum += y1 - y0 + 1; });
    }
    pairs += sum;
  });
  return pairs;
}

void RayColumns::build() {
  const double count = static_cast<double>(mesh_.triangles.size());
  columns_ = std::clamp(static_cast<std::int32_t>(std::sqrt(count)), 1, 128);
  const double most = std::min(kMaxColumns * count, kMaxPairs);
  while (columns_ > 1 && static_cast<double>(countPairs()) > most) columns_ /= 2;
  const auto forAll = [&](const auto& use) {
    parallelBlocks(mesh_.triangles.size(), kColumnBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        forRows(t, [&](std::int32_t z, std::int32_t y0, std::int32_t y1) {
          for (std::int32_t y = y0; y <= y1; ++y) use(cellAt(y, z), static_cast<std::int32_t>(t));
        });
      }
    });
  };
  triangles_ = ListsByKey<std::int32_t>(cellAt(0, columns_), forAll);
}

std::int32_t RayColumns::column(double value, int axis) const {
  const double extent = high_[axis] - low_[axis];
  if (!(extent > 0)) return 0;
  const double part = (value - low_[axis]) / extent * columns_;
  return std::clamp(static_cast<std::int32_t>(part), 0, columns_ - 1);
}

/// Calls visit(x, triangle, direction) for the crossings of a line, in any order.
template <class Visit>
void RayColumns::forCrossings(double y, double z, const Visit& visit) const {
  // The order of the triangles in a column may vary from run to run; crossings() sorts its result.
  for (const std::int32_t t : triangles_.asTheyStand(cellAt(column(y, 1), column(z, 2)))) {
    const auto& tri = mesh_.triangles[t];
    const auto &a = mesh_.vertices[tri[0]], &b = mesh_.vertices[tri[1]],
               &c = mesh_.vertices[tri[2]];
    // If all corners have a smaller y, or all have a larger y, the line misses the triangle. In the
    // sum below, its sides would not cross the ray or would cancel each other.
    if (std::min({a.y(), b.y(), c.y()}) > y || std::max({a.y(), b.y(), c.y()}) < y) continue;
    const int turn = crossingSign(a, b, y, z) + crossingSign(b, c, y, z) + crossingSign(c, a, y, z);
    if (turn == 0) continue;
    const Eigen::Vector3d n = (b - a).cross(c - a);
    const double low = std::min({a.x(), b.x(), c.x()});
    const double high = std::max({a.x(), b.x(), c.x()});
    double x = low;
    if (n.x() != 0) x = a.x() - (n.y() * (y - a.y()) + n.z() * (z - a.z())) / n.x();
    visit(std::clamp(x, low, high), t, turn > 0 ? -1 : 1);
  }
}

void RayColumns::crossings(double y, double z, std::vector<Crossing>& out) const {
  out.clear();
  forCrossings(y, z, [&](double x, std::int32_t triangle, std::int32_t direction) {
    out.push_back({x, triangle, direction});
  });
  std::sort(out.begin(), out.end(), [](const Crossing& p, const Crossing& q) {
    return p.x != q.x ? p.x < q.x : p.triangle < q.triangle;
  });
}

int RayColumns::winding(const Eigen::Vector3d& p) const {
  if ((p.array() < low_.array()).any() || (p.array() > high_.array()).any()) return 0;
  int sum = 0;
  forCrossings(p.y(), p.z(), [&](double x, std::int32_t, std::int32_t direction) {
    if (x > p.x()) sum -= direction;
  });
  return sum;
}

}  // namespace swept
