// Estimates time and memory of the dense sampler by running it on a part of the body.
// In: sampler input that suits it; crossings of the envelope. Out: CPU seconds and bytes of the
// whole. Cost: the tree over the placements, tests of the body, and of some patches of the body, a
// quarter of it or less, their candidates; the middle of each patch is sampled and searched for
// leaks. On one thread.
// Winners spread from vertex to vertex, so that the rim of a patch has fewer than in a run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampler.h"

namespace swept::dense {

struct DenseCost {
  double seconds = 0, bytes = 0;
  double pairs = 0;  ///< candidates
};

DenseCost tryDense(const SamplerInput& input, double surface, RunContext& run);

}  // namespace swept::dense
