// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/sampling_trial.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "base/timer.h"
#include "sampling/cpu/deep_inside.h"
#include "sampling/cpu/work_items.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/culling/step_blocks.h"

namespace swept {
namespace {

/// Work of the trial, in copies of triangles. A crossing counts as kCrossingWork copies.
constexpr double kTrialWork = 2.4e6, kCrossingWork = 0.25;
/// Bounds of the number of sampled steps. kMinCopies: lower bound for a motion without
/// interpolation, in copies of the body. For bodies with few triangles, the upper bound is
/// kCheapCopies divided by the number of faces, but at most kMaxCheapPlacements. A high bound gives
/// long windows (see kMaxWindows), in which parts of the motion that are far apart in time can hide
/// each other.
constexpr std::size_t kMinPlacements = 24, kMinCopies = 8, kMaxPlacements = 192,
                      kMaxCheapPlacements = 1536;
constexpr double kCheapCopies = 4e5;
/// Number of windows of the motion that are sampled. Each is sampled with two lengths, one twice
/// the other. Bodies with many triangles get fewer windows.
constexpr std::size_t kMaxWindows = 32, kMinWindows = 2;
/// The crossings of a copy are estimated at this many placements, from about this many faces at
/// each.
constexpr std::size_t kSampledPlacements = 4, kSampledFaces = 4096;
/// A trial samples at least this many groups of kClustersTogether clusters each.
constexpr std::size_t kMinParts = 24;
/// A copy is assumed to cost at least this fraction of the mean cost of a sampled copy.
constexpr double kMinFraction = 0.2;
/// Bytes per crossing that is being sorted (including the buffer for sorting), and per element.
constexpr double kSortedBytes = 16, kElementBytes = 12;

double times(std::size_t all, std::size_t part) {
  return static_cast<double>(all) / static_cast<double>(part);
}

SamplingCost largerOf(const SamplingCost& a, const SamplingCost& b) {
  return {std::max(a.seconds, b.seconds), std::max(a.crossings, b.crossings),
          std::max(a.elements, b.elements)};
}

}  // namespace

SamplingTrial::SamplingTrial(const SamplerInput& whole, RunContext& run)
    : whole_(whole), run_(run) {
  const double start = threadSeconds();
  SamplerInput counted = input(whole.motion);
  counted.crossings = &insideCrossings_;
  inside_ = findDeepInside(counted, run);
  insideSeconds_ = threadSeconds() - start;
}

double SamplingTrial::bytesOf(const SamplingCost& sampling, double surface, double threads) const {
  const SamplerInput whole = input(whole_.motion);
  // A work item drops some crossings during sampling (thinning), but only if it has many placements
  // and crossings. A union of many placements has thousands of items, so each may have too few
  // crossings.
  const double items = static_cast<double>(workItems(whole).size());
  const bool thins =
      sampling.crossings > items * kMinThinRecords && placementsOfItem(whole) >= kMinThinPlacements;
  const double thinned = 2 * threads * kMinThinRecords + items * surface;
  const double kept = thins ? std::min(thinned, sampling.crossings) : sampling.crossings;
  const double map = inside_ ? static_cast<double>(inside_->bytes()) : 0;
  return std::max(static_cast<double>(insideCrossings_) * kSortedBytes,
                  kept * kSortedBytes + sampling.elements * kElementBytes + map);
}

SamplingTrial::Whole SamplingTrial::whole() const {
  const Motion& motion = whole_.motion;
  const std::size_t count = motion.continuous ? motion.steps() : motion.placements.size();
  const Parts parts = partsFor(count);
  if (parts.all && parts.clusterParts == 1) {
    Whole all;
    all.marked = sampleCounted(input(motion), all.cost, run_);
    return all;
  }
  if (!byClusters()) return {bySomeCopies(count, parts.steps), std::nullopt};
  return {parts.all ? byAllSteps(count, parts) : byWindows(count, parts), std::nullopt};
}

SamplingTrial::Parts SamplingTrial::partsFor(std::size_t count) const {
  const double faces = static_cast<double>(whole_.body.triangles.size());
  const std::size_t most = byClusters() ? mostClusterParts() : 1;
  const std::size_t sampledParts =
      std::clamp<std::size_t>(static_cast<std::size_t>(faces) / kSampledFaces, 1, most);
  // PlacementGroups would take time to build and change nothing here: the map of the inside hides
  // the same crossings without them. `none` has no groups, because `plain` has no map of the
  // inside.
  SamplerInput plain = input(whole_.motion);
  plain.inside = nullptr;
  const PlacementGroups none(plain, *whole_.clusters, run_);
  const std::size_t samples = std::clamp<std::size_t>(count, 1, kSampledPlacements);
  double crossings = 0;
  for (std::size_t n = 0; n < samples; ++n) {
    const std::size_t k = (2 * n + 1) * count / (2 * samples);
    crossings += at({k, k + 1}, sampledParts, &none).crossings / fractionShown(sampledParts);
  }
  const double step = faces + kCrossingWork * crossings / static_cast<double>(samples);
  const auto affordable = [&](std::size_t n) {
    return kTrialWork >= static_cast<double>(n) * step;
  };
  const auto partsOf = [&](std::size_t n) {
    const double parts = std::ceil(static_cast<double>(n) * step / kTrialWork);
    return std::min(static_cast<std::size_t>(std::max(1.0, parts)), most);
  };
  const std::size_t cap = std::clamp(static_cast<std::size_t>(kCheapCopies / faces), kMaxPlacements,
                                     kMaxCheapPlacements);
  if (count <= 2 * cap && affordable((count + 1) / 2)) return {count, 1, true};
  // Steps differ more from each other than clusters do. So sampling all steps with some clusters is
  // better than sampling some steps with all clusters.
  if (whole_.motion.continuous &&
      (count <= 2 * kMinPlacements || (count <= kMaxPlacements && affordable(count / most)))) {
    return {count, partsOf(count), true};
  }
  const std::size_t fewest = byClusters() ? kMinPlacements : std::min(kMinCopies, count);
  const std::size_t steps = std::clamp(static_cast<std::size_t>(kTrialWork / step), fewest, cap);
  return {steps, partsOf(steps), false};
}

/// Samples several copies of a union together, and one copy alone. The difference is the cost of
/// the copies without the fixed cost of the grid.
SamplingCost SamplingTrial::bySomeCopies(std::size_t count, std::size_t wanted) const {
  Motion some;
  for (std::size_t n = 0; n < wanted; ++n)
    some.placements.push_back(whole_.motion.placements[(2 * n + 1) * count / (2 * wanted)]);
  const SamplingCost all = of(input(some));
  Motion single;
  single.placements.push_back(whole_.motion.placements[count / 2]);
  const SamplingCost one = of(input(single));
  SamplingCost sum, least;
  sum.add(all, times(count, wanted - 1));
  sum.add(one, -times(count, wanted - 1));
  least.add(all, kMinFraction * times(count, wanted));
  return largerOf(sum, least);
}

/// Samples all steps twice: with some of the clusters, and without clusters to measure the fixed
/// cost.
SamplingCost SamplingTrial::byAllSteps(std::size_t count, const Parts& parts) const {
  const SamplingCost shown = at({0, count + 1}, parts.clusterParts), bare = at({0, count + 1}, 0);
  const double fraction = fractionShown(parts.clusterParts);
  SamplingCost sum = bare;
  sum.add(shown, 1 / fraction);
  sum.add(bare, -1 / fraction);
  return largerOf(sum, shown);
}

/// Samples windows of `steps` steps and windows twice as long. The difference of their costs is the
/// cost of `steps` steps, without the fixed cost of a window. This fixed cost is at most about the
/// cost of `steps` steps. So the difference lies between a third and a half of the cost of a long
/// window. It is clamped to this range, because times are unreliable on a busy machine. A window
/// without clusters gives the fixed cost of a work item.
SamplingCost SamplingTrial::byWindows(std::size_t count, const Parts& parts) const {
  const std::size_t item = placementsOfItem(input(whole_.motion));
  const std::size_t windows = std::clamp(parts.steps / 3, kMinWindows, kMaxWindows);
  const std::size_t steps =
      std::clamp<std::size_t>(parts.steps / (3 * windows), 1, std::max<std::size_t>(item / 2, 1));
  PlacementGroups::Trial some;
  for (std::size_t w = 0; w < windows; ++w) {
    const std::size_t first = (2 * w + 1) * (count - 2 * steps) / (2 * windows);
    some.only.push_back({first, first + 2 * steps});
  }
  const double fraction = fractionShown(parts.clusterParts);
  const double start = threadSeconds();
  SamplerInput grouped = input(whole_.motion);
  grouped.clusterParts = parts.clusterParts;
  const PlacementGroups groups(grouped, *whole_.clusters, run_, &some);
  const double grouping = threadSeconds() - start + some.secondsOfOthers / fraction;
  const double none = at({0, 0}, 1, &groups).seconds;
  SamplingCost sum;
  for (const PlacementRange& both : some.only) {
    const PlacementRange half{both.begin, both.begin + steps};
    const SamplingCost bare = at(half, 0, &groups), one = at(half, parts.clusterParts, &groups),
                       two = at(both, parts.clusterParts, &groups);
    SamplingCost each = two;  // cost of a window of 2 * steps steps
    const double shown = std::max(0.0, two.seconds - bare.seconds);
    each.seconds = 2 * std::clamp(two.seconds - one.seconds, shown / 3, shown / 2);
    sum.add(each, times(count, 2 * windows * steps) / fraction);
    const std::size_t items = (steps + item - 1) / item;
    sum.seconds += std::max(0.0, bare.seconds - none) * times(count, windows * items * item);
  }
  sum.seconds += none + grouping;
  return sum;
}

std::size_t SamplingTrial::mostClusterParts() const {
  const FaceClusters& clusters = *whole_.clusters;
  // Patches at open borders belong to no cluster, so a trial could not leave any of them out. So if
  // there are such patches, the trial samples all clusters.
  if (clusters.firstBorder.back() < clusters.borders.size()) return 1;
  return std::max<std::size_t>(1, clusters.clusters.size() / (kClustersTogether * kMinParts));
}

double SamplingTrial::fractionShown(std::size_t clusterParts) const {
  if (clusterParts == 1) return 1;
  std::size_t shown = 0;
  for (const ShownCluster& s : allClusters(*whole_.clusters, clusterParts)) {
    shown += whole_.clusters->clusters[s.cluster].faceCount;
  }
  return times(shown, whole_.body.triangles.size());
}

SamplerInput SamplingTrial::input(const Motion& motion) const {
  SamplerInput input = whole_.with(motion, whole_.grid);
  input.inside = inside_ ? &*inside_ : nullptr;
  return input;
}

SamplingCost SamplingTrial::at(const PlacementRange& only, std::size_t clusterParts,
                               const PlacementGroups* groups) const {
  SamplerInput part = input(whole_.motion);
  part.only = only;
  part.clusterParts = clusterParts;
  part.groups = groups;
  return of(part);
}

SamplingCost SamplingTrial::of(const SamplerInput& part) const {
  SamplingCost cost;
  sampleCounted(part, cost, run_);
  return cost;
}

double cpuSamplingSeconds(const SamplerInput& whole, int threads, RunContext& run) {
  double seconds = 0;
  tbb::task_arena(1).execute([&] {
    const SamplingTrial trial(whole, run);
    seconds = trial.insideSeconds() + trial.whole().cost.seconds;
  });
  return seconds / threads;
}

}  // namespace swept
