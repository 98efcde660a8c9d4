// What sampling a motion takes, from parts of it that are sampled on its own grid.
// In:    the run's sampler input with clusters.
// Out:   CPU seconds, crossings and elements of the whole.
// Cost:  counted in copies of triangles and in crossings, not in time: about kTrialWork, and twice
//        as many where that is all; finding out what lies deep inside, as in a run.
// A part is a few steps at some places of the motion; of bodies with many triangles only some
// clusters of faces, those of the whole body being culled as in the run. They are parts of the
// run's own work items, with what its blocks and groups of placements leave out.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "pipeline/sampling_cost.h"
#include "sampling/culling/inside_map.h"
#include "sampling/sampler.h"

namespace swept {

class PlaceGroups;

class SamplingTrial {
 public:
  SamplingTrial(const SamplerInput& whole, RunContext& run);

  /// CPU seconds of finding out what lies deep inside the whole motion.
  double insideSeconds() const { return insideSeconds_; }
  struct Whole {
    SamplingCost cost;
    std::optional<MarkedEdges> marked;  ///< where all of it has been sampled
  };
  /// The whole motion, without that.
  Whole whole() const;
  /// Of what is held while the whole motion is sampled; before that, of what the map of what lies
  /// inside is made of. `surface`: crossings of the surface.
  double bytesOf(const SamplingCost& sampling, double surface, double threads) const;

 private:
  /// What of the motion is sampled.
  struct Parts {
    std::size_t steps = 0;         ///< at most, all together
    std::size_t clusterParts = 1;  ///< see SamplerInput
    bool all = false;              ///< all steps
  };

  /// Whether the sampler looks at clusters of faces: not at a union of which nothing is known to
  /// lie inside.
  bool byClusters() const { return whole_.motion.continuous || inside_.has_value(); }
  Parts partsFor(std::size_t count) const;
  SamplingCost bySomeCopies(std::size_t count, std::size_t wanted) const;
  SamplingCost byWindows(std::size_t count, const Parts& parts) const;
  SamplingCost byAllSteps(std::size_t count, const Parts& parts) const;
  std::size_t mostClusterParts() const;
  /// Of the faces, that `clusterParts` shows.
  double fractionShown(std::size_t clusterParts) const;

  SamplerInput input(const Motion& motion) const;
  SamplingCost at(const PlacementRange& only, std::size_t clusterParts,
                  const PlaceGroups* groups = nullptr) const;
  SamplingCost of(const SamplerInput& part) const;

  const SamplerInput& whole_;
  RunContext& run_;
  std::optional<InsideMap> inside_;
  double insideSeconds_ = 0;
  std::uint64_t insideCrossings_ = 0;
};

}  // namespace swept
