// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/pair_rules.h"

#include <algorithm>

namespace swept::clearance {
namespace {

std::int32_t numberOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
  throw Error(Status::InvalidInput, "UnknownPart",
              "a pair to be ignored names '" + name + "', and no part has that name");
}

}  // namespace

PairRules::PairRules(const std::vector<std::string>& names, const MechanismOptions& options)
    : required_(options.required) {
  for (const auto& [one, other] : options.ignored) {
    const std::int32_t a = numberOf(one, names);
    const std::int32_t b = numberOf(other, names);
    if (a == b)
      throw Error(Status::InvalidInput, "UnknownPart",
                  "a pair to be ignored names '" + one + "' twice; it takes two parts");
    ignored_.insert({std::min(a, b), std::max(a, b)});
  }
}

}  // namespace swept::clearance
