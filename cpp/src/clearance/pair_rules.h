// What is asked of two parts of a mechanism. The only place that knows it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept::clearance {

class PairRules {
 public:
  /// Throws Error(InvalidInput, "UnknownPart") where a rule names a part that there is not, or a
  /// part twice.
  PairRules(const std::vector<std::string>& names, const MechanismOptions& options);

  /// mm.
  double required(PartPair) const { return required_; }
  /// Over all pairs.
  double largestRequired() const { return required_; }
  bool ignores(PartPair pair) const { return ignored_.contains(pair); }
  /// Ascending.
  const std::set<PartPair>& ignored() const { return ignored_; }

 private:
  double required_ = 0;
  std::set<PartPair> ignored_;
};

}  // namespace swept::clearance
