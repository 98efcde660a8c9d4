// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/pilot.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "sampling/contributing_edges.h"
#include "sampling/sampler.h"
#include "sampling/signs.h"

namespace swept {
namespace {

/// Measured: 240 to 320 bytes a crossing at the peak of a run (docs/performance.md).
constexpr double kBytesPerCrossing = 340;
/// Finer grids see a little more of thin walls and gaps than the square of the resolution.
constexpr double kRoom = 1.1;
constexpr double kLeastRatio = 2;         ///< of the resolutions
constexpr double kMostCopiedFaces = 5e7;  ///< of a union of copies

std::int64_t countCrossings(const SamplerInput& input, RunContext& run) {
  const MarkedEdges marked = sampleCpu(input, run);
  const SignRuns signs = findOutside(marked, input.grid, run);
  std::atomic<std::int64_t> crossings{0};
  parallelFor(marked.layers.size(), [&](std::size_t i) {
    std::int64_t here = 0;
    for (int axis = 0; axis < 3; ++axis) {
      forContributing(
          marked, signs, input.grid, static_cast<std::int32_t>(i), axis,
          [&](std::int32_t, const MarkedEdge&, std::uint8_t sides) { here += sides == 3 ? 2 : 1; });
    }
    crossings += here;
  });
  return crossings;
}

}  // namespace

Estimate estimateByPilot(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const Options& options, RunContext& run) {
  const auto [x, y, z] = prepared.grid.cells();
  const double ratio = static_cast<double>(std::max({x, y, z})) / kPilotCells;
  const double copies = static_cast<double>(prepared.body.mesh.triangles.size()) *
                        static_cast<double>(prepared.motion.placements.size());
  if (ratio < kLeastRatio || options.offset > 0 || options.conservative) return estimate;
  if (!prepared.motion.continuous && copies > kMostCopiedFaces) return estimate;
  Prepared coarse;
  coarse.body = prepared.body;
  coarse.trajectory = prepared.trajectory;
  Options plain = options;
  plain.cellSize = prepared.grid.cell * ratio;
  planRun(coarse, plain, run);
  if (!fitsMemory(estimateOf(coarse, plain), run)) return estimate;
  const std::int64_t crossings = countCrossings({coarse.body.mesh, topology, coarse.motion,
                                                 coarse.grid, options.cull, coarse.body.orientable},
                                                run);
  const double expected = kRoom * ratio * ratio * static_cast<double>(crossings);
  const double faces = static_cast<double>(coarse.body.mesh.triangles.size());
  Estimate better = estimate;
  better.triangles = std::min(estimate.triangles, static_cast<std::int64_t>(2 * expected));
  better.memoryBytes = std::min(
      estimate.memoryBytes, static_cast<std::uint64_t>(expected * kBytesPerCrossing + faces * 200));
  return better;
}

}  // namespace swept
