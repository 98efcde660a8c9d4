// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/dense_sampler.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/sort_unique.h"
#include "geometry/half_edges.h"
#include "geometry/mesh_parts.h"
#include "sampling/dense/candidates.h"
#include "sampling/dense/leak_repair.h"
#include "sampling/dense/pair_sampler.h"

namespace swept::dense {
namespace {

double bodyRadius(const TriMesh& body) { return boxOf(body).diagonal().norm() / 2; }

class DenseRun {
 public:
  DenseRun(const SamplerInput& input, const PlacementSpace& space, const DenseSettings& settings,
           RunContext& run)
      : input_(input),
        space_(space),
        settings_(settings),
        run_(run),
        sampler_(input, run),
        corners_(halfEdgesByVertex(input.body)) {
    for (std::size_t v = 0; v < corners_.keys(); ++v) corners_.of(v);
  }

  /// Returns nothing if `mayGiveUp` is set and the chosen pairs leave too much of the surface open.
  std::optional<DenseSurface> sample(bool mayGiveUp) {
    const std::size_t faces = input_.body.triangles.size();
    const double cell = input_.grid.cell;
    const FacePlacements candidates = findCandidates(input_, space_, settings_, corners_, run_);
    for (std::uint32_t f = 0; f < faces; ++f) {
      sampler_.add(f, candidates.placement.data() + candidates.start[f],
                   candidates.placement.data() + candidates.start[f + 1]);
    }
    for (const std::uint32_t k :
         wholeCopies(space_, input_.motion.placements.size(), settings_.wholeCopies)) {
      sampler_.addWhole(k);
    }
    sampler_.flush();
    const double margin = settings_.margin(cell, space_.remainder());
    const BodyTests tests(input_.body);
    LeakSearch leaks;
    ClearPoints clear;
    for (int round = 0;; ++round) {
      const SignRuns signs = findOutside(sampler_.marked(), input_.grid, run_);
      leaks = findLeaks(input_, tests, space_, sampler_.marked(), signs, margin, clear, run_);
      if (leaks.missing.empty() || round == settings_.rounds) break;
      close(leaks);
    }
    const auto maxOpen = settings_.maxOpenFraction * static_cast<double>(leaks.tested);
    if (mayGiveUp && (!leaks.complete || static_cast<double>(leaks.covered) > maxOpen)) {
      return std::nullopt;
    }
    DenseSurface out;
    out.notes.push_back(describe(leaks, margin));
    out.marked = sampler_.take();
    return out;
  }

 private:
  /// Samples the missing pairs together with the faces around them.
  void close(const LeakSearch& leaks) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto& [face, placement] : leaks.missing) {
      for (const std::int32_t v : input_.body.triangles[face]) {
        for (const std::uint32_t corner : corners_.asTheyStand(v)) {
          pairs.emplace_back(corner / 3, placement);
        }
      }
    }
    sortUnique(pairs);
    for (const auto& pair : pairs) sampler_.add(pair.first, &pair.second, &pair.second + 1);
    sampler_.flush();
  }

  Finding describe(const LeakSearch& leaks, double margin) const {
    const double all = static_cast<double>(input_.body.triangles.size()) *
                       static_cast<double>(input_.motion.placements.size());
    std::string text =
        textOf(3, "to save time, only ", 100 * static_cast<double>(sampler_.pairs()) / all,
               " % of the sweep was sampled, because the poses lie close together. At ",
               leaks.covered, " of ", leaks.tested,
               " tested points, the envelope is too small by more than ", margin, " mm");
    if (leaks.covered > 0)
      text += textOf(3, ", but by at most ", leaks.deepest + space_.remainder(), " mm");
    text += " (it is never too large); to sample everything, use --no-cull or cull=False";
    return {"DensePruned", leaks.covered, {}, std::move(text)};
  }

  const SamplerInput& input_;
  const PlacementSpace& space_;
  const DenseSettings& settings_;
  RunContext& run_;
  PairSampler sampler_;
  ListsByKey<> corners_;  // per vertex of the body; sorted
};

}  // namespace

std::vector<std::uint32_t> wholeCopies(const PlacementSpace& space, std::size_t placements,
                                       int count) {
  std::vector<std::uint32_t> chosen;
  std::uint32_t nearest = 0;
  for (std::uint32_t k = 0; k < placements; ++k) {
    if (dot(space.point(k), space.point(k)) < dot(space.point(nearest), space.point(nearest))) {
      nearest = k;
    }
  }
  chosen.push_back(nearest);
  for (int axis = 0; axis < 6 && static_cast<int>(chosen.size()) < count; ++axis) {
    for (const float direction : {-1.0f, 1.0f}) {
      Point6 g{};
      g[static_cast<std::size_t>(axis)] = direction;
      chosen.push_back(space.support(g, nearest).placement);
    }
  }
  sortUnique(chosen);
  return chosen;
}

bool suits(const TriMesh& body, const Motion& motion, double cell, bool cull, bool orientable,
           const DenseSettings& settings) {
  const double pairs =
      static_cast<double>(body.triangles.size()) * static_cast<double>(motion.placements.size());
  if (motion.continuous || !cull || !orientable || pairs < settings.minPairs) return false;
  const PlacementSpace space(body, motion.placements, PlacementSpace::kExtentOnly);
  return space.turn() <= settings.maxTurn &&
         space.reach() <= settings.maxReach * bodyRadius(body) &&
         space.remainder() <= settings.maxRemainder * cell;
}

std::optional<DenseSurface> sampleDense(const SamplerInput& input, const DenseSettings& settings,
                                        RunContext& run) {
  if (!suits(input.body, input.motion, input.grid.cell, input.cull, input.orientable, settings)) {
    return std::nullopt;
  }
  const PlacementSpace space(input.body, input.motion.placements);
  const double pairs = static_cast<double>(input.body.triangles.size()) *
                       static_cast<double>(input.motion.placements.size());
  return DenseRun(input, space, settings, run).sample(pairs <= settings.bruteForcePairs);
}

}  // namespace swept::dense
