// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/pair_rules.h"

#include <algorithm>

#include "clearance/pair_check.h"

namespace swept::clearance {
namespace {

std::int32_t numberOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
  throw Error(
      Status::InvalidInput, "UnknownPart",
      "a rule for a pair names '" + name + "', but no part has this name; correct the rule");
}

}  // namespace

PairRules::PairRules(const std::vector<std::string>& names, const MechanismOptions& options)
    : required_(options.required) {
  for (const PairRule& given : options.rules) {
    const std::int32_t a = numberOf(given.first, names);
    const std::int32_t b = numberOf(given.second, names);
    if (a == b)
      throw Error(Status::InvalidInput, "UnknownPart",
                  "a rule for a pair names '" + given.first + "' twice; name two different parts");
    const std::string who = "'" + given.first + "' and '" + given.second + "'";
    checkRule(given.rule, "the rule for " + who);
    const NeighbourRule& kept =
        own_.insert({{std::min(a, b), std::max(a, b)}, given.rule}).first->second;
    if (ruleText(kept) != ruleText(given.rule))
      throw Error(Status::InvalidInput, "BadRule",
                  "two rules contradict each other for " + who + ": '" + ruleText(kept) +
                      "' and '" + ruleText(given.rule) + "'; remove one of them");
  }
}

NeighbourRule PairRules::of(PartPair pair) const {
  const auto found = own_.find(pair);
  const NeighbourRule own = found == own_.end() ? NeighbourRule{} : found->second;
  return own.ignored ? own : ruleFor(own, required_);
}

double PairRules::largestRequired() const {
  double largest = required_;
  for (const auto& [pair, rule] : own_) largest = std::max(largest, rule.required.value_or(0));
  return largest;
}

std::vector<PartPair> PairRules::ignored() const {
  std::vector<PartPair> pairs;
  for (const auto& [pair, rule] : own_)
    if (rule.ignored) pairs.push_back(pair);
  return pairs;
}

}  // namespace swept::clearance
