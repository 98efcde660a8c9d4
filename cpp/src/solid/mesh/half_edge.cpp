// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/half_edge.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/limits.h"
#include "base/number_text.h"
#include "geometry/half_edges.h"
#include "geometry/mesh_numbers.h"
#include "geometry/ray_columns.h"
#include "geometry/shells.h"

namespace swept::step {
namespace {

[[noreturn]] void refuse(const char* code, const std::string& text) {
  throw Error(Status::ExportFailed, code, text);
}

[[noreturn]] void refuseUnclosed(const char* code, const std::string& what) {
  refuse(code, what +
                   "; a solid needs a closed, oriented mesh with two triangles at each edge: "
                   "repair the mesh, or export it as a mesh file");
}

void checkNumbers(const TriMesh& mesh) {
  if (mesh.triangles.empty())
    refuse("EmptyMesh", "the mesh has no triangles; choose a mesh with a closed surface");
  if (const auto bad = findBadIndex(mesh))
    refuse("BadIndex", badIndexText(*bad, mesh) + "; export the mesh again");
  const Coordinates found = measureCoordinates(mesh);
  if (found.nonFinite > 0) {
    refuse("NonFiniteVertex", "vertex " + std::to_string(found.firstNonFinite[0]) +
                                  " (counted from 0) has a coordinate that is not a finite number; "
                                  "export the mesh again");
  }
  if (found.largest > kMaxLength) {
    refuse("OutOfRange",
           "vertex " + std::to_string(found.farthest) + " (counted from 0) lies " +
               numberText(found.largest, kTellingDigits) +
               " mm from the origin, but the limit is 1e9 mm; check the unit of length, or move "
               "the mesh closer to the origin");
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (a == b || b == c || c == a) {
      refuseUnclosed(
          "DegenerateTriangle",
          "triangle " + std::to_string(t) + " (counted from 0) has the same vertex at two corners");
    }
  }
}

/// Returns a text with a position: the middle of the first edge for which isBad(ascending,
/// descending) is true. The arguments are the numbers of half-edges that run from its lower to its
/// higher vertex index, and back. There must be such an edge.
template <class IsBad>
std::string firstPosition(const TriMesh& mesh, const IsBad& isBad) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  bool found = false;
  EdgeTable(mesh).forEachEdge([&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                                  const std::uint64_t* last) {
    if (found) return;
    const std::int64_t ascending = std::count_if(first, last, EdgeTable::ascending);
    if (!isBad(ascending, last - first - ascending)) return;
    middle = 0.5 * (mesh.vertices[low] + mesh.vertices[high]);
    found = true;
  });
  return textOf(4, " (the first near x = ", middle.x(), ", y = ", middle.y(), ", z = ", middle.z(),
                " mm)");
}

void refuseFaults(const EdgeFaults& faults, const TriMesh& mesh) {
  if (faults.open > 0) {
    refuseUnclosed("OpenMesh",
                   counted(faults.open, "edge belongs", "edges belong") + " to only one triangle" +
                       firstPosition(mesh, [](auto up, auto down) { return up + down == 1; }));
  }
  if (faults.nonManifold > 0) {
    refuseUnclosed("NonManifold",
                   counted(faults.nonManifold, "edge belongs", "edges belong") +
                       " to more than two triangles" +
                       firstPosition(mesh, [](auto up, auto down) { return up + down > 2; }));
  }
  if (faults.misoriented > 0) {
    refuseUnclosed("MixedOrientation",
                   counted(faults.misoriented, "edge lies", "edges lie") +
                       " between triangles that face opposite ways" +
                       firstPosition(mesh, [](auto up, auto down) { return up != down; }));
  }
}

// Gives each fan of triangles its own vertex.
void splitFans(HalfEdgeMesh& mesh) {
  const auto count = static_cast<std::int32_t>(3 * mesh.triangles.size());
  std::vector<char> seen(count, 0), used(mesh.points.size(), 0);
  for (std::int32_t first = 0; first < count; ++first) {
    if (seen[first]) continue;
    std::int32_t vertex = mesh.origin(first);
    if (used[vertex]) {
      mesh.points.push_back(mesh.points[vertex]);
      used.push_back(1);
      vertex = static_cast<std::int32_t>(mesh.points.size()) - 1;
    }
    used[vertex] = 1;
    std::int32_t h = first;
    do {
      seen[h] = 1;
      mesh.triangles[h / 3][h % 3] = vertex;
      h = mesh.opposite[HalfEdgeMesh::previous(h)];
    } while (h != first);
  }
}

/// Finds the outer shell of each cavity: the smallest one that contains it.
void findOwners(const TriMesh& mesh, const Shells& shells, const std::vector<ShellExtent>& extents,
                HalfEdgeMesh& result, RunContext& run) {
  result.shellOwner.resize(shells.count);
  std::iota(result.shellOwner.begin(), result.shellOwner.end(), 0);
  const auto isOuter = [](const ShellExtent& s) { return s.volume > 0; };
  if (std::all_of(extents.begin(), extents.end(), isOuter)) return;
  const RayColumns columns(mesh);
  const ShellNesting nesting(mesh, shells, columns);
  for (std::int32_t s = 0; s < shells.count; ++s) {
    if (isOuter(extents[s])) continue;
    run.checkpoint(Phase::Export);
    std::int32_t best = -1;
    for (const std::int32_t o : nesting.shellsAround(extents[s].first)) {
      // The cavity and its shell may touch at a vertex, so their boxes may touch, too.
      if (!isOuter(extents[o]) || !extents[o].box.contains(extents[s].box)) continue;
      if (best < 0 || extents[o].volume <= extents[best].volume) best = o;
    }
    if (best < 0) {
      const auto& of = shells.ofTriangle;
      refuse("InvertedShell",
             "shell " + std::to_string(s) + " (counted from 0) with " +
                 std::to_string(std::count(of.begin(), of.end(), s)) +
                 " triangles faces inwards, but does not lie inside another shell; reverse its "
                 "triangles, or export a mesh file");
    }
    result.shellOwner[s] = best;
  }
}

}  // namespace

Eigen::Vector3d HalfEdgeMesh::areaVector(std::int32_t triangle) const {
  const auto& t = triangles[triangle];
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
}

std::int64_t countOuterShells(const std::vector<std::int32_t>& shellOwner) {
  std::int64_t count = 0;
  for (std::size_t s = 0; s < shellOwner.size(); ++s)
    count += shellOwner[s] == static_cast<std::int32_t>(s);
  return count;
}

HalfEdgeMesh buildHalfEdges(const TriMesh& mesh, RunContext& run) {
  run.checkpoint(Phase::Export);
  checkNumbers(mesh);
  HalfEdgeMesh result;
  result.points = mesh.vertices;
  result.triangles = mesh.triangles;
  const Adjacency adjacency = findAdjacency(mesh);
  refuseFaults(adjacency.faults, mesh);
  const RawArray<std::uint32_t>& across = adjacency.across;
  result.opposite.assign(across.data(), across.data() + across.size());
  run.checkpoint(Phase::Export);
  splitFans(result);
  Shells shells = shellsByEdges(across);
  const std::vector<ShellExtent> extents = measureShells(mesh, shells);
  findOwners(mesh, shells, extents, result, run);
  result.shellOf = std::move(shells.ofTriangle);
  for (const ShellExtent& shell : extents) result.volume += shell.volume;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    result.area += 0.5 * result.areaVector(static_cast<std::int32_t>(t)).norm();
  }
  return result;
}

}  // namespace swept::step
