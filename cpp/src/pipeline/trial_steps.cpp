// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/trial_steps.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/threads.h"
#include "base/timer.h"
#include "contour/dual_surface.h"
#include "crossings/element_probe.h"
#include "crossings/hermite.h"
#include "pipeline/coarse_surface.h"
#include "sampling/cpu/deep_inside.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/dense/dense_sampler.h"
#include "sampling/dense/dense_trial.h"
#include "sampling/sampler.h"
#include "signs/count_crossings.h"
#include "signs/signs.h"

namespace swept {
namespace {

/// Copies of triangles that are sampled, and placements.
constexpr double kTrialCopies = 6e6;
constexpr std::size_t kFewest = 8, kMost = 192;
/// Places of a continuous motion where two trials begin, one of them of twice as many steps: what a
/// step takes is their difference, without the copies at both ends that a whole motion has once.
constexpr std::size_t kWindows = 8;
/// Of what the longer trial takes in the mean, a step takes this at least.
constexpr double kLeastShare = 0.2;

/// CPU seconds: of a triangle that is checked and gets its topology, of a pose that is read and
/// planned, and of a crossing that becomes surface.
constexpr double kBodySeconds = 1.5e-6, kPoseSeconds = 1.5e-6, kCrossingSeconds = 3e-6;
/// Cells that are probed after each trial, to learn what a probe takes.
constexpr std::size_t kProbesPerTrial = 2, kProbesOfCopies = 64;
/// A whole sweep has other creases than a few steps of it: 0.0006 to 0.7 probes of a crossing were
/// seen in crowded sweeps. Within these limits the few steps tell.
constexpr double kMinProbesOfCrossing = 0.01, kMaxProbesOfCrossing = 0.5;
/// Steps whose surface is made to count its probes.
constexpr std::size_t kProbedSteps = 4;
/// Bytes of a crossing that is sorted, with its share of what sorting needs, and of an element.
constexpr double kSortedBytes = 16, kElementBytes = 12;
/// sampling/cpu makes about so many work items of a motion, and keeps no more crossings of one than
/// about so many, in a buffer that each thread has.
constexpr double kItems = 48, kThinCrossings = 1 << 20;

/// As sampling/cpu makes its work items; those of few placements are not thinned.
double placementsOfItem(const Prepared& p) {
  const double placements = static_cast<double>(p.motion.placements.size());
  if (p.motion.continuous) return placements / kItems;
  return std::min(8192 / static_cast<double>(p.body.mesh.triangles.size()), placements / 64);
}

Motion partOf(const Motion& motion, std::size_t first, std::size_t count) {
  const auto from = [first](const auto& list, std::size_t n) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector(begin, begin + static_cast<std::ptrdiff_t>(n));
  };
  Motion part;
  part.continuous = motion.continuous;
  part.placements = from(motion.placements, motion.continuous ? count + 1 : count);
  if (motion.continuous) part.midpoints = from(motion.midpoints, count);
  return part;
}

/// CPU seconds, and counts.
struct Cost {
  double seconds = 0, crossings = 0, elements = 0;

  void add(const Cost& other, double times) {
    seconds += times * other.seconds;
    crossings += times * other.crossings;
    elements += times * other.elements;
  }
};

/// A marked edge that a trial found, in the numbers of the whole motion.
struct ProbePlace {
  Eigen::Vector3d corner;
  SweptElement element;
};

/// Counts the probes instead of casting them.
class ProbeCount : public SurfaceProbe {
 public:
  void cast(const Eigen::AlignedBox3d& /*region*/, const std::vector<std::uint32_t>& /*crossings*/,
            std::vector<ProbeLine>& /*lines*/) const override {
    ++count;
  }
  mutable std::atomic<std::size_t> count{0};
};

class Trials {
 public:
  Trials(const Prepared& p, const BodyTopology& topology, const FaceClusters& clusters,
         const Options& options, RunContext& run)
      : p_(p), topology_(topology), clusters_(clusters), options_(options), run_(run) {
    const double start = threadSeconds();
    SamplerInput whole = input(p.motion);
    whole.crossings = &insideCrossings_;
    inside_ = findDeepInside(whole, run);
    insideSeconds_ = threadSeconds() - start;
  }

  /// Of finding out what lies deep inside the whole motion.
  double insideSeconds() const { return insideSeconds_; }
  double insideCrossings() const { return static_cast<double>(insideCrossings_); }
  /// Crossings of the surface, where the trial was the whole motion.
  std::optional<double> surface() const { return surface_; }
  /// Of the map of it.
  double insideBytes() const {
    if (!inside_) return 0;
    const auto& [x, y, z] = p_.grid.points;
    const double points = static_cast<double>(x) * static_cast<double>(y) * static_cast<double>(z);
    return points > static_cast<double>(InsideMap::kMaxBlocks) ? 0 : 7 * points;
  }

