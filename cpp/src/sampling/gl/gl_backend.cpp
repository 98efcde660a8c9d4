// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_backend.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <optional>

#include "base/number_text.h"
#include "sampling/culling/swept_elements.h"
#include "sampling/gl/gl_sampler.h"
#include "sampling/gl/gl_verify.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

std::mutex setupMutex;
std::optional<GlSetup> testSetup;

void requireFaster(GlSampler& sampler, const GlSetup& setup, const SamplerInput& input,
                   const CpuSeconds& cpuSeconds, RunContext& run) {
  const double gpu = sampler.expectedSeconds(run), cpu = cpuSeconds(input);
  const double ratio = setup.assumedRatio > 0 ? setup.assumedRatio : gpu / cpu;
  if (ratio < 1) return;
  throw Error(Status::DeviceUnavailable, "DeviceSlower",
              textOf(2, sampler.device(), " would take ", ratio,
                     " times as long as the CPU, as a sample of this run shows"));
}

}  // namespace

void setSetupForTests(const GlSetup* setup) {
  const std::lock_guard lock(setupMutex);
  testSetup = setup ? std::optional<GlSetup>(*setup) : std::nullopt;
}

GlSetup currentSetup() {
  const std::lock_guard lock(setupMutex);
  if (testSetup) return *testSetup;
  const auto variable = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string(text != nullptr ? text : "");
  };
  GlSetup setup;
  setup.wish.name = variable("SWEPT_GL_DEVICE");
  const std::string library = variable("SWEPT_EGL_LIBRARY");
  if (!library.empty()) setup.loader = systemLoader(library);
  const std::uint64_t megabytes =
      std::strtoull(variable("SWEPT_GL_MEMORY_MB").c_str(), nullptr, 10);
  if (megabytes > 0) setup.settings.budgetBytes = megabytes << 20;
  return setup;
}

std::shared_ptr<GlDevice> openTested(const GlSetup& setup, RunContext& run) {
  const std::shared_ptr<GlLoader> loader = setup.loader ? setup.loader : systemLoader();
  auto device = std::make_shared<GlDevice>(GlContext::open(loader, setup.wish));
  selfTest(device, setup.settings.fenceTimeoutSeconds, run);
  return device;
}

SampledSurface sampleOnGpu(const SamplerInput& whole, const GlSetup& setup,
                           const CpuSeconds& cpuSeconds, const FindSigns& findSigns,
                           RunContext& run) {
  static std::mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  std::shared_ptr<GlDevice> device = openTested(setup, run);
  // The first call returns the device that was just tested. After a loss, a new device is opened
  // and tested.
  const auto next = [&] { return device ? std::move(device) : openTested(setup, run); };
  SamplerInput input = whole;
  FaceClusters own;  // for the device, for the trial on the CPU, and for the checks
  if (input.motion.continuous || cpuSeconds) input.clusters = &clustersOf(whole, own);
  GlSampler sampler(input, next, setup.settings);
  if (cpuSeconds) requireFaster(sampler, setup, input, cpuSeconds, run);
  SampledSurface out;
  out.backend = "gpu";
  out.marked = sampler.mark(run);
  verifyMarks(input, out.marked, sampler.device(), setup.verifiedElements);
  out.signs = findSigns(out.marked);
  verifySigns(input, out.marked, out.signs, sampler.device());
  sampler.resolve(out.marked, out.signs, run);
  verifyWinners(input, out.marked, out.signs, sampler.device(), setup.verifiedEdges);
  out.device = sampler.device();
  if (sampler.reopened() > 0) {
    out.notes.push_back({"DeviceReopened",
                         sampler.reopened(),
                         {},
                         "the connection to the GPU was lost once; part of the grid was sampled "
                         "again, and the result is the same"});
  }
  return out;
}

}  // namespace swept::gl
