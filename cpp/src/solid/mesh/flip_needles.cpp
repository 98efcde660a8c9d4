// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/flip_needles.h"

#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector3d;

bool isEdge(const HalfEdgeMesh& mesh, std::int32_t first, std::int32_t to) {
  std::int32_t h = first;
  do {
    if (mesh.target(h) == to) return true;
    h = mesh.opposite[HalfEdgeMesh::previous(h)];
  } while (h != first);
  return false;
}

// The corners of the two triangles at a half-edge from a to b; c is to its left, d to its right.
struct Pair {
  std::int32_t a, b, c, d;
  Pair(const HalfEdgeMesh& mesh, std::int32_t h)
      : a(mesh.origin(h)),
        b(mesh.target(h)),
        c(mesh.target(HalfEdgeMesh::next(h))),
        d(mesh.target(HalfEdgeMesh::next(mesh.opposite[h]))) {}
};

bool isWorthFlipping(const HalfEdgeMesh& mesh, std::int32_t h) {
  const Pair at(mesh, h);
  if (at.c == at.d || isEdge(mesh, HalfEdgeMesh::previous(h), at.d)) return false;
  const Vector3d &a = mesh.points[at.a], &b = mesh.points[at.b], &c = mesh.points[at.c],
                 &d = mesh.points[at.d];
  if (std::min(heightOf(a, d, c), heightOf(d, b, c)) <=
      std::min(heightOf(a, b, c), heightOf(b, a, d)))
    return false;
  const Vector3d whole = (b - a).cross(c - a) + (a - b).cross(d - b);
  return (d - a).cross(c - a).dot(whole) > 0 && (b - d).cross(c - d).dot(whole) > 0;
}

void flip(HalfEdgeMesh& mesh, std::int32_t h) {
  const Pair at(mesh, h);
  const std::int32_t g = mesh.opposite[h], t = h / 3, s = g / 3;
  const std::int32_t bc = mesh.opposite[HalfEdgeMesh::next(h)],
                     ca = mesh.opposite[HalfEdgeMesh::previous(h)],
                     ad = mesh.opposite[HalfEdgeMesh::next(g)],
                     db = mesh.opposite[HalfEdgeMesh::previous(g)];
  const auto link = [&](std::int32_t i, std::int32_t j) {
    mesh.opposite[i] = j;
    mesh.opposite[j] = i;
  };
  mesh.triangles[t] = {at.a, at.d, at.c};
  mesh.triangles[s] = {at.d, at.b, at.c};
  link(3 * t, ad);
  link(3 * t + 1, 3 * s + 2);
  link(3 * t + 2, ca);
  link(3 * s, db);
  link(3 * s + 1, bc);
}

}  // namespace

double heightOf(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

double heightOf(const HalfEdgeMesh& mesh, std::int32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return heightOf(mesh.points[a], mesh.points[b], mesh.points[c]);
}

void flipNeedles(HalfEdgeMesh& mesh, double height,
                 const std::function<bool(std::int32_t)>& mayFlip) {
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    bool isChanged = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto t = static_cast<std::int32_t>(i);
      if (heightOf(mesh, t) >= height) continue;
      const auto length = [&](std::int32_t h) {
        return (mesh.points[mesh.target(h)] - mesh.points[mesh.origin(h)]).squaredNorm();
      };
      std::int32_t longest = 3 * t;
      for (int k = 1; k < 3; ++k) {
        if (length(3 * t + k) > length(longest)) longest = 3 * t + k;
      }
      if (!mayFlip(longest) || !isWorthFlipping(mesh, longest)) continue;
      flip(mesh, longest);
      isChanged = true;
    }
    if (!isChanged) return;
  }
}

}  // namespace swept::step
