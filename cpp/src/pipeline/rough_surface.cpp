// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/rough_surface.h"

#include <algorithm>

#include "base/timer.h"
#include "contour/dual_surface.h"
#include "crossings/element_probe.h"
#include "crossings/hermite.h"
#include "signs/count_crossings.h"
#include "signs/signs.h"

namespace swept {
namespace {

/// Faces of all placements together, and how many placements.
constexpr double kRoughFaces = 2e6;
constexpr std::size_t kFewest = 8, kMost = 192;
/// A motion of no more than so many is taken whole, unless it is dense: its sampling is then known
/// as well.
constexpr double kWholeFaces = 12e6;
constexpr std::size_t kMostWhole = 384;
/// About so many are contoured.
constexpr double kRoughCrossings = 1e5;
/// So many probes are timed before fewer are, or so many CPU seconds.
constexpr std::size_t kTimedProbes = 32;
constexpr double kMostProbeSeconds = 0.1;

/// Counts what contouring asks, and times some of it on the whole motion: the more was asked, the
/// fewer of it. For one thread.
class TimedProbe : public SurfaceProbe {
 public:
  explicit TimedProbe(const ElementProbe& whole) : whole_(whole) {}

  void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
            std::vector<ProbeLine>& lines) const override {
    if (count_++ % stride_ != 0) return;
    const double start = threadSeconds();
    whole_.cast(region, crossings, lines);
    seconds_ += threadSeconds() - start;
    if (++cast_ % kTimedProbes == 0 || seconds_ > kMostProbeSeconds) stride_ *= 2;
  }
  /// CPU seconds of all.
  double seconds() const {
    return cast_ == 0 ? 0 : seconds_ * static_cast<double>(count_) / static_cast<double>(cast_);
  }

 private:
  const ElementProbe& whole_;
  mutable std::size_t count_ = 0, cast_ = 0, stride_ = 1;
  mutable double seconds_ = 0;
};

/// The motion along `wanted` of its placements.
Motion thinned(const Motion& motion, std::size_t wanted) {
  Motion part;
  part.continuous = motion.continuous;
  const std::size_t last = motion.placements.size() - 1;
  for (std::size_t n = 0, before = 0; n < wanted; ++n) {
    const std::size_t at = wanted == 1 ? last / 2 : n * last / (wanted - 1);
    if (n > 0 && part.continuous) {
      const std::size_t middle = (before + at) / 2;
      part.midpoints.push_back((before + at) % 2 == 0 ? motion.placements[middle]
                                                      : motion.midpoints[middle]);
    }
    part.placements.push_back(motion.placements[at]);
    before = at;
  }
  return part;
}

/// The element of the whole motion at the time of a crossing of the thinned one.
SweptElement elementOfWhole(SweptElement element, const Motion& whole, const Motion& part,
                            double seconds) {
  const auto& all = whole.placements;
  if (!element.isSidePatch()) seconds = part.placements[element.placement].timeSeconds;
  const auto after = std::upper_bound(
      all.begin(), all.end(), seconds,
      [](double t, const Placement& placement) { return t < placement.timeSeconds; });
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - all.begin(), 1)) - 1;
  const std::size_t last = element.isSidePatch() ? whole.steps() - 1 : all.size() - 1;
  element.placement = static_cast<std::uint32_t>(std::min(at, last));
  return element;
}

double probeSecondsOf(const SamplerInput& whole, const Motion& part, const MarkedEdges& marked,
                      const HermiteGrid& hermite, ComponentMethod components, RunContext& run) {
  std::vector<SweptElement> elements;
  std::vector<std::uint32_t> own;
  for (std::size_t n = 0; n < hermite.crossings.size(); ++n) {
    elements.push_back(elementOfWhole(marked.elements[hermite.winner[n]], whole.motion, part,
                                      hermite.crossings[n].timeSeconds));
    own.push_back(static_cast<std::uint32_t>(n));
  }
  const ElementProbe probe(whole, elements, own);
  const TimedProbe timed(probe);
  buildDualSurface(hermite, components, &timed, run);
  return timed.seconds() / static_cast<double>(std::max<std::size_t>(1, own.size()));
}

}  // namespace

MarkedEdges sampleCounted(SamplerInput input, SamplingCost& cost, RunContext& run) {
  const double start = threadSeconds();
  std::uint64_t crossings = 0;
  input.crossings = &crossings;
  MarkedEdges marked = sampleCpu(input, run);
  cost.add({threadSeconds() - start, static_cast<double>(crossings),
            static_cast<double>(marked.elements.size())},
           1);
  return marked;
}

RoughSurface roughSurface(const SamplerInput& whole, ComponentMethod components, bool probes,
                          RunContext& run) {
  SamplingCost cost;
  const auto sampled = [&](const Motion& motion) {
    return sampleCounted({whole.body, whole.topology, motion, whole.grid, whole.cull,
                          whole.orientable, whole.clusters, nullptr, nullptr, whole.fillsHollows},
                         cost, run);
  };
  const double faces = static_cast<double>(whole.body.triangles.size());
  const std::size_t all = whole.motion.placements.size();
  const bool few = probes && all <= kMostWhole && static_cast<double>(all) * faces <= kWholeFaces;
  const std::size_t wanted =
      std::clamp(static_cast<std::size_t>(kRoughFaces / faces), kFewest, kMost);
  Motion part = thinned(whole.motion, few ? all : std::min(wanted, all));
  MarkedEdges marked = sampled(part);
  RoughSurface found;
  if (part.placements.size() == all) found.all = cost;
  found.crossings = static_cast<double>(countCrossings(marked, whole.grid, run).crossings);
  if (!probes) return found;
  if (found.crossings > kRoughCrossings) {
    const double fewer =
        static_cast<double>(part.placements.size()) * kRoughCrossings / found.crossings;
    part = thinned(whole.motion, std::max<std::size_t>(2, static_cast<std::size_t>(fewer)));
    marked = sampled(part);
  }
  const SignRuns signs = findOutside(marked, whole.grid, run);
  const SamplerInput input{whole.body, whole.topology, part,
                           whole.grid, whole.cull,     whole.orientable};
  const HermiteGrid hermite = buildHermiteGrid(input, marked, signs, ExactTimes::Dropped, run);
  found.probeSeconds = probeSecondsOf(whole, part, marked, hermite, components, run);
  return found;
}

}  // namespace swept
