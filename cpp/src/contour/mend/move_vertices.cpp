// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/move_vertices.h"

#include <algorithm>
#include <unordered_map>

#include "base/parallel.h"
#include "check/near_pairs.h"
#include "contour/mend/region.h"
#include "geometry/exact_predicates.h"

namespace swept {
namespace {

using Positions = std::unordered_map<std::int32_t, Eigen::Vector3d>;

bool hasArea(const TriMesh& mesh, std::int32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return !collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
}

/// Applies the moves, then takes back the moves of intersecting triangles until none intersect.
/// Returns the moves that were taken back.
std::vector<VertexMove> applyMoves(TriMesh& mesh, const GridPlan& plan,
                                   const std::vector<VertexMove>& moves, RunContext& run) {
  Positions before;  // first positions of the vertices that have moved
  for (const VertexMove& move : moves) {
    before.emplace(move.vertex, mesh.vertices[move.vertex]);
    mesh.vertices[move.vertex] = move.position;
  }
  std::vector<std::int32_t> members =
      gather<std::int32_t>(mesh.triangles.size(), kTrianglesPerTask,
                           [&](std::size_t t, std::vector<std::int32_t>& part) {
                             const auto& corners = mesh.triangles[t];
                             if (std::any_of(corners.begin(), corners.end(),
                                             [&](std::int32_t v) { return before.contains(v); }))
                               part.push_back(static_cast<std::int32_t>(t));
                           });
  std::vector<VertexMove> back;
  const auto undo = [&](std::int32_t t) {
    for (const std::int32_t v : mesh.triangles[t]) {
      const auto at = before.find(v);
      if (at == before.end()) continue;
      back.push_back({v, mesh.vertices[v]});
      mesh.vertices[v] = at->second;
      before.erase(at);
    }
  };
  const TriangleBlocks blocks(mesh, plan);
  const std::vector<std::int32_t> near = blocks.near(mesh, members, kReachCells);
  for (std::size_t left = before.size() + 1; left > before.size() && !before.empty();) {
    run.checkpoint(Phase::Check);
    left = before.size();
    for (const std::int32_t t : members) {
      if (!hasArea(mesh, t)) undo(t);
    }
    for (const auto& [a, b] : findNearPairs(mesh, members, near, run).pairs) {
      undo(a);
      undo(b);
    }
  }
  return back;
}

}  // namespace

void moveWithoutPairs(Surface& surface, const GridPlan& plan, const std::vector<VertexMove>& moves,
                      RunContext& run) {
  if (moves.empty()) return;
  TriMesh& mesh = surface.mesh;
  std::vector<VertexMove> again = applyMoves(mesh, plan, moves, run);
  for (VertexMove& move : again) move.position = (move.position + mesh.vertices[move.vertex]) / 2;
  applyMoves(mesh, plan, again, run);
}

}  // namespace swept
