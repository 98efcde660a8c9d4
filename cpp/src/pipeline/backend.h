// Which sampler a run uses, and what happens when the GPU fails it.
//
// cpu: never touches GL. gpu: demanded; Error(DeviceUnavailable) or Error(DeviceLost) with the
// reason. auto: the CPU, unless the run is long and a real GPU (no software rasteriser) passes the
// self-test and was faster than the CPU on a probe; whatever fails, the CPU takes over and one note
// says which step failed. Both samplers give the same marks, so the result does not depend on it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampled_surface.h"

namespace swept {

/// cpuSeconds: estimate of the whole run on the CPU; below kMinAutoSeconds auto does not look for
/// a GPU. GPU runs of one process take turns.
constexpr double kMinAutoSeconds = 3;
SampledSurface sampleSurface(const SamplerInput& input, Backend wanted, double cpuSeconds,
                             const FindSigns& findSigns, RunContext& run);

}  // namespace swept
