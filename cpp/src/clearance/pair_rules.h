// What is asked of two parts of a mechanism. The only place that knows it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept::clearance {

class PairRules {
 public:
  /// Throws Error(InvalidInput): "UnknownPart" where a rule names a part that there is not, or a
  /// part twice; "BadRule" where one is impossible or two contradict each other for a pair.
  PairRules(const std::vector<std::string>& names, const MechanismOptions& options);

  /// A distance, contact or ignored.
  NeighbourRule of(PartPair pair) const;
  /// mm, over all pairs.
  double largestRequired() const;
  bool ignores(PartPair pair) const { return of(pair).ignored; }
  /// Ascending.
  std::vector<PartPair> ignored() const;

 private:
  double required_ = 0;
  std::map<PartPair, NeighbourRule> own_;
};

}  // namespace swept::clearance