  /// How many probes the surface of a few steps needs for each of its crossings.
  double probesOfCrossing() const {
    const std::size_t steps = std::min(kProbedSteps, p_.motion.steps());
    const Motion part = p_.motion.continuous
                            ? partOf(p_.motion, (p_.motion.steps() - steps) / 2, steps)
                            : partOf(p_.motion, p_.motion.placements.size() / 2, 1);
    const SamplerInput piece = input(part);
    MarkedEdges marked = sampleCpu(piece, run_);
    const SignRuns signs = findOutside(marked, p_.grid, run_);
    const HermiteGrid hermite = buildHermiteGrid(piece, marked, signs, ExactTimes::Dropped, run_);
    if (hermite.crossings.empty()) return 0;
    const ProbeCount probes;
    buildDualSurface(hermite, options_.components, &probes, run_);
    return static_cast<double>(probes.count) / static_cast<double>(hermite.crossings.size());
  }

  /// Of a probe, in the mean over the cells that the trials before met.
  double probeSeconds() const {
    if (places_.empty()) return 0;
    std::vector<SweptElement> elements;
    std::vector<std::uint32_t> numbers;
    for (const ProbePlace& place : places_) {
      numbers.push_back(static_cast<std::uint32_t>(elements.size()));
      elements.push_back(place.element);
    }
    const SamplerInput whole = input(p_.motion);
    const ElementProbe probe(whole, elements, numbers);
    const double start = threadSeconds();
    for (const std::uint32_t n : numbers) {
      const Eigen::Vector3d low = places_[n].corner, high = low + Eigen::Vector3d::Ones();
      std::vector<ProbeLine> lines(1);
      lines[0].from = low;
      lines[0].to = high;
      probe.cast({low, high}, {n}, lines);
    }
    return (threadSeconds() - start) / static_cast<double>(places_.size());
  }

  /// Of the whole motion.
  Cost whole() {
    const Motion& motion = p_.motion;
    const std::size_t count = motion.continuous ? motion.steps() : motion.placements.size();
    const double faces = static_cast<double>(p_.body.mesh.triangles.size());
    const std::size_t wanted =
        std::clamp(static_cast<std::size_t>(kTrialCopies / faces), kFewest, kMost);
    if (count <= 2 * wanted) return ofAll();
    return motion.continuous ? byWindows(count, wanted) : bySomeCopies(count, wanted);
  }

 private:
  Cost ofAll() {
    MarkedEdges marks;
    const Cost cost = of(p_.motion, numbersFrom(0, p_.motion.placements.size()), &marks);
    surface_ = static_cast<double>(countCrossings(marks, p_.grid, run_).crossings);
    return cost;
  }

  /// Of a union of copies: some of them at once, less what sampling takes for the grid alone.
  Cost bySomeCopies(std::size_t count, std::size_t wanted) {
    Motion some;
    std::vector<std::uint32_t> numbers;
    for (std::size_t n = 0; n < wanted; ++n) {
      numbers.push_back(static_cast<std::uint32_t>((2 * n + 1) * count / (2 * wanted)));
      some.placements.push_back(p_.motion.placements[numbers.back()]);
    }
    some.continuous = false;
    const Cost all = of(some, numbers);
    const Cost one = at(count / 2, 1);
    Cost sum, least;
    sum.add(all, times(count, wanted - 1));
    sum.add(one, -times(count, wanted - 1));
    least.add(all, kLeastShare * times(count, wanted));
    return largerOf(sum, least);
  }

  Cost byWindows(std::size_t count, std::size_t wanted) {
    Cost sum, least;
    const std::size_t steps = std::max<std::size_t>(1, wanted / (3 * kWindows));
    for (std::size_t w = 0; w < kWindows; ++w) {
      const std::size_t first = (2 * w + 1) * (count - 2 * steps) / (2 * kWindows);
      const Cost one = at(first, steps), two = at(first, 2 * steps);
      sum.add(two, times(count, kWindows * steps));
      sum.add(one, -times(count, kWindows * steps));
      least.add(two, kLeastShare * times(count, 2 * kWindows * steps));
    }
    return largerOf(sum, least);
  }

  static Cost largerOf(const Cost& a, const Cost& b) {
    return {std::max(a.seconds, b.seconds), std::max(a.crossings, b.crossings),
            std::max(a.elements, b.elements)};
  }

  static std::vector<std::uint32_t> numbersFrom(std::size_t first, std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
    return numbers;
  }

  static double times(std::size_t all, std::size_t part) {
    return static_cast<double>(all) / static_cast<double>(part);
  }

  SamplerInput input(const Motion& motion) const {
    return {p_.body.mesh,       topology_,  motion,  p_.grid, options_.cull,
            p_.body.orientable, &clusters_, nullptr, nullptr, !options_.keepCavities};
  }

  Cost at(std::size_t first, std::size_t count) {
    const Motion part = partOf(p_.motion, first, count);
    return of(part, numbersFrom(first, part.placements.size()));
  }

