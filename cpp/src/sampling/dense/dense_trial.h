// Estimates time and memory of the dense sampler by running it on a part of the body.
// In: sampler input that suits the dense sampler; number of crossings of the envelope.
// Out: CPU seconds and bytes for the whole body.
// Cost: builds the tree over the placements and the tests of the body. For some patches of the
//        body, a quarter of it or less, finds the candidates. Samples the middle of each patch and
//        searches it for leaks. Uses one thread.
// Winners spread from vertex to vertex, so the rim of a patch has fewer candidates than in a run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampler.h"

namespace swept::dense {

struct DenseCost {
  double seconds = 0, bytes = 0;
  double pairs = 0;  ///< number of candidates
};

DenseCost tryDense(const SamplerInput& input, double surface, RunContext& run);

}  // namespace swept::dense
