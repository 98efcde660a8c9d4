// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/ray_columns.h"

#include <algorithm>
#include <cmath>

namespace swept {
namespace {

/// +1 / -1 if the segment a-b, seen in (y, z), passes the horizontal line of `p` on the side of +y.
/// Half-open in z, so each corner belongs to one of its two segments; the segment is always
/// evaluated from its lower end, so both triangles of an edge get the same answer.
int passes(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double y, double z) {
  const bool aboveA = a.z() > z;
  const bool aboveB = b.z() > z;
  if (aboveA == aboveB) return 0;
  const Eigen::Vector3d& low = aboveB ? a : b;
  const Eigen::Vector3d& high = aboveB ? b : a;
  const long double side =
      (static_cast<long double>(high.y()) - low.y()) * (static_cast<long double>(z) - low.z()) -
      (static_cast<long double>(high.z()) - low.z()) * (static_cast<long double>(y) - low.y());
  if (!(side > 0)) return 0;
  return aboveB ? 1 : -1;
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
  columns_ = std::clamp(
      static_cast<std::int32_t>(std::sqrt(static_cast<double>(mesh.triangles.size()))), 1, 128);
  const auto cells = static_cast<std::size_t>(columns_) * columns_;
  start_.assign(cells + 1, 0);
  auto forEachCell = [&](auto&& visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& tri = mesh.triangles[t];
      const auto &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
      const std::int32_t y0 = column(std::min({a.y(), b.y(), c.y()}), 1);
      const std::int32_t y1 = column(std::max({a.y(), b.y(), c.y()}), 1);
      const std::int32_t z0 = column(std::min({a.z(), b.z(), c.z()}), 2);
      const std::int32_t z1 = column(std::max({a.z(), b.z(), c.z()}), 2);
      for (std::int32_t z = z0; z <= z1; ++z) {
        for (std::int32_t y = y0; y <= y1; ++y) {
          visit(static_cast<std::size_t>(z) * columns_ + y, static_cast<std::int32_t>(t));
        }
      }
    }
  };
  forEachCell([&](std::size_t cell, std::int32_t) { ++start_[cell + 1]; });
  for (std::size_t i = 0; i < cells; ++i) start_[i + 1] += start_[i];
  items_.resize(start_[cells]);
  std::vector<std::uint32_t> cursor(start_.begin(), start_.end() - 1);
  forEachCell([&](std::size_t cell, std::int32_t t) { items_[cursor[cell]++] = t; });
}

std::int32_t RayColumns::column(double value, int axis) const {
  const double extent = high_[axis] - low_[axis];
  if (!(extent > 0)) return 0;
  const double part = (value - low_[axis]) / extent * columns_;
  return std::clamp(static_cast<std::int32_t>(part), 0, columns_ - 1);
}

void RayColumns::crossings(double y, double z, std::vector<Crossing>& out) const {
  out.clear();
  const std::size_t cell = static_cast<std::size_t>(column(z, 2)) * columns_ + column(y, 1);
  for (std::uint32_t i = start_[cell]; i < start_[cell + 1]; ++i) {
    const auto& tri = mesh_.triangles[items_[i]];
    const auto &a = mesh_.vertices[tri[0]], &b = mesh_.vertices[tri[1]],
               &c = mesh_.vertices[tri[2]];
    const int winding = passes(a, b, y, z) + passes(b, c, y, z) + passes(c, a, y, z);
    if (winding == 0) continue;
    const Eigen::Vector3d n = (b - a).cross(c - a);
    const double low = std::min({a.x(), b.x(), c.x()});
    const double high = std::max({a.x(), b.x(), c.x()});
    double x = low;
    if (n.x() != 0) x = a.x() - (n.y() * (y - a.y()) + n.z() * (z - a.z())) / n.x();
    out.push_back({std::clamp(x, low, high), items_[i], winding > 0 ? -1 : 1});
  }
  std::sort(out.begin(), out.end(), [](const Crossing& p, const Crossing& q) {
    return p.x != q.x ? p.x < q.x : p.triangle < q.triangle;
  });
}

}  // namespace swept
