// Chooses the sampler of a run and handles failures of the GPU.
//
// Backend cpu: never touches GL.
// Backend gpu: throws Error(DeviceUnavailable) or Error(DeviceLost) with the reason on failure.
// Backend auto: uses the GPU only if the run is long, and if a real GPU (no software rasteriser)
// passes the self-test. Short samples of this run must also predict that the GPU is faster than the
// CPU. Otherwise the CPU samples, and a note says which of these conditions failed.
// cpu and auto use the dense sampler (sampling/dense/) if it suits the input.
// Promise: CPU and GPU give the same contributing edges, so the result does not depend on the
// choice.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sampling/sampled_surface.h"

namespace swept {

/// If the estimated CPU time (s) of a run is shorter, `auto` does not look for a GPU.
constexpr double kMinAutoSeconds = 3;
/// Samples with the wanted backend. `cpuSeconds` is the estimated time of the whole run on the CPU.
/// Only one run per process uses the GPU at a time.
SampledSurface sampleSurface(const SamplerInput& input, Backend wanted, double cpuSeconds,
                             const FindSigns& findSigns, RunContext& run);

}  // namespace swept
