// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/specks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "check/mesh_check.h"
#include "contour/mend/keep_triangles.h"
#include "geometry/shells.h"

namespace swept {
namespace {

/// A shell round one or two lattice edges is smaller than this (cells).
constexpr double kMaxSpeckSize = 2;
/// Inside-out shells larger than this (cells) are left for the checker to report.
constexpr double kMaxTurnedSize = 4;

/// Marks the shells to drop. If this would drop all shells, `found` stays empty.
std::vector<bool> findSpecks(const std::vector<ShellExtent>& shells, double cell, double maxVolume,
                             Specks& found) {
  std::vector<bool> speck(shells.size());
  bool others = false;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const double size = shells[s].box.diagonal().norm() / cell;
    const double volume = std::abs(shells[s].volume) / (cell * cell * cell);
    if (size >= kMaxSpeckSize || volume >= maxVolume) {
      others = true;
      continue;
    }
    speck[s] = true;
    ++found.count;
    found.largestVolume = std::max(found.largestVolume, volume);
    found.largestSize = std::max(found.largestSize, size);
  }
  if (!others) found = {};
  return speck;
}

}  // namespace

Specks dropSpecks(Surface& surface, double cell, double maxVolume, SelfIntersections& pairs,
                  RunContext& run) {
  Specks found;
  TriMesh& mesh = surface.mesh;
  run.checkpoint(Phase::Check);
  const Shells shells = shellsByVertices(mesh);
  if (shells.count < 2) return found;
  const std::vector<bool> speck = findSpecks(measureShells(mesh, shells), cell, maxVolume, found);
  if (found.count == 0) return found;
  std::vector<std::uint8_t> keeps(mesh.triangles.size());
  for (std::size_t t = 0; t < keeps.size(); ++t) keeps[t] = speck[shells.ofTriangle[t]] ? 0 : 1;
  keepTriangles(surface, keeps, pairs);
  return found;
}

std::int64_t turnInsideOut(Surface& surface, const MeshTopology& topology, double cell,
                           RunContext& run) {
  std::vector<bool> turned(static_cast<std::size_t>(topology.shells.count));
  for (const InsideOutShell& found : shellsInsideOut(surface.mesh, topology, run)) {
    if (found.size < kMaxTurnedSize * cell) turned[found.shell] = true;
  }
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    if (!turned[topology.shells.ofTriangle[t]]) continue;
    auto& [a, b, c] = surface.mesh.triangles[t];
    std::swap(b, c);
  }
  return std::count(turned.begin(), turned.end(), true);
}

}  // namespace swept
