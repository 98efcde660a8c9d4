// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/backend.h"

#include <optional>
#include <utility>

#include "base/threads.h"
#include "pipeline/sampling_trial.h"
#include "sampling/cpu/deep_inside.h"
#include "sampling/dense/dense_sampler.h"

#ifdef SWEPT_WITH_GL
#include "sampling/gl/gl_backend.h"
#include "sampling/gl/gl_context.h"
#endif

namespace swept {
namespace {

SampledSurface sampleOnCpu(const SamplerInput& input, const FindSigns& findSigns, RunContext& run) {
  SampledSurface out;
  SamplerInput inputWithMap = input;
  const std::optional<InsideMap> inside = findDeepInside(input, run);
  if (inside) inputWithMap.inside = &*inside;
  out.marked = sampleCpu(inputWithMap, run);
  out.signs = findSigns(out.marked);
  return out;
}

}  // namespace

SampledSurface sampleSurface(const SamplerInput& input, Backend wanted, double cpuSeconds,
                             const FindSigns& findSigns, RunContext& run) {
  // If the dense sampler suits the input, it samples only some copies of the body. On the CPU this
  // takes less time than sampling all copies takes on any GPU.
  if (wanted != Backend::Gpu) {
    if (auto dense = dense::sampleDense(input, {}, run)) {
      SampledSurface out;
      out.marked = std::move(dense->marked);
      out.signs = findSigns(out.marked);
      out.notes = std::move(dense->notes);
      return out;
    }
  }
#ifdef SWEPT_WITH_GL
  if (wanted == Backend::Gpu) {
    return gl::sampleOnGpu(input, gl::currentSetup(), {}, findSigns, run);
  }
  if (wanted == Backend::Auto && cpuSeconds >= kMinAutoSeconds) {
    std::string reason;
    try {
      gl::GlSetup setup = gl::currentSetup();
      setup.wish.hardwareOnly = true;
      const auto sampling = [&](const SamplerInput& trialInput) {
        return cpuSamplingSeconds(trialInput, threadsOf(run), run);
      };
      return gl::sampleOnGpu(input, setup, sampling, findSigns, run);
    } catch (const Error& error) {
      if (error.status() != Status::DeviceUnavailable && error.status() != Status::DeviceLost) {
        throw;
      }
      // Without the advice, which is only for users who chose the GPU.
      reason = error.what();
      reason = reason.substr(0, reason.find(gl::kDeviceAdvice));
    }
    SampledSurface out = sampleOnCpu(input, findSigns, run);
    out.notes.push_back({"CpuSampler", 1, {}, "the CPU did the sampling: " + reason});
    return out;
  }
#else
  (void)cpuSeconds;
  if (wanted == Backend::Gpu) {
    throw Error(Status::DeviceUnavailable, "DeviceUnavailable",
                "no GPU can be used, because the program was built without the GPU sampler; set "
                "the backend to cpu or auto");
  }
#endif
  return sampleOnCpu(input, findSigns, run);
}

}  // namespace swept
