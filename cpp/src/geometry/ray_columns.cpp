// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/ray_columns.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

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
  build();
}

RayColumns::RayColumns(const TriMesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
    : mesh_(mesh), low_(low), high_(high) {
  build();
}

bool RayColumns::cellsOf(std::size_t triangle, Cells& cells) const {
  const auto& tri = mesh_.triangles[triangle];
  const auto &a = mesh_.vertices[tri[0]], &b = mesh_.vertices[tri[1]], &c = mesh_.vertices[tri[2]];
  const double y0 = std::min({a.y(), b.y(), c.y()}), y1 = std::max({a.y(), b.y(), c.y()});
  const double z0 = std::min({a.z(), b.z(), c.z()}), z1 = std::max({a.z(), b.z(), c.z()});
  if (y1 < low_.y() || y0 > high_.y() || z1 < low_.z() || z0 > high_.z()) return false;
  cells = {column(y0, 1), column(y1, 1), column(z0, 2), column(z1, 2)};
  return true;
}

void RayColumns::build() {
  columns_ = std::clamp(
      static_cast<std::int32_t>(std::sqrt(static_cast<double>(mesh_.triangles.size()))), 1, 128);
  const auto forAll = [&](const auto& use) {
    parallelBlocks(mesh_.triangles.size(), 1 << 13, [&](std::size_t begin, std::size_t end) {
      Cells under{};
      for (std::size_t t = begin; t < end; ++t) {
        if (!cellsOf(t, under)) continue;
        for (std::int32_t z = under.z0; z <= under.z1; ++z) {
          for (std::int32_t y = under.y0; y <= under.y1; ++y)
            use(cellAt(y, z), static_cast<std::int32_t>(t));
        }
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

/// visit(x, triangle, direction), in no order.
template <class Visit>
void RayColumns::forCrossings(double y, double z, const Visit& visit) const {
  // The order within a column varies; the sorted crossings of a line do not.
  for (const std::int32_t t : triangles_.asTheyStand(cellAt(column(y, 1), column(z, 2)))) {
    const auto& tri = mesh_.triangles[t];
    const auto &a = mesh_.vertices[tri[0]], &b = mesh_.vertices[tri[1]],
               &c = mesh_.vertices[tri[2]];
    const int turn = passes(a, b, y, z) + passes(b, c, y, z) + passes(c, a, y, z);
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
