// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/body_solid.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"
#include "solid/reread.h"

namespace swept::step {
namespace {

/// Fraction of the tolerance: how far the triangles that measure the deviation may lie from the
/// faces of the solid.
constexpr double kDeflection = 0.02;

// Returns the largest distance of the crossings from the surface, or more than `limit`.
double largestDistance(const std::vector<SurfaceSource>& crossings, const TriMesh& surface,
                       double limit) {
  const NearestTriangle nearest(surface.vertices, surface.triangles);
  constexpr std::size_t kBlock = 4096;
  std::vector<double> largest((crossings.size() + kBlock - 1) / kBlock, 0);
  parallelBlocks(crossings.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::int32_t hint = -1;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = nearest.query(crossings[i].point, 4 * limit * limit, 0, hint);
      largest[begin / kBlock] = std::max(largest[begin / kBlock], squared);
    }
  });
  double result = 0;
  for (const double squared : largest) result = std::max(result, squared);
  return std::sqrt(result);
}

}  // namespace

std::optional<Built> makeFromBody(const HalfEdgeMesh& mesh, const SolidOptions& options,
                                  const std::function<bool(std::int64_t)>& fits, Judge& judge,
                                  RunContext& run) {
  std::optional<Assembly> assembly;
  try {
    judge.guard(
        [&] { assembly = judge.assemble(options, mesh, kDeflection * options.tolerance, run); },
        run);
  } catch (const Error& error) {
    if (error.status() != Status::ExportFailed) throw;
  }
  run.checkpoint(Phase::Export);
  if (!assembly || !fits(assembly->check.faces)) return std::nullopt;
  if (!rereadComplaint(assembly->check, mesh, options).empty()) return std::nullopt;
  Built built;
  built.facesByKind = std::move(assembly->facesByKind);
  built.deviation =
      largestDistance(*options.origin->sources.rows, assembly->surface, options.tolerance);
  if (built.deviation > options.tolerance) return std::nullopt;
  return built;
}

}  // namespace swept::step
