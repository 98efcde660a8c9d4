// The parts of a sequence where they belong, checked before any search begins.
// In:    parts, what stands still, what pairs ask for. Out: the neighbours of each step.
// Units: mm. Cost: an exact check of every pair whose boxes are near.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/pair_rules.h"
#include "swept/sequence.h"

namespace swept::path {

/// Two parts that are too near where they belong, or lie in each other.
struct NearPair {
  PartPair parts;
  NeighbourClearance row;
  bool intersect;
};

class Assembled {
 public:
  /// Throws Error(InvalidInput) as findSequence() says, Error(Cancelled).
  Assembled(const std::vector<SequencePart>& parts, const std::vector<StillPart>& still,
            const SequenceOptions& options, RunContext& run);

  /// Of one part, where those marked in `installed` are in their places.
  std::vector<ClearanceNeighbour> neighboursOf(std::size_t part,
                                               const std::vector<char>& installed) const;
  /// Round everything, mm.
  const Eigen::AlignedBox3d& box() const { return box_; }
  /// Where a part belongs.
  static const Pose& goalOf(const SequencePart& part);
  std::vector<PartPair> ignored() const { return rules_.ignored(); }

 private:
  void requireApart(std::size_t parts, const PathOptions& options, RunContext& run) const;

  [[noreturn]] void refuseWorst(const std::vector<NearPair>& pairs,
                                const PathOptions& options) const;

  clearance::PairRules rules_;
  std::vector<ClearanceNeighbour> placed_;  ///< the parts, behind them what stands still
  std::size_t parts_;
  Eigen::AlignedBox3d box_;
};

}  // namespace swept::path
