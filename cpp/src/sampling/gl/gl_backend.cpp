// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_backend.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>

#include "base/number_text.h"
#include "base/timer.h"
#include "sampling/gl/gl_sampler.h"
#include "sampling/gl/gl_verify.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

std::mutex setupMutex;
std::optional<GlSetup> testSetup;

/// A bumpy disc that turns and moves: enough work to show whether GPU or CPU is faster.
struct Probe {
  TriMesh body;
  Motion motion;
  GridPlan grid;

  Probe() {
    constexpr int kAround = 192, kRings = 48;
    for (int ring = 0; ring <= kRings; ++ring) {
      for (int n = 0; n < kAround; ++n) {
        const double polar = M_PI * (ring + 0.5) / (kRings + 1), turn = 2 * M_PI * n / kAround;
        const double r = 30 + 2 * std::sin(9 * turn) * std::sin(polar);
        body.vertices.emplace_back(r * std::sin(polar) * std::cos(turn),
                                   r * std::sin(polar) * std::sin(turn), 0.4 * r * std::cos(polar));
      }
    }
    for (int ring = 0; ring < kRings; ++ring) {
      for (int n = 0; n < kAround; ++n) {
        const std::int32_t a = ring * kAround + n, b = ring * kAround + (n + 1) % kAround;
        body.triangles.push_back({a, a + kAround, b});
        body.triangles.push_back({b, a + kAround, b + kAround});
      }
    }
    for (int step = 0; step < 24; ++step) {
      Placement p;
      p.rotation = Eigen::AngleAxisd(0.05 * step, Eigen::Vector3d(2, 1, 2) / 3).toRotationMatrix();
      p.translation = Eigen::Vector3d(64, 64, 64 + 0.5 * step);
      motion.placements.push_back(p);
    }
    grid.points = {128, 128, 144};
  }
};

/// Returns GPU seconds divided by CPU seconds.
double probe(const std::shared_ptr<GlDevice>& device, const GlSetup& setup, RunContext& run) {
  const Probe p;
  const BodyTopology topology = buildTopology(p.body);
  const SamplerInput input{p.body, topology, p.motion, p.grid, true, false};
  GlSampler sampler(
      input, [&] { return device; }, setup.settings);
  const auto onGpu = [&] {
    MarkedEdges marked = sampler.mark(run);
    sampler.resolve(marked, findOutside(marked, p.grid, run), run);
  };
  onGpu();  // drivers finish compiling their shaders at first use
  Timer timer;
  onGpu();
  const double gpu = timer.lap();
  findOutside(sampleCpu(input, run), p.grid, run);
  return gpu / timer.lap();
}

void requireFaster(const std::shared_ptr<GlDevice>& device, const GlSetup& setup, RunContext& run) {
  static std::map<std::string, double> known;  // only one run at a time gets here
  const std::string& name = device->context->device();
  double ratio = setup.assumedProbe;
  if (!(ratio > 0)) {
    auto found = known.find(name);
    if (found == known.end()) found = known.emplace(name, probe(device, setup, run)).first;
    ratio = found->second;
  }
  if (ratio < 1) return;
  throw Error(Status::DeviceUnavailable, "DeviceSlower",
              textOf(3, name, " took ", ratio, " times as long as the CPU in a short test"));
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

SampledSurface sampleOnGpu(const SamplerInput& input, const GlSetup& setup, bool mustBeFaster,
                           const FindSigns& findSigns, RunContext& run) {
  static std::mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  std::shared_ptr<GlDevice> device = openTested(setup, run);
  if (mustBeFaster) requireFaster(device, setup, run);
  // The first call gives the device that was just tested. After a loss, a new one is opened and
  // tested.
  const auto next = [&] { return device ? std::move(device) : openTested(setup, run); };
  GlSampler sampler(input, next, setup.settings);
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
