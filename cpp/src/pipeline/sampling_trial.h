// Estimates the cost of sampling a motion by sampling parts of it on the grid of the run.
// In:    the sampler input of the run, with clusters.
// Out:   CPU seconds, crossings and elements of the whole motion.
// Cost:  limited by counts of triangle copies and crossings, not by time: about kTrialWork, or up
//        to twice as much if this suffices to sample the whole motion. Building the map of the
//        inside takes as long as in a run.
// Method: a trial samples windows of a few steps at some placements of the motion. For a body with
//        many triangles, a window uses only some clusters of faces, while culling still uses the
//        whole body. Windows are cut into work items as in a run, and skip the same blocks and
//        groups of placements as the run (sampling/culling/step_blocks.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "pipeline/sampling_cost.h"
#include "sampling/culling/inside_map.h"
#include "sampling/sampler.h"

namespace swept {

class PlacementGroups;

class SamplingTrial {
 public:
  SamplingTrial(const SamplerInput& whole, RunContext& run);

  /// Returns the CPU seconds for building the map of the inside of the whole motion
  /// (sampling/cpu/deep_inside.h).
  double insideSeconds() const { return insideSeconds_; }
  struct Whole {
    SamplingCost cost;
    std::optional<MarkedEdges> marked;  ///< set if the trial sampled the whole motion
  };
  /// Returns the cost of sampling the whole motion, without insideSeconds().
  Whole whole() const;
  /// Returns the peak memory (bytes) of sampling: the larger of two phases, building the map of the
  /// inside and sampling the whole motion. `surface`: number of crossings of the surface.
  double bytesOf(const SamplingCost& sampling, double surface, double threads) const;

 private:
  /// The part of the motion that a trial samples.
  struct Parts {
    std::size_t steps = 0;         ///< upper limit for all windows together
    std::size_t clusterParts = 1;  ///< see SamplerInput
    bool all = false;              ///< true: all steps
  };

  /// True if the sampler tests clusters of faces: for continuous motions, and for unions of
  /// separate copies only with a map of the inside.
  bool byClusters() const { return whole_.motion.continuous || inside_.has_value(); }
  Parts partsFor(std::size_t count) const;
  SamplingCost bySomeCopies(std::size_t count, std::size_t wanted) const;
  SamplingCost byWindows(std::size_t count, const Parts& parts) const;
  SamplingCost byAllSteps(std::size_t count, const Parts& parts) const;
  std::size_t mostClusterParts() const;
  /// Returns the fraction of all faces that a trial with `clusterParts` samples.
  double fractionShown(std::size_t clusterParts) const;

  SamplerInput input(const Motion& motion) const;
  SamplingCost at(const PlacementRange& only, std::size_t clusterParts,
                  const PlacementGroups* groups = nullptr) const;
  SamplingCost of(const SamplerInput& part) const;

  const SamplerInput& whole_;
  RunContext& run_;
  std::optional<InsideMap> inside_;
  double insideSeconds_ = 0;
  std::uint64_t insideCrossings_ = 0;
};

/// Returns the seconds that the CPU is expected to take for sampling the whole motion on `threads`
/// threads. `whole` must have clusters.
double cpuSamplingSeconds(const SamplerInput& whole, int threads, RunContext& run);

}  // namespace swept
