// Estimates time and memory of the dense sampler by running it on a part of the body.
// In: sampler input that suits it. Out: CPU seconds and bytes of the whole. Cost: the tree over the
// placements, and candidates and samples of kTrialFaces faces, on one thread.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampler.h"

namespace swept::dense {

struct DenseCost {
  double seconds = 0, bytes = 0;
};

DenseCost tryDense(const SamplerInput& input, RunContext& run);

}  // namespace swept::dense
