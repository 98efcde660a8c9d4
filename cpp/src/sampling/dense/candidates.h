// Which placements can put a face of the body on the envelope.
//
// In: body, placement space. Out: per face the sorted placements at which it has to be sampled.
// Units: mm. Cost: O(vertices x queries); 4 bytes per (face, placement) pair.
// Source: METHOD.md section 2, "Support queries in placement space", which gives the figures for
// slack and rings.
//
// Every vertex queries the placement space with its own normal, with the normals of its faces, and
// with normals between them where two answers differ (also between neighbouring vertices). The
// winners then spread from vertex to vertex as long as they are within a slack of the local best:
// the envelope changes placement along ridges, and both sheets must reach the ridge.
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
  std::vector<std::uint64_t> start;      ///< per face, and one entry behind the last
  std::vector<std::uint32_t> placement;  ///< sorted within a face
};

/// corners: the half-edges round every vertex of the body (geometry/half_edges.h), sorted.
FacePlacements findCandidates(const SamplerInput& input, const PlacementSpace& space,
                              const DenseSettings& settings, const ListsByKey<>& corners,
                              RunContext& run);

}  // namespace swept::dense
