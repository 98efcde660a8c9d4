// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/body_weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace swept {
namespace {

// A cross product below this fraction of the product of two edge lengths may consist of rounding
// errors.
constexpr double kNoArea = 1e-15;

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 32;
  x *= 0xd6e8feb86659fd93ull;
  x ^= x >> 29;
  x *= 0xa0761d6478bd642full;
  return x ^ (x >> 32);
}

std::uint64_t hashPoint(const Eigen::Vector3d& p) {
  // Adding 0.0 turns -0.0 into 0.0.
  return mix(std::bit_cast<std::uint64_t>(p.x() + 0.0) +
             mix(std::bit_cast<std::uint64_t>(p.y() + 0.0) +
                 mix(std::bit_cast<std::uint64_t>(p.z() + 0.0))));
}

std::size_t tableSize(std::size_t entries) { return std::bit_ceil(entries * 2 + 16); }

bool hasNoArea(const TriMesh& mesh, const std::array<std::int32_t, 3>& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const Eigen::Vector3d u = mesh.vertices[t[1]] - mesh.vertices[t[0]];
  const Eigen::Vector3d v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
  // Scaling keeps the squares of tiny and huge coordinates within the range of double.
  const double scale = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  if (!(scale > 0)) return true;
  const Eigen::Vector3d a = u / scale;
  const Eigen::Vector3d b = v / scale;
  return a.cross(b).squaredNorm() <= kNoArea * kNoArea * a.squaredNorm() * b.squaredNorm();
}

std::array<std::int32_t, 3> sorted(std::array<std::int32_t, 3> t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Returns true if the corners are an even permutation of the sorted corners.
bool isEven(const std::array<std::int32_t, 3>& t) {
  return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2]));
}

void note(std::vector<std::int64_t>& list, std::size_t index) {
  if (list.size() < 8) list.push_back(static_cast<std::int64_t>(index));
}

template <class T>
void eraseMarked(std::vector<T>& list, const std::vector<std::uint8_t>& removed) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < list.size(); ++t) {
    if (removed[t] == 0) list[kept++] = list[t];
  }
  list.resize(kept);
}

void dropTriangles(TriMesh& mesh, const std::vector<std::uint8_t>& removed) {
  eraseMarked(mesh.triangles, removed);
  eraseMarked(mesh.faceOf, removed);
}

/// Marks the triangles to remove in `removed`. `group`: all triangles with the same three corners,
/// in ascending order.
void markGroup(const TriMesh& mesh, const std::vector<std::int64_t>& group, bool keepSheets,
               std::vector<std::uint8_t>& removed, CleanCounts& counts) {
  std::int64_t firstOf[2] = {-1, -1};
  for (const std::int64_t t : group) {
    std::int64_t& first = firstOf[isEven(mesh.triangles[t]) ? 1 : 0];
    if (first < 0) {
      first = t;
      continue;
    }
    removed[t] = 1;
    ++counts.repeated;
    note(counts.firstDuplicate, static_cast<std::size_t>(t));
  }
  if (firstOf[0] >= 0 && firstOf[1] >= 0 && !keepSheets) {
    removed[firstOf[0]] = removed[firstOf[1]] = 1;
    counts.opposite += 2;
    note(counts.firstDuplicate, static_cast<std::size_t>(std::min(firstOf[0], firstOf[1])));
  }
}

void dropUnused(TriMesh& mesh) {
  std::vector<std::int32_t> map(mesh.vertices.size(), -1);
  for (const auto& tri : mesh.triangles) {
    for (const std::int32_t v : tri) map[v] = 0;
  }
  std::int32_t kept = 0;
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (map[v] < 0) continue;
    map[v] = kept;
    mesh.vertices[kept++] = mesh.vertices[v];
  }
  if (static_cast<std::size_t>(kept) == map.size()) return;
  mesh.vertices.resize(static_cast<std::size_t>(kept));
  for (auto& tri : mesh.triangles) {
    for (auto& v : tri) v = map[v];
  }
}

}  // namespace

std::vector<std::int32_t> exactWeld(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::int32_t> map(vertices.size());
  std::vector<std::int32_t> table(tableSize(vertices.size()), -1);
  const std::size_t mask = table.size() - 1;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    std::size_t slot = hashPoint(vertices[v]) & mask;
    while (table[slot] >= 0 && vertices[table[slot]] != vertices[v]) slot = (slot + 1) & mask;
    if (table[slot] < 0) table[slot] = static_cast<std::int32_t>(v);
    map[v] = table[slot];
  }
  return map;
}

