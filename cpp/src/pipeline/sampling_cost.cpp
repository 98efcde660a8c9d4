// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/sampling_cost.h"

#include "base/timer.h"

namespace swept {

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

}  // namespace swept
