// Measures the cost of sampling a part of a motion, for estimates.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampler.h"

namespace swept {

/// CPU seconds, and numbers of crossings and swept elements.
struct SamplingCost {
  double seconds = 0, crossings = 0, elements = 0;

  void add(const SamplingCost& other, double times) {
    seconds += times * other.seconds;
    crossings += times * other.crossings;
    elements += times * other.elements;
  }
};

/// Samples on the calling thread and adds the cost to `cost`.
MarkedEdges sampleCounted(SamplerInput input, SamplingCost& cost, RunContext& run);

}  // namespace swept
