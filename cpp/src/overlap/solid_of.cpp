// SPDX-License-Identifier: LGPL-2.1-or-later
#include "overlap/solid_of.h"

#include <vector>

#include "geometry/half_edges.h"
#include "geometry/mesh_parts.h"
#include "geometry/shells.h"
#include "input/body_check.h"
#include "overlap/combine.h"
#include "overlap/meetings.h"

namespace swept::overlap {
namespace {

/// Returns the union of the solids [begin, end): unites each half, then the two results.
TriMesh unionOf(const std::vector<TriMesh>& solids, std::size_t begin, std::size_t end,
                const std::string& name, RunContext& run) {
  if (end - begin == 1) return solids[begin];
  const std::size_t middle = begin + (end - begin) / 2;
  const TriMesh first = unionOf(solids, begin, middle, name, run);
  const TriMesh second = unionOf(solids, middle, end, name, run);
  return combine(Keep::Outside, first, name, second, name, run).mesh;
}

/// Assigns each shell to a solid. A solid is a shell that bounds material, together with the
/// cavities in it. A cavity outside all solids gets -1. Returns the number of solids.
std::size_t numberSolids(const TriMesh& mesh, const Shells& shells,
                         const std::vector<ShellExtent>& extents,
                         std::vector<std::int32_t>& solidOfShell) {
  solidOfShell.assign(shells.count, -1);
  std::size_t count = 0;
  for (std::int32_t s = 0; s < shells.count; ++s)
    if (extents[s].volume > 0) solidOfShell[s] = static_cast<std::int32_t>(count++);
  const RayColumns columns(mesh);
  const ShellNesting nesting(mesh, shells, columns);
  for (std::int32_t s = 0; s < shells.count; ++s) {
    if (extents[s].volume > 0) continue;
    std::int32_t outer = -1;  // the smallest shell that bounds material and contains this cavity
    for (const std::int32_t candidate : nesting.shellsAround(extents[s].first))
      if (extents[candidate].volume > 0 &&
          (outer < 0 || extents[candidate].volume < extents[outer].volume))
        outer = candidate;
    if (outer >= 0) solidOfShell[s] = solidOfShell[outer];
  }
  return count;
}

/// Splits a mesh into its solids, each with its own vertices. Leaves out shells with the number -1.
std::vector<TriMesh> split(const TriMesh& mesh, const Shells& shells,
                           const std::vector<std::int32_t>& solidOfShell, std::size_t count) {
  std::vector<TriMesh> solids(count);
  std::vector<std::vector<std::int32_t>> trianglesOf(count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (const std::int32_t solid = solidOfShell[shells.ofTriangle[t]]; solid >= 0)
      trianglesOf[solid].push_back(static_cast<std::int32_t>(t));
  std::vector<std::int32_t> number(mesh.vertices.size());
  for (std::size_t solid = 0; solid < count; ++solid) {
    for (const std::int32_t t : trianglesOf[solid])
      for (const std::int32_t corner : mesh.triangles[t]) number[corner] = -1;
    for (const std::int32_t t : trianglesOf[solid]) takeTriangle(mesh, t, number, solids[solid]);
  }
  return solids;
}

/// Returns whether the boxes of any two shells that bound material overlap.
bool mayOverlap(const std::vector<ShellExtent>& shells) {
  for (std::size_t i = 0; i < shells.size(); ++i)
    for (std::size_t j = i + 1; j < shells.size(); ++j)
      if (shells[i].volume > 0 && shells[j].volume > 0 && shells[i].box.intersects(shells[j].box))
        return true;
  return false;
}

}  // namespace

TriMesh solidOf(const TriMesh& mesh, const std::string& name, RunContext& run) {
  CheckedBody body;
  try {
    body = checkBody(mesh, Options{}, run);
  } catch (const Error& e) {
    throw Error(e.status(), e.code(), name + ": " + e.what());
  }
  closedMesh(body.mesh, name);
  const Shells shells = shellsByEdges(findAdjacency(body.mesh).across);
  const std::vector<ShellExtent> extents = measureShells(body.mesh, shells);
  if (!mayOverlap(extents)) return std::move(body.mesh);
  std::vector<std::int32_t> solidOfShell;
  const std::size_t count = numberSolids(body.mesh, shells, extents, solidOfShell);
  const std::vector<TriMesh> solids = split(body.mesh, shells, solidOfShell, count);
  return unionOf(solids, 0, solids.size(), name, run);
}

}  // namespace swept::overlap
