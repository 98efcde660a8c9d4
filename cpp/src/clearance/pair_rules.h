// Decides which rule holds for two parts of a mechanism. Path searches for sequences use it, too.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept::clearance {

class PairRules {
 public:
  /// Throws Error(InvalidInput). "UnknownPart": a rule names an unknown part or the same part
  /// twice. "BadRule": a rule is impossible, or two rules contradict each other for a pair.
  PairRules(const std::vector<std::string>& names, const MechanismOptions& options);

  /// Returns the rule of a pair: its required distance, its allowed contact, or that it is ignored.
  NeighbourRule of(PartPair pair) const;
  /// Returns the largest required distance of all pairs, mm.
  double largestRequired() const;
  bool ignores(PartPair pair) const { return of(pair).ignored; }
  /// Pairs that a rule excludes, in ascending order.
  std::vector<PartPair> ignored() const;

 private:
  double required_ = 0;
  std::map<PartPair, NeighbourRule> own_;
};

}  // namespace swept::clearance
