// Does one sampling run on the GPU, from opening the device to verified marks and winners
// (EdgeWinner, gl_passes.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>

#include "sampling/gl/gl_passes.h"
#include "sampling/sampled_surface.h"

namespace swept::gl {

struct GlSetup {
  std::shared_ptr<GlLoader> loader;  ///< null: the system's EGL library
  DeviceWish wish;
  GlSettings settings;
  int verifiedElements = 512, verifiedEdges = 512;  ///< numbers of random checks (gl_verify.h)
  double assumedRatio = 0;  ///< testing hook: ratio of GPU to CPU seconds; 0: measure it
};

/// Opens a device and tests it. Throws Error(DeviceUnavailable) or Error(DeviceLost).
std::shared_ptr<GlDevice> openTested(const GlSetup& setup, RunContext& run);

/// Returns the seconds that the CPU is expected to take for sampling. The input has clusters.
using CpuSeconds = std::function<double(const SamplerInput&)>;

/// Runs the sampler on the GPU. If `cpuSeconds` is given, short samples of this input are timed. If
/// the device is then expected to take at least as long as the CPU, throws
/// Error(DeviceUnavailable). cpuSeconds() is called only if there is a device.
SampledSurface sampleOnGpu(const SamplerInput& input, const GlSetup& setup,
                           const CpuSeconds& cpuSeconds, const FindSigns& findSigns,
                           RunContext& run);

/// Returns the settings from the environment variables in docs/gpu.md, and defaults for the others.
/// Nothing else in this folder reads these variables.
GlSetup currentSetup();
/// Testing hook: currentSetup() returns `setup` from now on; null restores the normal behaviour.
void setSetupForTests(const GlSetup* setup);

}  // namespace swept::gl