std::vector<std::int32_t> toleranceWeld(const std::vector<Eigen::Vector3d>& vertices,
                                        const std::vector<std::uint8_t>& candidates,
                                        double tolerance) {
  std::vector<std::int32_t> map(vertices.size());
  std::size_t count = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    map[v] = static_cast<std::int32_t>(v);
    count += candidates[v];
  }
  // Hashes the points by boxes with sides of two tolerances. All points within one tolerance of a
  // point lie in the box of this point or in an adjacent one.
  const double box = 2 * tolerance;
  auto cellOf = [&](const Eigen::Vector3d& p, int axis, int step) {
    return std::floor(p[axis] / box) + step;
  };
  auto hashCell = [&](double x, double y, double z) { return hashPoint(Eigen::Vector3d(x, y, z)); };
  std::vector<std::int32_t> head(tableSize(count), -1);
  std::vector<std::int32_t> next(vertices.size(), -1);
  const std::size_t mask = head.size() - 1;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (candidates[v] == 0) continue;
    const Eigen::Vector3d& p = vertices[v];
    double best = tolerance;
    for (int n = 0; n < 27; ++n) {
      const std::size_t slot =
          hashCell(cellOf(p, 0, n % 3 - 1), cellOf(p, 1, n / 3 % 3 - 1), cellOf(p, 2, n / 9 - 1)) &
          mask;
      for (std::int32_t other = head[slot]; other >= 0; other = next[other]) {
        const double distance = (vertices[other] - p).norm();
        if (distance > best || (distance == best && other >= map[v])) continue;
        best = distance;
        map[v] = other;
      }
    }
    if (map[v] != static_cast<std::int32_t>(v)) continue;
    const std::size_t slot = hashCell(cellOf(p, 0, 0), cellOf(p, 1, 0), cellOf(p, 2, 0)) & mask;
    next[v] = head[slot];
    head[slot] = static_cast<std::int32_t>(v);
  }
  return map;
}

std::int64_t applyMap(const std::vector<std::int32_t>& map, TriMesh& mesh) {
  std::int64_t changed = 0;
  for (std::size_t v = 0; v < map.size(); ++v) changed += map[v] != static_cast<std::int32_t>(v);
  if (changed == 0) return 0;
  for (auto& tri : mesh.triangles) {
    for (auto& v : tri) v = map[v];
  }
  return changed;
}

EdgeTable cleanTriangles(TriMesh& mesh, CleanCounts& counts, bool keepSheets) {
  std::vector<std::uint8_t> removed(mesh.triangles.size(), 0);
  bool any = false;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!hasNoArea(mesh, mesh.triangles[t])) continue;
    removed[t] = 1;
    any = true;
    ++counts.degenerate;
    note(counts.firstDegenerate, t);
  }
  if (any) dropTriangles(mesh, removed);

  // Find duplicates: triangles with the same three corners. They share all three edges, so it
  // suffices to compare triangles at the edge between their two lowest corners. Duplicates have the
  // same third corner there.
  dropUnused(mesh);
  EdgeTable edges(mesh);
  removed.assign(mesh.triangles.size(), 0);
  any = false;
  std::vector<std::pair<std::int32_t, std::int64_t>> thirds;
  std::vector<std::int64_t> group;
  edges.forEachEdge(
      [&](std::int32_t, std::int32_t high, const std::uint64_t* first, const std::uint64_t* last) {
        if (last - first < 2) return;
        thirds.clear();
        for (const std::uint64_t* r = first; r != last; ++r) {
          const std::int64_t t = EdgeTable::halfEdge(*r) / 3;
          const std::int32_t largest = sorted(mesh.triangles[t])[2];
          if (largest > high) thirds.emplace_back(largest, t);
        }
        if (thirds.size() < 2) return;
        std::sort(thirds.begin(), thirds.end());
        for (std::size_t i = 0; i < thirds.size();) {
          group.clear();
          std::size_t j = i;
          for (; j < thirds.size() && thirds[j].first == thirds[i].first; ++j) {
            group.push_back(thirds[j].second);
          }
          if (group.size() > 1) {
            markGroup(mesh, group, keepSheets, removed, counts);
            any = true;
          }
          i = j;
        }
      });
  if (!any) return edges;
  dropTriangles(mesh, removed);
  dropUnused(mesh);
  return EdgeTable(mesh);
}

}  // namespace swept
