// Places the parts of a sequence at their goals, and checks them before any search begins.
// In:      the moving parts, the parts that stand still, and the rules for pairs.
// Out:     the neighbours of a part, given which other parts are already installed.
// Units:   mm.
// Cost:    one exact check for each pair of parts of which at least one moves.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/pair_rules.h"
#include "swept/sequence.h"

namespace swept::path {

/// Two parts that overlap at their goals, or are too near each other there.
struct NearPair {
  PartPair parts;
  NeighbourClearance row;
  bool intersect;
};

class Assembled {
 public:
  /// Throws Error(InvalidInput) with the codes of findSequence(), and Error(Cancelled).
  Assembled(const std::vector<SequencePart>& parts, const std::vector<StillPart>& still,
            const SequenceOptions& options, RunContext& run);

  /// Returns the neighbours of a part: the moving parts marked in `installed`, at their goals, and
  /// the parts that stand still. The other moving parts are absent.
  std::vector<ClearanceNeighbour> neighboursOf(std::size_t part,
                                               const std::vector<char>& installed) const;
  /// Returns the box around all parts at their goals, mm.
  const Eigen::AlignedBox3d& box() const { return box_; }
  /// Returns the goal of a part.
  static const Pose& goalOf(const SequencePart& part);
  std::vector<PartPair> ignored() const { return rules_.ignored(); }

 private:
  void requireApart(std::size_t parts, const PathOptions& options, RunContext& run) const;

  [[noreturn]] void refuseWorst(const std::vector<NearPair>& pairs,
                                const PathOptions& options) const;

  clearance::PairRules rules_;
  std::vector<ClearanceNeighbour> placed_;  ///< the moving parts, then the parts that stand still
  std::size_t parts_;
  Eigen::AlignedBox3d box_;
};

}  // namespace swept::path
