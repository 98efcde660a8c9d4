// Finds the placements that can bring a face of the body to the surface of the envelope.
//
// In: body, placement space. Out: for each face the sorted placements at which it must be sampled.
// Units: mm. Cost: O(vertices x queries); 4 bytes per (face, placement) pair.
// Source: docs/pipeline.md, "Dense motions". DenseSettings has the values of slack and rings.
//
// A query at a vertex with a normal finds its winner: the placement with the largest advance along
// the normal (placement_space.h). Every vertex queries its own normal and the normals of its faces.
// If two winners differ, normals in between are queried, too. The same is done for pairs of
// adjacent vertices. Then a vertex passes its winners on to its neighbours. A neighbour accepts a
// winner if its advance there is within a slack of the best advance there. Reason: at a ridge the
// envelope changes from one placement to another, and both surfaces must reach the ridge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/lists_by_key.h"
#include "sampling/dense/placement_space.h"
#include "sampling/sampler.h"

namespace swept::dense {

struct DenseSettings;

struct FacePlacements {
  /// Per face: its first index in `placement`; with one more entry at the end.
  std::vector<std::uint64_t> start;
  std::vector<std::uint32_t> placement;  ///< sorted within a face
};

/// Returns the candidates. `corners`: the half-edges at every vertex of the body
/// (geometry/half_edges.h), sorted.
FacePlacements findCandidates(const SamplerInput& input, const PlacementSpace& space,
                              const DenseSettings& settings, const ListsByKey<>& corners,
                              RunContext& run);

}  // namespace swept::dense
