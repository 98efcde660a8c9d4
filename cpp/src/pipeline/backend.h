// Chooses the sampler of a run and handles failures of the GPU.
//
// Backend cpu: never touches GL.
// Backend gpu: throws Error(DeviceUnavailable) or Error(DeviceLost) with the reason on failure.
// Backend auto: uses the GPU only if the run is long, and if a real GPU (no software rasteriser)
//        passes the self-test and, by short samples of this run on both, is expected to beat the
//        CPU. Else the CPU samples, and one note says which step failed.
// Promise: CPU and GPU give the same marks, so the result does not depend on the choice.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampled_surface.h"

namespace swept {

/// CPU seconds. If the estimated time of a run is shorter, `auto` does not look for a GPU.
constexpr double kMinAutoSeconds = 3;
/// Samples with the wanted backend. `cpuSeconds` is the estimated time of the whole run on the CPU.
/// Only one run per process uses the GPU at a time.
SampledSurface sampleSurface(const SamplerInput& input, Backend wanted, double cpuSeconds,
                             const FindSigns& findSigns, RunContext& run);

}  // namespace swept
