// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/rough_surface.h"

#include <algorithm>

#include "base/timer.h"
#include "crossings/hermite.h"
#include "pipeline/probe_trial.h"
#include "signs/count_crossings.h"
#include "signs/signs.h"

namespace swept {
namespace {

/// Faces of all placements together, and how many placements.
constexpr double kRoughFaces = 2e6;
constexpr std::size_t kFewest = 8, kMost = 192;
/// A motion of no more than so many is taken whole, unless it is dense: its sampling is then known
/// as well.
constexpr double kWholeFaces = 12e6;
constexpr std::size_t kMostWhole = 384;
/// About so many are contoured.
constexpr double kRoughCrossings = 1e5;
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

RoughSurface roughSurface(const SamplerInput& whole, ComponentMethod components, bool probes,
                          RunContext& run) {
  SamplingCost cost;
  const auto sampled = [&](const Motion& motion) {
    return sampleCounted({whole.body, whole.topology, motion, whole.grid, whole.cull,
                          whole.orientable, whole.clusters, nullptr, nullptr, whole.fillsHollows},
                         cost, run);
  };
  const double faces = static_cast<double>(whole.body.triangles.size());
  const std::size_t all = whole.motion.placements.size();
  const bool few = probes && all <= kMostWhole && static_cast<double>(all) * faces <= kWholeFaces;
  const std::size_t wanted =
      std::clamp(static_cast<std::size_t>(kRoughFaces / faces), kFewest, kMost);
  Motion part = thinned(whole.motion, few ? all : std::min(wanted, all));
  MarkedEdges marked = sampled(part);
  RoughSurface found;
  if (part.placements.size() == all) found.all = cost;
  found.crossings = static_cast<double>(countCrossings(marked, whole.grid, run).crossings);
  if (!probes) return found;
  if (found.crossings > kRoughCrossings) {
    const double fewer =
        static_cast<double>(part.placements.size()) * kRoughCrossings / found.crossings;
    part = thinned(whole.motion, std::max<std::size_t>(2, static_cast<std::size_t>(fewer)));
    marked = sampled(part);
  }
  const SignRuns signs = findOutside(marked, whole.grid, run);
  const SamplerInput input{whole.body, whole.topology, part,
                           whole.grid, whole.cull,     whole.orientable};
  HermiteGrid hermite = buildHermiteGrid(input, marked, signs, ExactTimes::Dropped, run);
  found.probeSeconds = tryProbes(whole, part, marked, hermite, components, run) /
                       static_cast<double>(std::max<std::size_t>(1, hermite.crossings.size()));
  return found;
}

}  // namespace swept
