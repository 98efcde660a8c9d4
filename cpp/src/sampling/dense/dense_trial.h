// Estimates time and memory of the dense sampler by running it on a part of the body.
// In: sampler input that suits the dense sampler; number of crossings of the envelope.
// Out: CPU seconds and bytes for the whole body.
// Cost: builds the tree of placements and prepares the tests for the whole body. Finds the
// candidates for some patches. They have about a quarter of the faces, but at least 5,200 (or all)
// and at most 15,600. Samples the middle of each patch and searches this middle for leaks. Uses one
// thread.
// A vertex passes the placements that it found best on to its neighbours. At the rim of a patch
// some neighbours are missing, so there are fewer candidates than in a run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampler.h"

namespace swept::dense {

struct DenseCost {
  double seconds = 0, bytes = 0;
  double pairs = 0;  ///< number of candidate (face, placement) pairs
};

DenseCost tryDense(const SamplerInput& input, double surface, RunContext& run);

}  // namespace swept::dense
