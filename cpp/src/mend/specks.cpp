// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mend/specks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swept {
namespace {

constexpr double kMostVolume = 0.01;  ///< cubic cells
constexpr double kMostSize = 2;       ///< cells

struct Shell {
  Eigen::AlignedBox3d box;
  Eigen::Vector3d origin;  // of the volume sum: near, so that little is lost
  double volume = 0;       // six times
  bool seen = false;
};

/// Which shells go.
std::vector<bool> findSpecks(const TriMesh& mesh, const std::vector<std::int32_t>& shellOf,
                             double cell, Specks& found) {
  const std::int32_t count = *std::max_element(shellOf.begin(), shellOf.end()) + 1;
  std::vector<Shell> shells(count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Shell& shell = shells[shellOf[t]];
    const auto& [a, b, c] = mesh.triangles[t];
    if (!shell.seen) shell.origin = mesh.vertices[a];
    shell.seen = true;
    for (const std::int32_t v : {a, b, c}) shell.box.extend(mesh.vertices[v]);
    const Eigen::Vector3d p = mesh.vertices[a] - shell.origin, q = mesh.vertices[b] - shell.origin,
                          r = mesh.vertices[c] - shell.origin;
    shell.volume += p.dot(q.cross(r));
  }
  std::vector<bool> speck(count);
  for (std::int32_t s = 0; s < count; ++s) {
    const double volume = std::abs(shells[s].volume) / 6 / (cell * cell * cell);
    const double size = shells[s].box.diagonal().norm() / cell;
    if (volume >= kMostVolume || size >= kMostSize) continue;
    speck[s] = true;
    ++found.count;
    found.largestVolume = std::max(found.largestVolume, volume);
    found.largestSize = std::max(found.largestSize, size);
  }
  if (found.count == count) {
    found = {};
    speck.assign(count, false);
  }
  return speck;
}

/// Keeps the entries of `values` that have a new number.
template <class T>
void compact(std::vector<T>& values, const std::vector<std::int32_t>& number) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (number[i] >= 0) values[kept++] = values[i];
  }
  values.resize(kept);
}

std::vector<std::int32_t> numberKept(const std::vector<bool>& kept) {
  std::vector<std::int32_t> number(kept.size(), -1);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) number[i] = next++;
  }
  return number;
}

}  // namespace

Specks dropSpecks(Surface& surface, const std::vector<std::int32_t>& shellOf, double cell,
                  SelfIntersections& pairs) {
  Specks found;
  TriMesh& mesh = surface.mesh;
  const std::vector<bool> speck = findSpecks(mesh, shellOf, cell, found);
  if (found.count == 0) return found;
  std::vector<bool> keepsTriangle(mesh.triangles.size()), keepsVertex(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    keepsTriangle[t] = !speck[shellOf[t]];
    if (!keepsTriangle[t]) continue;
    for (const std::int32_t v : mesh.triangles[t]) keepsVertex[v] = true;
  }
  const auto triangle = numberKept(keepsTriangle), vertex = numberKept(keepsVertex);
  compact(mesh.triangles, triangle);
  compact(surface.crossingOf, triangle);
  for (auto& t : mesh.triangles) {
    for (std::int32_t& v : t) v = vertex[v];
  }
  surface.dualVertices = static_cast<std::size_t>(std::count_if(
      vertex.begin(), vertex.begin() + static_cast<std::ptrdiff_t>(surface.dualVertices),
      [](std::int32_t v) { return v >= 0; }));
  compact(mesh.vertices, vertex);
  compact(surface.contactTime, vertex);
  compact(surface.alone, vertex);
  SelfIntersections left;
  for (const auto& [a, b] : pairs.pairs) {
    if (triangle[a] >= 0 && triangle[b] >= 0) left.pairs.emplace_back(triangle[a], triangle[b]);
  }
  left.count = pairs.count - static_cast<std::int64_t>(pairs.pairs.size() - left.pairs.size());
  pairs = left;
  return found;
}

}  // namespace swept
