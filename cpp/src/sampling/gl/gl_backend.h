// One sampling run on the GPU, from opening the device to verified marks and winners.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "sampling/gl/gl_passes.h"
#include "sampling/sampled_surface.h"

namespace swept::gl {

struct GlSetup {
  std::shared_ptr<GlLoader> loader;  ///< null: the system's EGL library
  DeviceWish wish;
  GlSettings settings;
  int verifiedElements = 512, verifiedEdges = 512;
  double assumedProbe = 0;  ///< testing hook: ratio of GPU to CPU seconds; 0: measure it by a probe
};

/// Opens a device and tests it. Throws Error(DeviceUnavailable) or Error(DeviceLost).
std::shared_ptr<GlDevice> openTested(const GlSetup& setup, RunContext& run);

/// Runs the sampler on the GPU. With mustBeFaster, throws Error(DeviceUnavailable) if a probe of
/// about 0.1 s finds the CPU faster. The ratio is remembered per device.
SampledSurface sampleOnGpu(const SamplerInput& input, const GlSetup& setup, bool mustBeFaster,
                           const FindSigns& findSigns, RunContext& run);

/// Returns the settings from the environment variables in docs/gpu.md, else the system's defaults.
/// Nothing else in this folder reads these variables.
GlSetup currentSetup();
/// Testing hook: currentSetup() returns `setup` from now on; null restores the normal behaviour.
void setSetupForTests(const GlSetup* setup);

}  // namespace swept::gl
