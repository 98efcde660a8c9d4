// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/rough_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/timer.h"
#include "crossings/hermite.h"
#include "pipeline/probe_trial.h"
#include "signs/count_crossings.h"
#include "signs/signs.h"

namespace swept {
namespace {

/// How many placements are taken: so many, unless their faces are too many together.
constexpr std::size_t kFewest = 6, kMost = 192;
/// A motion of no more placements is taken whole.
constexpr std::size_t kMostWhole = 384;
/// The grid is up to so many times coarser, with at least so many cells along its longest side.
constexpr std::int32_t kCoarsest = 8, kFewestCells = 12;
/// Motions of fewer steps are looked at in one place before they are sampled.
constexpr std::size_t kFewSteps = 16;
/// Of so many crossings about normals and times are found.
constexpr double kRoughCrossings = 5e5;

/// The same room in larger cells; its outermost points stay outside.
GridPlan coarser(GridPlan grid, std::int32_t times) {
  grid.cell *= times;
  for (std::int32_t& points : grid.points) points = (points - 2) / times + 2;
  return grid;
}

/// The motion along `wanted` of its placements.
Motion thinned(const Motion& motion, std::size_t wanted) {
  Motion part;
  part.continuous = motion.continuous;
  const std::size_t last = motion.placements.size() - 1;
  for (std::size_t n = 0, before = 0; n < wanted; ++n) {
    const std::size_t at = wanted == 1 ? last / 2 : n * last / (wanted - 1);
    if (n > 0 && part.continuous) {
      const std::size_t middle = (before + at) / 2;
      part.midpoints.push_back((before + at) % 2 == 0 ? motion.placements[middle]
                                                      : motion.midpoints[middle]);
    }
    part.placements.push_back(motion.placements[at]);
    before = at;
  }
  return part;
}

}  // namespace

MarkedEdges sampleCounted(SamplerInput input, SamplingCost& cost, RunContext& run) {
  const double start = threadSeconds();
  std::uint64_t crossings = 0;
  input.crossings = &crossings;
  MarkedEdges marked = sampleCpu(input, run);
  cost.add({threadSeconds() - start, static_cast<double>(crossings),
            static_cast<double>(marked.elements.size())},
           1);
  return marked;
}

RoughRoom roomBeside(const SamplingCost& sampling, double copies) {
  constexpr double kPart = 0.05;
  const RoughRoom least, most{6e6, 2e7};
  return {std::clamp(kPart * copies, least.faces, most.faces),
          std::clamp(kPart * sampling.crossings, least.crossings, most.crossings)};
}

RoughSurface roughSurface(const SamplerInput& whole, const RoughRoom& room,
                          std::optional<MarkedEdges> known, ComponentMethod components, bool probes,
                          RunContext& run) {
  SamplingCost cost;
  const auto sampled = [&](const Motion& motion, const GridPlan& grid, PlacementRange only = {}) {
    SamplerInput input{whole.body,       whole.topology, motion,  grid,    whole.cull,
                       whole.orientable, whole.clusters, nullptr, nullptr, whole.fillsHollows};
    input.only = only;
    cost = {};
    return sampleCounted(input, cost, run);
  };
  // The smallest cells that there is room for, from a few placements on the coarsest grid.
  const auto coarseningFor = [&](const Motion& motion) {
    const std::int32_t longest =
        *std::max_element(whole.grid.points.begin(), whole.grid.points.end());
    const std::int32_t most = std::clamp(longest / kFewestCells, 1, kCoarsest);
    if (most == 1) return 1;
    const std::size_t count = motion.continuous ? motion.steps() : motion.placements.size();
    const std::size_t looks = count < kFewSteps ? 1 : 2;
    double crossings = 0;
    for (std::size_t n = 0; n < looks; ++n) {
      const std::size_t at = (2 * n + 1) * count / (2 * looks);
      sampled(motion, coarser(whole.grid, most), {at, at + 1});
      crossings +=
          cost.crossings * most * most * static_cast<double>(count) / static_cast<double>(looks);
    }
    return std::clamp(static_cast<std::int32_t>(std::ceil(std::sqrt(crossings / room.crossings))),
                      1, most);
  };
  const double faces = static_cast<double>(whole.body.triangles.size());
  const std::size_t all = whole.motion.placements.size();
  const auto wanted = static_cast<std::size_t>(room.faces / faces);
  const bool few = known || (all <= kMostWhole && all <= wanted);
  Motion part =
      thinned(whole.motion, few ? all : std::min(std::clamp(wanted, kFewest, kMost), all));
  const std::int32_t times = known ? 1 : coarseningFor(part);
  const GridPlan grid = coarser(whole.grid, times);
  MarkedEdges marked = known ? std::move(*known) : sampled(part, grid);
  RoughSurface found;
  const auto crossings = static_cast<double>(countCrossings(marked, grid, run).crossings);
  found.crossings = crossings * times * times;
  if (!probes) return found;
  if (crossings > kRoughCrossings && !known) {
    const double fewer = static_cast<double>(part.placements.size()) * kRoughCrossings / crossings;
    part = thinned(whole.motion, std::max<std::size_t>(2, static_cast<std::size_t>(fewer)));
    marked = sampled(part, grid);
  }
  const SignRuns signs = findOutside(marked, grid, run);
  const SamplerInput input{whole.body, whole.topology, part, grid, whole.cull, whole.orientable};
  const HermiteGrid hermite = buildHermiteGrid(input, marked, signs, ExactTimes::Dropped, run);
  const SamplerInput onGrid{whole.body, whole.topology, whole.motion,
                            grid,       whole.cull,     whole.orientable};
  found.probes = tryProbes(onGrid, {part, marked, hermite}, components);
  if (hermite.crossings.empty()) return found;
  // In cells r times smaller, between r (creases) and r * r (what trembles) times as many probes
  // are cast, each at r * r times fewer pieces.
  const double r = times, share = crossings / static_cast<double>(hermite.crossings.size());
  found.probes.casts *= share * r * std::sqrt(r);
  found.probes.seconds *= share / std::sqrt(r);
  return found;
}

}  // namespace swept
