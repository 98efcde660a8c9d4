// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/trial_steps.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/threads.h"
#include "pipeline/rough_surface.h"
#include "pipeline/sampling_trial.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/dense/dense_sampler.h"
#include "sampling/dense/dense_trial.h"

namespace swept {
namespace {

/// CPU seconds per triangle (check and topology), per pose (reading and planning) and per crossing
/// of the surface (contouring).
constexpr double kBodySeconds = 1.5e-6, kPoseSeconds = 1.5e-6, kCrossingSeconds = 3e-6;

/// Returns the seconds that simplification takes. The finer the tolerance, the more often the
/// distance from the surface is measured. On machined parts and scans with tolerances of 0.05 to 2
/// cells, it took 2.3 to 34 microseconds of CPU time per triangle. A fifth of it is not parallel.
double simplifySeconds(double triangles, double cell, const Options& options, double threads) {
  if (!(options.tolerance > 0)) return 0;
  const double cells = std::clamp(options.tolerance / cell, 0.02, 10.0);
  return triangles * 2e-6 * (1 + std::pow(cells, -0.78)) * (0.2 + 0.8 / threads);
}

}  // namespace

Estimate estimateByTrial(const Estimate& estimate, const Prepared& p, const BodyTopology& topology,
                         const BodyCost& body, const Options& options, RunContext& run) {
  Estimate better = estimate;
  if (options.offset > 0 || options.conservative) {
    better.seconds += simplifySeconds(static_cast<double>(estimate.triangles), p.grid.cell, options,
                                      threadsOf(run));
    return better;
  }
  const FaceClusters clusters = buildClusters(p.body.mesh, topology);
  const SamplerInput input{p.body.mesh,       topology,  p.motion, p.grid,  options.cull,
                           p.body.orientable, &clusters, nullptr,  nullptr, !options.keepCavities};
  const bool dense =
      options.backend != Backend::Gpu &&
      dense::suits(p.body.mesh, p.motion, p.grid.cell, options.cull, p.body.orientable, {});
  const double faces = static_cast<double>(p.body.mesh.triangles.size()), threads = threadsOf(run);
  double seconds = std::max(body.seconds / threads, faces * kBodySeconds) +
                   static_cast<double>(p.givenPoses) * kPoseSeconds;
  double bytes = 0;  // memory of sampling
  RoughSurface surface;
  const auto runTrials = [&] {
    if (dense) {
      surface = roughSurface(input, {}, std::nullopt, options.components, run);
      const dense::DenseCost cost = dense::tryDense(input, surface.crossings, run);
      seconds += cost.seconds / threads;
      // The dense sampler frees its memory before the mesh is made, so only the larger of the two
      // amounts counts.
      bytes = std::max(0.0, cost.bytes - surface.crossings * bytesOfCrossing(options)) -
              static_cast<double>(denseBytes(p.body.mesh));
      return;
    }
    const SamplingTrial trial(input, run);
    SamplingTrial::Whole whole = trial.whole();
    const double copies = faces * static_cast<double>(p.motion.placements.size());
    surface = roughSurface(input, limitsFor(whole.cost, copies), std::move(whole.marked),
                           options.components, run);
    seconds += (whole.cost.seconds + trial.insideSeconds()) / threads;
    bytes = trial.bytesOf(whole.cost, surface.crossings, threads);
  };
  tbb::task_arena(1).execute(runTrials);
  better.triangles = static_cast<std::int64_t>(2 * surface.crossings);
  better.seconds = seconds +
                   (surface.crossings * kCrossingSeconds + surface.probes.seconds) / threads +
                   simplifySeconds(2 * surface.crossings, p.grid.cell, options, threads);
  // The memory for checking the body is free again when sampling begins.
  const double byBox = static_cast<double>(estimate.triangles) / 2;
  const double otherBytes = static_cast<double>(estimate.memoryBytes) +
                            (surface.crossings - byBox) * bytesOfCrossing(options);
  better.memoryBytes =
      std::max(body.bytes, static_cast<std::uint64_t>(std::max(0.0, otherBytes + bytes)));
  return better;
}

}  // namespace swept