  /// Of a part of the motion; `numbers`: of its placements in the whole. `kept`: gets the marks.
  Cost of(const Motion& motion, const std::vector<std::uint32_t>& numbers,
          MarkedEdges* kept = nullptr) {
    const double start = threadSeconds();
    std::uint64_t crossings = 0;
    SamplerInput part = input(motion);
    part.crossings = &crossings;
    if (inside_) part.inside = &*inside_;
    MarkedEdges marks = sampleCpu(part, run_);
    Cost cost;
    cost.seconds = threadSeconds() - start;
    cost.elements = static_cast<double>(marks.elements.size());
    cost.crossings = static_cast<double>(crossings);
    choosePlaces(marks, numbers);
    if (kept != nullptr) *kept = std::move(marks);
    return cost;
  }

  /// Some of the edges that a trial marked.
  void choosePlaces(const MarkedEdges& marks, const std::vector<std::uint32_t>& numbers) {
    const std::size_t layers = marks.layers.size();
    const std::size_t wanted = p_.motion.continuous ? kProbesPerTrial : kProbesOfCopies;
    for (std::size_t n = 0; n < wanted; ++n) {
      // The first edge from a layer on; layers apart, so that they lie at different places.
      for (std::size_t i = (2 * n + 1) * layers / (2 * wanted); i < layers; ++i) {
        const auto& edges = marks.layers[i].edges[0];
        if (edges.empty()) continue;
        const auto& columns = marks.layers[i].columnStart[0];
        const auto middle = static_cast<std::uint32_t>(edges.size() / 2);
        const auto j = std::upper_bound(columns.begin(), columns.end(), middle) - columns.begin();
        SweptElement element = marks.elements[edges[middle].lowElement];
        element.placement = numbers[element.placement];
        places_.push_back(
            {Eigen::Vector3d(static_cast<double>(i), static_cast<double>(j - 1), edges[middle].k),
             element});
        break;
      }
    }
  }

  const Prepared& p_;
  const BodyTopology& topology_;
  const FaceClusters& clusters_;
  const Options& options_;
  RunContext& run_;
  std::vector<ProbePlace> places_;
  std::optional<InsideMap> inside_;
  double insideSeconds_ = 0;
  std::uint64_t insideCrossings_ = 0;
  std::optional<double> surface_;
};

}  // namespace

Estimate estimateByTrial(const Estimate& estimate, const Prepared& p, const BodyTopology& topology,
                         const BodyCost& body, const Options& options, RunContext& run) {
  if (options.offset > 0 || options.conservative) return estimate;
  const FaceClusters clusters = buildClusters(p.body.mesh, topology);
  const double byBox = static_cast<double>(estimate.triangles) / 2;
  double surface = std::min(byBox, guessCrossings(clusters, p.motion, p.grid));
  const auto bytesForAll = [&] {
    return static_cast<std::uint64_t>(static_cast<double>(estimate.memoryBytes) +
                                      (surface - byBox) * bytesOfCrossing(options));
  };
  const double threads = threadsOf(run);
  const double before = std::max(body.seconds / threads,
                                 static_cast<double>(p.body.mesh.triangles.size()) * kBodySeconds) +
                        static_cast<double>(p.givenPoses) * kPoseSeconds;
  Estimate better = estimate;
  tbb::task_arena alone(1);
  if (options.backend != Backend::Gpu &&
      dense::suits(p.body.mesh, p.motion, p.grid.cell, options.cull, p.body.orientable, {})) {
    const SamplerInput input{p.body.mesh, topology,     p.motion,
                             p.grid,      options.cull, p.body.orientable};
    const auto cost = alone.execute([&] { return dense::tryDense(input, run); });
    better.triangles = static_cast<std::int64_t>(2 * surface);
    better.seconds = before + (cost.seconds + surface * kCrossingSeconds) / threads;
    better.memoryBytes = std::max(body.bytes, bytesForAll() - denseBytes(p.body.mesh) +
                                                  static_cast<std::uint64_t>(cost.bytes));
    return better;
  }
  const auto [sampling, most, map] = alone.execute([&] {
    Trials trials(p, topology, clusters, options, run);
    Cost cost = trials.whole();
    surface = trials.surface().value_or(surface);
    cost.seconds += trials.insideSeconds();
    const double probes =
        std::clamp(trials.probesOfCrossing(), kMinProbesOfCrossing, kMaxProbesOfCrossing);
    cost.seconds += surface * (kCrossingSeconds + probes * trials.probeSeconds());
    return std::tuple(cost, trials.insideCrossings(), trials.insideBytes());
  });
  better.triangles = static_cast<std::int64_t>(2 * surface);
  better.seconds = before + sampling.seconds / threads;
  const bool thins = sampling.crossings > kItems * kThinCrossings && placementsOfItem(p) >= 16;
  const double kept = thins ? 2 * threads * kThinCrossings + kItems * surface : sampling.crossings;
  // What the check of the body has taken is free again when the motion is sampled, and what the map
  // was made of too.
  const double bytes =
      std::max(most * kSortedBytes, kept * kSortedBytes + sampling.elements * kElementBytes + map);
  better.memoryBytes = std::max(body.bytes, bytesForAll() + static_cast<std::uint64_t>(bytes));
  return better;
}

}  // namespace swept
