// Estimates the number of crossings on the surface of a sweep and the cost of contouring it.
// Samples a rough sweep: a few of the placements, on the grid of the run or on a coarser one.
// In:    the sampler input of the run. Out: estimated crossings and probes.
// Cost:  sampling within RoughLimits, plus the cost of probe_trial.h. The limits of RoughLimits are
//        counts, not times.
// Method: the rough sweep has nearly the same surface and creases as the sweep. It only misses the
//        vibration of the motion between its placements. In cells r times as large, a surface has
//        r * r times fewer crossings; an edge through a thin wall still has two.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "pipeline/probe_trial.h"
#include "pipeline/sampling_cost.h"
#include "swept/compute.h"

namespace swept {

/// Approximate limits of a rough sweep.
struct RoughLimits {
  double faces = 1.5e6;  ///< faces of the body times placements
  /// Raw crossings: all of them, not only the first from each end of an edge.
  double crossings = 1e7;
  double stripes = 1.5e7;  ///< faces of the body times the distance (cells) that the body travels
};
/// Returns limits that are a small fraction of the run's own figures, but no less than the
/// defaults.
RoughLimits limitsFor(const SamplingCost& sampling, double copies);

struct RoughSurface {
  double crossings = 0;
  ProbeCost probes;  ///< cost of the probes that contouring casts
};

/// Returns the estimate. `known`: the marked edges of the whole motion on the grid of the run, if
/// they exist; the function consumes them.
RoughSurface roughSurface(const SamplerInput& whole, const RoughLimits& limits,
                          std::optional<MarkedEdges> known, ComponentMethod components,
                          RunContext& run);

}  // namespace swept
