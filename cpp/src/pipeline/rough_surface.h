// How large the surface of a sweep is, and what contouring it takes: from a sweep along a few of
// its placements, on the run's grid or one of larger cells.
// In:    the run's sampler input. Out: crossings, and probes of contouring: guesses for estimates.
// Cost:  sampling within RoughRoom, and that of probe_trial.h. Counted, not timed.
// The chords between the placements make much the same surface, with the same creases and crowds,
// but for what trembles between them. In cells r times as large, a surface has r * r times fewer
// crossings; thin walls still have two.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "pipeline/probe_trial.h"
#include "pipeline/sampling_cost.h"
#include "swept/compute.h"

namespace swept {

/// What a rough sweep may have, about.
struct RoughRoom {
  double faces = 1.5e6;    ///< of all placements together
  double crossings = 1e7;  ///< of all pieces, before the first on each edge are taken
};
/// A small part of what the run itself has, but no less than the above.
RoughRoom roomBeside(const SamplingCost& sampling, double copies);

struct RoughSurface {
  double crossings = 0;
  ProbeCost probes;  ///< of contouring
};

/// `known`: the whole motion as sampled on the run's grid, where that has been done; consumed.
RoughSurface roughSurface(const SamplerInput& whole, const RoughRoom& room,
                          std::optional<MarkedEdges> known, ComponentMethod components,
                          RunContext& run);

}  // namespace swept
