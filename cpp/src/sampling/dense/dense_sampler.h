// The sampler for dense motions: unions of very many copies that differ little (vibrations).
//
// In: body and placements. Out: marked edges, and the finding "DensePruned". Units: mm, cells.
// Cost: a few seconds for 10^5 placements (docs/performance.md).
// Promise: errs towards the outside only, by what "DensePruned" reports. Brute force (sampleCpu) is
// the oracle.
// Source: METHOD.md section 2, "Dense motions".
//
// Only the (face, placement) pairs that can reach the envelope are sampled (candidates.h), besides
// a few whole copies that close the inside. What this choice left open is searched for against all
// placements and closed, round by round (leak_repair.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "sampling/dense/placement_space.h"
#include "sampling/sampler.h"
#include "signs/signs.h"
#include "swept/report.h"

namespace swept::dense {

struct DenseSettings {
  double minPairs = 5e7;    ///< faces x placements from which this sampler is used
  double maxTurn = 0.15;    ///< rad, from the mean placement
  double maxReach = 0.25;   ///< fraction of the body's radius, from the mean placement
  double maxRemainder = 2;  ///< cells, of the linearisation
  /// How far behind the local best a winner that has spread is still kept; the remainder of the
  /// linearisation is added.
  double slackCells = 0.3;
  /// A placement that reaches less far beyond a point does not count as missed.
  double marginCells = 0.05;
  /// mm; `remainder`: of the linearisation.
  double margin(double cell, double remainder) const {
    return marginCells * cell + 0.25 * remainder;
  }
  int freeRings = 1;  ///< rings of vertices over which winners spread whatever their advance
  int rings = 8;      ///< rings over which they spread within the slack
  std::size_t maxAtVertex = 96;  ///< a vertex accepts no more placements beyond this number
  int wholeCopies = 12;
  /// Fraction of the surface points still open: above it, brute force takes over ...
  double maxOpenFraction = 1e-3;
  double bruteForcePairs = 2e9;  ///< ... if it has at most this many pairs to sample
  int rounds = 6;                ///< of repair
};

struct DenseSurface {
  MarkedEdges marked;
  std::vector<Finding> notes;
};

/// Returns nothing if the motion or the body is not suitable (no union of copies, few copies, large
/// motions, an open body, culling switched off), or if too much stayed open and brute force is
/// affordable.
std::optional<DenseSurface> sampleDense(const SamplerInput& input, const DenseSettings& settings,
                                        RunContext& run);

/// The placement nearest to the mean, and those farthest along fixed directions in the six
/// coordinates, each once: they are sampled whole.
std::vector<std::uint32_t> wholeCopies(const PlacementSpace& space, std::size_t placements,
                                       int count);

/// Whether sampleDense() is suitable; O(placements), without building anything.
bool suits(const TriMesh& body, const Motion& motion, double cell, bool cull, bool orientable,
           const DenseSettings& settings);

}  // namespace swept::dense
