// How large the surface of a sweep is, and what contouring it takes: from a sweep along a few of
// its placements, on the grid of the run.
// In:    the run's sampler input. Out: crossings and CPU seconds, guesses for estimates.
// Cost:  sampling of at most 192 placements, or of all where they are at most 384 with 12 million
//        triangles together, and contouring of about kRoughCrossings crossings.
// The chords between the placements make much the same surface, with the same creases and crowds,
// but for what trembles between them. Some of the probes that contouring it casts are cast at the
// whole motion, and timed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "sampling/sampler.h"
#include "swept/compute.h"

namespace swept {

/// CPU seconds, and counts.
struct SamplingCost {
  double seconds = 0, crossings = 0, elements = 0;

  void add(const SamplingCost& other, double times) {
    seconds += times * other.seconds;
    crossings += times * other.crossings;
    elements += times * other.elements;
  }
};

/// Samples on the calling thread, and adds what that takes.
MarkedEdges sampleCounted(SamplerInput input, SamplingCost& cost, RunContext& run);

struct RoughSurface {
  double crossings = 0;
  double probeSeconds = 0;  ///< CPU seconds of probes for each crossing; 0 where not asked for
  std::optional<SamplingCost> all;  ///< of sampling, where it was along all placements
};

RoughSurface roughSurface(const SamplerInput& whole, ComponentMethod components, bool probes,
                          RunContext& run);

}  // namespace swept
