// The sampler for dense motions: unions of very many copies that differ little (vibrations).
//
// In: body and placements. Out: marked edges, and the finding "DensePruned". Units: mm, cells.
// Cost: a few seconds for 10^5 placements (docs/performance.md).
// Promise: the envelope may be too small by the figure in "DensePruned", but never too large. Tests
// compare with sampling all copies (sampleCpu).
// Source: docs/pipeline.md, "Dense motions".
//
// The sampler chooses the (face, placement) pairs that can reach the envelope (candidates.h) and a
// few whole copies that close the inside. Then it finds where this choice leaves the envelope open,
// by tests against all placements, and adds the missing pairs, round by round (leak_repair.h).
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
  double minPairs = 5e7;  ///< smallest number of faces x placements for this sampler
  double maxTurn = 0.15;  ///< rad, largest turn relative to the mean placement
  /// Largest displacement from the mean placement, as a fraction of the body's radius.
  double maxReach = 0.25;
  double maxRemainder = 2;  ///< cells, largest error of the linear form (placement_space.h)
  /// A winner (candidates.h) is passed on to a vertex if its advance there is less than the best
  /// advance by at most this (cells) plus the error of the linear form.
  double slackCells = 0.3;
  /// A placement counts as missed only if it reaches beyond a point by more than this (cells).
  double marginCells = 0.05;
  /// Returns marginCells in mm, plus an allowance for the error `remainder` (mm) of the linear
  /// form.
  double margin(double cell, double remainder) const {
    return marginCells * cell + 0.25 * remainder;
  }
  int freeRings = 1;             ///< rings of vertices to which all winners are passed on
  int rings = 8;                 ///< rings to which winners within the slack are passed on
  std::size_t maxAtVertex = 96;  ///< a vertex accepts at most this many placements
  int wholeCopies = 12;
  /// Largest fraction of the surface points that may remain open. Above it, all copies are sampled
  /// instead, unless they have more than bruteForcePairs pairs.
  double maxOpenFraction = 1e-3;
  double bruteForcePairs = 2e9;
  int rounds = 6;  ///< largest number of repair rounds
};

struct DenseSurface {
  MarkedEdges marked;
  std::vector<Finding> notes;
};

/// Returns nothing if motion or body are not suitable: no union of copies, too few copies,
/// displacements too large, an open body, or culling switched off. Also returns nothing if too many
/// surface points remain open, and the whole union is small enough to be sampled instead.
std::optional<DenseSurface> sampleDense(const SamplerInput& input, const DenseSettings& settings,
                                        RunContext& run);

/// Returns the placements that are sampled as whole copies: the one nearest to the mean, and those
/// farthest along fixed directions in the six coordinates (placement_space.h). Each occurs once.
std::vector<std::uint32_t> wholeCopies(const PlacementSpace& space, std::size_t placements,
                                       int count);

/// Returns whether sampleDense() suits the input. Cost: O(placements); builds no tree.
bool suits(const TriMesh& body, const Motion& motion, double cell, bool cull, bool orientable,
           const DenseSettings& settings);

}  // namespace swept::dense
