// The sampler of dense motions: unions of very many copies that differ little (vibrations).
//
// Only the (face, placement) pairs that can reach the envelope are sampled (candidates.h), besides
// a few whole copies that close the inside. What the choice left open is searched for against all
// placements and closed, round by round (leak_repair.h). Its result errs towards the outside only,
// and by what the finding "DensePruned" says. Brute force (sampleCpu) is the oracle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "sampling/sampler.h"
#include "signs/signs.h"
#include "swept/report.h"

namespace swept::dense {

struct DenseSettings {
  double leastPairs = 5e7;    ///< faces x placements from which the sampler is used
  double mostTurn = 0.15;     ///< rad, from the mean placement
  double mostReach = 0.25;    ///< of the body's radius, from the mean placement
  double mostRemainder = 2;   ///< cells, of the linearisation
  double slackCells = 0.3;    ///< see CandidateSettings; the remainder comes on top
  double marginCells = 0.05;  ///< a placement that reaches less far beyond counts as met
  int freeRings = 1, rings = 8;
  std::size_t mostAtVertex = 96;
  int wholeCopies = 12;
  double mostLeft = 1e-3;        ///< share of the surface points still open: above, brute force ...
  double bruteForcePairs = 2e9;  ///< ... where it has at most this many pairs to do
  int rounds = 6;                ///< of repair
};

struct DenseSurface {
  MarkedEdges marked;
  std::vector<Finding> notes;
};

/// Nothing if the motion or the body does not suit: not a union of copies, few of them, large
/// motions, an open body, culling off; or if too much stayed open and brute force is affordable.
std::optional<DenseSurface> sampleDense(const SamplerInput& input, const DenseSettings& settings,
                                        RunContext& run);

/// Would sampleDense() take this on? O(placements), without building anything.
bool suits(const TriMesh& body, const Motion& motion, double cell, bool cull, bool orientable,
           const DenseSettings& settings);

}  // namespace swept::dense
