// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/trial_steps.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

#include "base/threads.h"
#include "pipeline/rough_surface.h"
#include "pipeline/sampling_trial.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/dense/dense_sampler.h"
#include "sampling/dense/dense_trial.h"

namespace swept {
namespace {

/// CPU seconds: of a triangle that is checked and gets its topology, of a pose that is read and
/// planned, and of a crossing that becomes surface.
constexpr double kBodySeconds = 1.5e-6, kPoseSeconds = 1.5e-6, kCrossingSeconds = 3e-6;
}  // namespace

Estimate estimateByTrial(const Estimate& estimate, const Prepared& p, const BodyTopology& topology,
                         const BodyCost& body, const Options& options, RunContext& run) {
  if (options.offset > 0 || options.conservative) return estimate;
  const FaceClusters clusters = buildClusters(p.body.mesh, topology);
  const SamplerInput input{p.body.mesh,       topology,  p.motion, p.grid,  options.cull,
                           p.body.orientable, &clusters, nullptr,  nullptr, !options.keepCavities};
  const bool dense =
      options.backend != Backend::Gpu &&
      dense::suits(p.body.mesh, p.motion, p.grid.cell, options.cull, p.body.orientable, {});
  tbb::task_arena alone(1);
  const RoughSurface surface =
      alone.execute([&] { return roughSurface(input, options.components, !dense, run); });
  const double byBox = static_cast<double>(estimate.triangles) / 2;
  const auto bytesForAll = static_cast<std::uint64_t>(
      std::max(0.0, static_cast<double>(estimate.memoryBytes) +
                        (surface.crossings - byBox) * bytesOfCrossing(options)));
  const double threads = threadsOf(run);
  const double before = std::max(body.seconds / threads,
                                 static_cast<double>(p.body.mesh.triangles.size()) * kBodySeconds) +
                        static_cast<double>(p.givenPoses) * kPoseSeconds;
  const double contouring = surface.crossings * (kCrossingSeconds + surface.probeSeconds);
  Estimate better = estimate;
  better.triangles = static_cast<std::int64_t>(2 * surface.crossings);
  if (dense) {
    const auto cost = alone.execute([&] { return dense::tryDense(input, run); });
    better.seconds = before + (cost.seconds + contouring) / threads;
    better.memoryBytes = std::max(
        body.bytes, bytesForAll - denseBytes(p.body.mesh) + static_cast<std::uint64_t>(cost.bytes));
    return better;
  }
  const auto [seconds, bytes] = alone.execute([&] {
    const SamplingTrial trial(input, run);
    const SamplingCost sampling = surface.all ? *surface.all : trial.whole();
    return std::pair(sampling.seconds + trial.insideSeconds(),
                     trial.bytesOf(sampling, surface.crossings, threads));
  });
  better.seconds = before + (seconds + contouring) / threads;
  // What the check of the body has taken is free again when the motion is sampled.
  better.memoryBytes = std::max(body.bytes, bytesForAll + static_cast<std::uint64_t>(bytes));
  return better;
}

}  // namespace swept
