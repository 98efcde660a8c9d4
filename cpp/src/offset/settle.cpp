// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/settle.h"

#include "base/parallel.h"

namespace swept::offset {
namespace {

using Eigen::Vector3d;

constexpr double kMinDistance = 0.5;  // cells: below this offset distance, no vertex moves
/// Distances (cells) by which a vertex may be too near or too far. On a round offset, the corners
/// of a triangle must lie slightly outside. Otherwise the middle of the triangle would be too near.
constexpr double kMaxShort = 0.002, kMaxLong = 0.08;
/// Cells: a vertex moves by at most this distance.
constexpr double kMaxMove = 1.5;
constexpr int kRounds = 40;

/// Returns the settled position of a vertex. The search starts with the triangle `hint`, such as
/// the one found for the previous vertex. `hint` receives the nearest triangle.
Vector3d settled(const Vector3d& start, const CoverSearch& tree, double distance,
                 std::int32_t& hint) {
  Vector3d x = start;
  for (int round = 0; round < kRounds; ++round) {
    CoverSearch::Nearest found = tree.nearest(x, distance + kMaxLong, hint);
    const bool isFar = found.triangle < 0;
    if (isFar) found = tree.nearest(x, distance + kMaxMove);
    if (found.triangle < 0) return start;
    hint = found.triangle;
    if (!isFar && found.reach >= distance - kMaxShort) return x;
    const Vector3d apart = x - nearestOnTriangle(x, tree.triangle(found.triangle));
    const double length = apart.norm();
    if (!(length > 1e-6)) return start;
    x += (distance + (isFar ? kMaxLong / 2 : 0) - found.reach) / length * apart;
    if ((x - start).squaredNorm() > kMaxMove * kMaxMove) return start;
  }
  return x;
}

}  // namespace

std::vector<VertexMove> settlingMoves(const TriMesh& mesh,
                                      const std::vector<std::int32_t>& vertices,
                                      const CoverSearch& tree, double distance,
                                      const GridPlan& grid, RunContext& run) {
  if (distance < kMinDistance) return {};
  constexpr std::size_t kBlock = 1 << 10;
  const std::size_t count = vertices.size();
  std::vector<std::vector<VertexMove>> parts(count / kBlock + 1);
  parallelBlocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Contour, begin, count);
    std::int32_t hint = -1;
    for (std::size_t n = begin; n < end; ++n) {
      const std::int32_t v = vertices[n];
      const Vector3d start = (mesh.vertices[v] - grid.origin) / grid.cell;
      const Vector3d x = settled(start, tree, distance, hint);
      if (x == start) continue;
      parts[begin / kBlock].push_back({v, grid.origin + grid.cell * x});
    }
  });
  std::vector<VertexMove> moves;
  for (const auto& part : parts) moves.insert(moves.end(), part.begin(), part.end());
  return moves;
}

}  // namespace swept::offset
