// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/mesh_distance.h"

#include <algorithm>
#include <cmath>

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;

double ratio(double part, double whole) { return part > 0 ? part / whole : 0; }

/// Returns the nearest point of a triangle, by the region of the plane in which the projection
/// lies. The triangle may be degenerate: a line or a point.
V3 nearestOnTriangle(const V3& p, const V3& a, const V3& b, const V3& c) {
  const V3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const V3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * ratio(d1, d1 - d3);
  const V3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * ratio(d2, d2 - d6);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return b + (c - b) * ratio(d4 - d3, (d4 - d3) + (d5 - d6));
  }
  const double sum = va + vb + vc;
  return a + ab * ratio(vb, sum) + ac * ratio(vc, sum);
}

}  // namespace

MeshDistance::MeshDistance(const TriMesh& mesh) : mesh_(mesh) {
  order_.resize(mesh_.triangles.size());
  centres_.resize(mesh_.triangles.size());
  for (std::size_t t = 0; t < order_.size(); ++t) {
    order_[t] = static_cast<std::int32_t>(t);
    const auto& tri = mesh_.triangles[t];
    centres_[t] = (mesh_.vertices[tri[0]] + mesh_.vertices[tri[1]] + mesh_.vertices[tri[2]]) / 3;
  }
  nodes_.reserve(order_.size());
  if (!order_.empty()) build(0, static_cast<std::int32_t>(order_.size()));
}

std::int32_t MeshDistance::build(std::int32_t first, std::int32_t count) {
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box, centres;
  for (std::int32_t i = first; i < first + count; ++i) {
    for (const std::int32_t v : mesh_.triangles[order_[i]]) box.extend(mesh_.vertices[v]);
    centres.extend(centres_[order_[i]]);
  }
  nodes_[index].box = box;
  if (count <= 4) {
    nodes_[index].first = first;
    nodes_[index].count = count;
    return index;
  }
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::int32_t half = count / 2;
  std::nth_element(
      order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
      [&](std::int32_t a, std::int32_t b) { return centres_[a][axis] < centres_[b][axis]; });
  const std::int32_t left = build(first, half);
  const std::int32_t right = build(first + half, count - half);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

MeshDistance::Nearest MeshDistance::nearest(const V3& p, double limit) const {
  Nearest best;
  best.distance = limit;
  if (nodes_.empty()) return best;
  double bestSquared = limit < 1e150 ? limit * limit : 1e300;
  struct Entry {
    std::int32_t node;
    double squared;
  };
  Entry stack[128];
  int size = 0;
  stack[size++] = {0, nodes_[0].box.squaredExteriorDistance(p)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.squared >= bestSquared) continue;
    const Node& node = nodes_[entry.node];
    if (node.count > 0) {
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
        const auto& tri = mesh_.triangles[order_[i]];
        const V3 q = nearestOnTriangle(p, mesh_.vertices[tri[0]], mesh_.vertices[tri[1]],
                                       mesh_.vertices[tri[2]]);
        const double squared = (q - p).squaredNorm();
        if (squared >= bestSquared) continue;
        bestSquared = squared;
        best.point = q;
        best.triangle = order_[i];
      }
      continue;
    }
    Entry near{node.left, nodes_[node.left].box.squaredExteriorDistance(p)};
    Entry far{node.right, nodes_[node.right].box.squaredExteriorDistance(p)};
    if (far.squared < near.squared) std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
  best.distance = std::sqrt(bestSquared);
  return best;
}

bool MeshDistance::inside(const V3& p) const {
  double sum = 0;  // sum of solid angles
  for (const auto& tri : mesh_.triangles) {
    const V3 a = mesh_.vertices[tri[0]] - p, b = mesh_.vertices[tri[1]] - p,
             c = mesh_.vertices[tri[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum > 6.283185307179586;
}

V3 MeshDistance::normal(std::int32_t triangle) const {
  const auto& tri = mesh_.triangles[triangle];
  return (mesh_.vertices[tri[1]] - mesh_.vertices[tri[0]])
      .cross(mesh_.vertices[tri[2]] - mesh_.vertices[tri[0]])
      .normalized();
}

}  // namespace swept::test
