// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/pilot.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sampling/sampler.h"
#include "signs/count_crossings.h"

namespace swept {
namespace {

/// Bytes per crossing and per edge with a thin wall. Measured peaks of runs are 240 to 300 per
/// crossing (docs/performance.md). Thin walls need more, to compare the surfaces that may touch
/// there.
constexpr double kBytesPerCrossing = 310, kBytesPerWall = 700;
constexpr double kGrowthReserve = 1.1;
constexpr double kMinRatio = 2;  ///< smallest ratio of the resolutions of run and pilot
/// Largest number of faces times placements in a trial of a union of copies.
constexpr double kMaxCopiedFaces = 5e7;

}  // namespace

Estimate estimateByPilot(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const Options& options, RunContext& run) {
  const auto [x, y, z] = prepared.grid.cells();
  const double ratio = static_cast<double>(std::max({x, y, z})) / kPilotCells;
  const double copies = static_cast<double>(prepared.body.mesh.triangles.size()) *
                        static_cast<double>(prepared.motion.placements.size());
  if (ratio < kMinRatio || options.offset > 0 || options.conservative) return estimate;
  if (!prepared.motion.continuous && copies > kMaxCopiedFaces) return estimate;
  const auto countAt = [&](double coarser) -> std::optional<CrossingCounts> {
    Prepared coarse;
    coarse.body = prepared.body;
    coarse.keepBody = true;
    coarse.trajectory = prepared.trajectory;
    Options plain = options;
    plain.cellSize = prepared.grid.cell * coarser;
    if (plain.chordTolerance) *plain.chordTolerance *= coarser;
    planRun(coarse, plain, run);
    if (!fitsMemory(estimateOf(coarse, plain), run)) return std::nullopt;
    const SamplerInput input{coarse.body.mesh, topology,     coarse.motion,
                             coarse.grid,      options.cull, coarse.body.orientable};
    return countCrossings(sampleCpu(input, run), coarse.grid, run);
  };
  const std::optional<CrossingCounts> coarse = countAt(2 * ratio), fine = countAt(ratio);
  if (!coarse || !fine || coarse->crossings == 0) return estimate;
  // On a grid twice as fine, a surface has four times as many crossings, and even more if the finer
  // grid resolves more thin walls.
  const double power = std::clamp(
      std::log2(static_cast<double>(fine->crossings) / static_cast<double>(coarse->crossings)), 2.0,
      2.5);
  const double growth = kGrowthReserve * std::pow(ratio, power);
  const double crossings = growth * static_cast<double>(fine->crossings);
  const double walls = growth * static_cast<double>(fine->walls);
  const double faces = static_cast<double>(prepared.body.mesh.triangles.size());
  Estimate better = estimate;
  better.triangles = static_cast<std::int64_t>(2 * crossings);
  better.memoryBytes = static_cast<std::uint64_t>(crossings * kBytesPerCrossing +
                                                  walls * kBytesPerWall + faces * 200);
  return better;
}

}  // namespace swept
