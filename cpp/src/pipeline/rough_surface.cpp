// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/rough_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "crossings/hermite.h"
#include "geometry/mesh_parts.h"
#include "pipeline/probe_trial.h"
#include "signs/count_crossings.h"
#include "signs/signs.h"

namespace swept {
namespace {

/// Bounds of the number of placements of the rough motion. Between them, RoughLimits::faces
/// determines the number.
constexpr std::size_t kMinPoses = 6, kMaxPoses = 192;
/// A motion of at most this many placements is not thinned if the number of faces of the body times
/// the number of placements is at most RoughLimits::faces.
constexpr std::size_t kMaxWhole = 384;
/// The grid is at most this many times coarser and has at least this many cells along its longest
/// side.
constexpr std::int32_t kCoarsest = 8, kMinLongestCells = 12;
/// To choose the coarsening, a motion with fewer steps is sampled at one placement, others at two.
constexpr std::size_t kFewSteps = 16;
/// Normals and times are computed for about this many crossings at most.
constexpr double kRoughCrossings = 5e5;

/// Returns a grid for the same space with larger cells. Its outermost points stay outside.
GridPlan coarser(GridPlan grid, std::int32_t times) {
  grid.cell *= times;
  for (std::int32_t& points : grid.points) points = (points - 2) / times + 2;
  return grid;
}

/// Returns the motion with only `wanted` of its placements, evenly spaced.
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

/// Returns how many cells the body travels: the mean over the corners of its bounding box. Side
/// patches have about this total length.
double travelInCells(const SamplerInput& whole, const Motion& motion) {
  const Eigen::AlignedBox3d box = boxOf(whole.body);
  double sum = 0;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n));
    for (std::size_t k = 0; k + 1 < motion.placements.size(); ++k)
      sum += (motion.placements[k + 1].apply(corner) - motion.placements[k].apply(corner)).norm();
  }
  return sum / 8 / whole.grid.cell;
}

/// Returns the factor by which the cells must be larger to stay within `limits`. Estimates the
/// number of crossings from a few placements on the coarsest grid.
std::int32_t coarseningFor(const SamplerInput& whole, const Motion& motion,
                           const RoughLimits& limits, RunContext& run) {
  const std::int32_t longest =
      *std::max_element(whole.grid.points.begin(), whole.grid.points.end());
  const std::int32_t most = std::clamp(longest / kMinLongestCells, 1, kCoarsest);
  if (most == 1) return 1;
  const std::size_t count = motion.continuous ? motion.steps() : motion.placements.size();
  const std::size_t samples = count < kFewSteps ? 1 : 2;
  const GridPlan coarsest = coarser(whole.grid, most);
  SamplerInput input = whole.with(motion, coarsest);
  double crossings = 0;
  for (std::size_t n = 0; n < samples; ++n) {
    const std::size_t at = (2 * n + 1) * count / (2 * samples);
    input.only = {at, at + 1};
    SamplingCost cost;
    sampleCounted(input, cost, run);
    crossings +=
        cost.crossings * most * most * static_cast<double>(count) / static_cast<double>(samples);
  }
  const double stripes = motion.continuous ? static_cast<double>(whole.body.triangles.size()) *
                                                 travelInCells(whole, motion)
                                           : 0;
  const double wanted = std::max(std::sqrt(crossings / limits.crossings), stripes / limits.stripes);
  return static_cast<std::int32_t>(std::clamp(std::ceil(wanted), 1.0, static_cast<double>(most)));
}

}  // namespace

RoughLimits limitsFor(const SamplingCost& sampling, double copies) {
  constexpr double kPart = 0.05;
  const RoughLimits least, most{6e6, 2e7, 6e7};
  return {std::clamp(kPart * copies, least.faces, most.faces),
          std::clamp(kPart * sampling.crossings, least.crossings, most.crossings),
          std::clamp(kPart * copies, least.stripes, most.stripes)};
}

RoughSurface roughSurface(const SamplerInput& whole, const RoughLimits& limits,
                          std::optional<MarkedEdges> known, ComponentMethod components,
                          RunContext& run) {
  const double faces = static_cast<double>(whole.body.triangles.size());
  const std::size_t all = whole.motion.placements.size();
  const auto wanted = static_cast<std::size_t>(limits.faces / faces);
  const bool few = known || (all <= kMaxWhole && all <= wanted);
  Motion part =
      thinned(whole.motion, few ? all : std::min(std::clamp(wanted, kMinPoses, kMaxPoses), all));
  const std::int32_t times = known ? 1 : coarseningFor(whole, part, limits, run);
  const GridPlan grid = coarser(whole.grid, times);
  MarkedEdges marked = known ? std::move(*known) : sampleCpu(whole.with(part, grid), run);
  RoughSurface found;
  const auto crossings = static_cast<double>(countCrossings(marked, grid, run).crossings);
  found.crossings = crossings * times * times;
  if (crossings > kRoughCrossings && !known) {
    const double fewer = static_cast<double>(part.placements.size()) * kRoughCrossings / crossings;
    part = thinned(whole.motion, std::max<std::size_t>(2, static_cast<std::size_t>(fewer)));
    marked = sampleCpu(whole.with(part, grid), run);
  }
  const SignRuns signs = findOutside(marked, grid, run);
  const HermiteGrid hermite =
      buildHermiteGrid(whole.with(part, grid), marked, signs, ExactTimes::Dropped, run);
  const SamplerInput onGrid = whole.with(whole.motion, grid);
  found.probes = tryProbes(onGrid, {part, marked, hermite}, components);
  if (hermite.crossings.empty()) return found;
  // The cells of the run are r times smaller than those of the rough grid. At creases, the run
  // casts r times as many probes. Where a vibration leaves small creases everywhere, it casts r * r
  // times as many. The estimate lies between: r * sqrt(r). Each probe searches r * r times fewer
  // elements.
  const double r = times, ratio = crossings / static_cast<double>(hermite.crossings.size());
  found.probes.casts *= ratio * r * std::sqrt(r);
  found.probes.seconds *= ratio / std::sqrt(r);
  return found;
}

}  // namespace swept
