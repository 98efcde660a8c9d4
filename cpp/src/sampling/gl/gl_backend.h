// One sampling run on the GPU, from opening the device to verified marks and winners.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "sampling/gl/gl_passes.h"
#include "sampling/sampled_surface.h"

namespace swept::gl {

struct GlSetup {
  std::shared_ptr<GlLoader> loader;  ///< null: this system's
  DeviceWish wish;
  GlSettings settings;
  int verifiedElements = 512, verifiedEdges = 512;
  double assumedProbe =
      0;  ///< testing hook: GPU seconds / CPU seconds instead of a probe; 0: probe
};

/// Opens and self-tests a device. Throws Error(DeviceUnavailable) / Error(DeviceLost).
std::shared_ptr<GlDevice> openTested(const GlSetup& setup, RunContext& run);

/// mustBeFaster: throws Error(DeviceUnavailable) if a probe of about 0.1 s finds the CPU faster;
/// the answer is remembered per device.
SampledSurface sampleOnGpu(const SamplerInput& input, const GlSetup& setup, bool mustBeFaster,
                           const FindSigns& findSigns, RunContext& run);

/// What the variables of the environment in docs/gpu.md ask for; else the system's. No other part
/// of this room reads them.
GlSetup currentSetup();
/// Testing hook: what currentSetup() says from now on; null: the above.
void setSetupForTests(const GlSetup* setup);

}  // namespace swept::gl
