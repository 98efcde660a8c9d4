// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/trial_steps.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/threads.h"
#include "base/timer.h"
#include "pipeline/rough_surface.h"
#include "sampling/cpu/deep_inside.h"
#include "sampling/cpu/work_items.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/culling/step_blocks.h"
#include "sampling/dense/dense_sampler.h"
#include "sampling/dense/dense_trial.h"
#include "sampling/sampler.h"

namespace swept {
namespace {

/// Copies of triangles that are sampled, and placements.
constexpr double kTrialCopies = 6e6;
constexpr std::size_t kFewest = 8, kMost = 192;
/// More placements of bodies of few triangles: long windows show what pieces far apart in time
/// hide.
constexpr double kCheapCopies = 4e5;
constexpr std::size_t kMostCheap = 1536;
/// Places of a continuous motion where two trials begin, one of them of twice as many steps: what a
/// step takes is their difference, without what sampling takes for the grid and a work item. Bodies
/// of many triangles get fewer.
constexpr std::size_t kMostWindows = 8, kFewestWindows = 2;
/// Of what the longer trial takes in the mean, a step takes this at least.
constexpr double kLeastShare = 0.2;

/// CPU seconds: of a triangle that is checked and gets its topology, of a pose that is read and
/// planned, and of a crossing that becomes surface.
constexpr double kBodySeconds = 1.5e-6, kPoseSeconds = 1.5e-6, kCrossingSeconds = 3e-6;
/// Bytes of a crossing that is sorted, with its share of what sorting needs, and of an element.
constexpr double kSortedBytes = 16, kElementBytes = 12;

using Cost = SamplingCost;

class Trials {
 public:
  Trials(const SamplerInput& whole, RunContext& run) : whole_(whole), run_(run) {
    const double start = threadSeconds();
    SamplerInput counted = input(whole.motion);
    counted.crossings = &insideCrossings_;
    inside_ = findDeepInside(counted, run);
    insideSeconds_ = threadSeconds() - start;
  }

  /// Of finding out what lies deep inside the whole motion.
  double insideSeconds() const { return insideSeconds_; }

  /// Of what is held while the whole motion is sampled; before that, of what the map is made of.
  double bytesOf(const Cost& sampling, double surface, double threads) const {
    const bool thins = sampling.crossings > kMotionItems * kMinThinRecords &&
                       placementsOfItem(input(whole_.motion)) >= kMinThinPlacements;
    const double kept =
        thins ? 2 * threads * kMinThinRecords + kMotionItems * surface : sampling.crossings;
    const double map = inside_ ? static_cast<double>(inside_->bytes()) : 0;
    return std::max(static_cast<double>(insideCrossings_) * kSortedBytes,
                    kept * kSortedBytes + sampling.elements * kElementBytes + map);
  }

  /// Of the whole motion.
  Cost whole() const {
    const Motion& motion = whole_.motion;
    const std::size_t count = motion.continuous ? motion.steps() : motion.placements.size();
    const double faces = static_cast<double>(whole_.body.triangles.size());
    const std::size_t wanted =
        std::max(std::clamp(static_cast<std::size_t>(kTrialCopies / faces), kFewest, kMost),
                 std::min(static_cast<std::size_t>(kCheapCopies / faces), kMostCheap));
    if (count <= 2 * wanted) return of(motion);
    return motion.continuous ? byWindows(count, wanted) : bySomeCopies(count, wanted);
  }

 private:
  /// Of a union of copies: some of them at once, less what sampling takes for the grid alone.
  Cost bySomeCopies(std::size_t count, std::size_t wanted) const {
    Motion some;
    for (std::size_t n = 0; n < wanted; ++n)
      some.placements.push_back(whole_.motion.placements[(2 * n + 1) * count / (2 * wanted)]);
    const Cost all = of(some);
    Motion single;
    single.placements.push_back(whole_.motion.placements[count / 2]);
    const Cost one = of(single);
    Cost sum, least;
    sum.add(all, times(count, wanted - 1));
    sum.add(one, -times(count, wanted - 1));
    least.add(all, kLeastShare * times(count, wanted));
    return largerOf(sum, least);
  }

  /// Windows are sampled as parts of the run's work items: what is decided for blocks and groups of
  /// placements at once is decided so here.
  Cost byWindows(std::size_t count, std::size_t wanted) const {
    const std::size_t item = placementsOfItem(input(whole_.motion));
    const std::size_t windows = std::clamp(wanted / 3, kFewestWindows, kMostWindows);
    const std::size_t steps =
        std::clamp<std::size_t>(wanted / (3 * windows), 1, std::max<std::size_t>(item / 2, 1));
    PlaceGroups::Trial some;
    for (std::size_t w = 0; w < windows; ++w) {
      const std::size_t first = (2 * w + 1) * (count - 2 * steps) / (2 * windows);
      some.only.push_back({first, first + 2 * steps});
    }
    const double start = threadSeconds();
    const PlaceGroups groups(input(whole_.motion), *whole_.clusters, run_, &some);
    Cost sum, least, begun;
    const double grouping = threadSeconds() - start + some.secondsOfOthers;
    const Cost none = at({0, 0}, groups);
    for (const PlacementRange& both : some.only) {
      const Cost one = at({both.begin, both.begin + steps}, groups), two = at(both, groups);
      sum.add(two, times(count, windows * steps));
      sum.add(one, -times(count, windows * steps));
      least.add(two, kLeastShare * times(count, 2 * windows * steps));
      if (2 * steps > item) continue;  // two items
      begun.seconds += (2 * one.seconds - two.seconds - none.seconds) * times(count, item) /
                       static_cast<double>(windows);
    }
    sum.seconds += std::max(begun.seconds, 0.0);
    sum = largerOf(sum, least);
    sum.seconds += grouping;
    return sum;
  }

  static Cost largerOf(const Cost& a, const Cost& b) {
    return {std::max(a.seconds, b.seconds), std::max(a.crossings, b.crossings),
            std::max(a.elements, b.elements)};
  }

  static double times(std::size_t all, std::size_t part) {
    return static_cast<double>(all) / static_cast<double>(part);
  }

  SamplerInput input(const Motion& motion) const {
    return {whole_.body,
            whole_.topology,
            motion,
            whole_.grid,
            whole_.cull,
            whole_.orientable,
            whole_.clusters,
            nullptr,
            nullptr,
            whole_.fillsHollows,
            inside_ ? &*inside_ : nullptr};
  }

  Cost at(const PlacementRange& only, const PlaceGroups& groups) const {
    SamplerInput part = input(whole_.motion);
    part.only = only;
    part.groups = &groups;
    return of(part);
  }

  Cost of(const Motion& motion) const { return of(input(motion)); }

  Cost of(const SamplerInput& part) const {
    Cost cost;
    sampleCounted(part, cost, run_);
    return cost;
  }

  const SamplerInput& whole_;
  RunContext& run_;
  std::optional<InsideMap> inside_;
  double insideSeconds_ = 0;
  std::uint64_t insideCrossings_ = 0;
};

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
    const Trials trials(input, run);
    const Cost sampling = surface.all ? *surface.all : trials.whole();
    return std::pair(sampling.seconds + trials.insideSeconds(),
                     trials.bytesOf(sampling, surface.crossings, threads));
  });
  better.seconds = before + (seconds + contouring) / threads;
  // What the check of the body has taken is free again when the motion is sampled.
  better.memoryBytes = std::max(body.bytes, bytesForAll + static_cast<std::uint64_t>(bytes));
  return better;
}

}  // namespace swept
