// Which placements can hold a bit of the body's surface on the envelope.
//
// Every vertex asks the placement space with its own normal, with those of its faces and, where two
// answers differ, with normals between them (also between neighbouring vertices). The winners then
// spread from vertex to vertex as long as they stay within a slack of the local best: the envelope
// changes placement along ridges, and both sheets must reach the ridge.
// Out: per face the sorted placements to sample it at. Cost: O(vertices x queries); 4 bytes a pair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/dense/placement_space.h"
#include "sampling/sampler.h"

namespace swept::dense {

struct CandidateSettings {
  double slack = 0;       ///< mm: how far behind the local best a spread winner is kept
  int freeRings = 1;      ///< rings over which winners spread whatever their advance
  int rings = 8;          ///< rings over which they spread within the slack
  std::size_t most = 96;  ///< a vertex stops taking in placements at this many
};

struct FacePlacements {
  std::vector<std::uint64_t> start;      ///< per face, one past the end at last
  std::vector<std::uint32_t> placement;  ///< sorted within a face
};

FacePlacements findCandidates(const SamplerInput& input, const PlacementSpace& space,
                              const CandidateSettings& settings, RunContext& run);

}  // namespace swept::dense
