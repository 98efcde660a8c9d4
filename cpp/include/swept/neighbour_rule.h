// Rules: what is asked of single neighbours, or of groups of them, where it is not the common
// distance. One concept for checks of clearance and for searches for a path (docs/clearance.md,
// "Rules").
// In:    texts "NAME=RULE". Out: a rule for each neighbour. Units: mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace swept {

/// At most one of the three is set; none: the common required distance holds.
struct NeighbourRule {
  /// mm that this neighbour asks for.
  std::optional<double> required = {};
  /// The neighbour may be touched at any time (bolted faces, bearings, guides), and no distance is
  /// asked for. The solids may overlap by so many mm at most; less than tolerance + chord errors,
  /// which cannot be told from touching, means these.
  std::optional<double> contact = {};
  bool ignored = false;  ///< not looked at
};

/// "3" (mm), "contact", "contact:0.2" (mm), "ignore"; "" where nothing is set.
std::string ruleText(const NeighbourRule& rule);
/// The rule that such a text stands for. Throws Error(InvalidInput, "BadRule").
NeighbourRule parseRule(const std::string& text);
/// Throws Error(InvalidInput, "BadRule") where a rule contradicts itself or has an impossible
/// length; `who`: whose rule, for the message.
void checkRule(const NeighbourRule& rule, const std::string& who);

/// A rule for the neighbours whose names match: * stands for any letters, ? for one.
struct NamedRule {
  std::string pattern;
  NeighbourRule rule = {};
};

/// "NAME=RULE", split at the last "=". Throws Error(InvalidInput, "BadRule").
NamedRule parseNamedRule(const std::string& text);
/// Rules of neighbours with these names. A name as it is written comes before patterns. Throws
/// Error(InvalidInput, "BadRule") where a rule names no neighbour, or two contradict each other.
std::vector<NeighbourRule> rulesFor(const std::vector<std::string>& names,
                                    const std::vector<NamedRule>& rules);

}  // namespace swept
