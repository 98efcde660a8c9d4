// Rules for single neighbours or for groups of neighbours. A rule replaces the common required
// distance. Clearance checks and searches for paths use the same rules (docs/clearance.md,
// "Rules").
// In:    texts "NAME=RULE".
// Out:   a rule for each neighbour. Units: mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace swept {

/// At most one of the three members is set. If none is set, the common required distance holds.
struct NeighbourRule {
  /// Required distance (mm) for this neighbour.
  std::optional<double> required = {};
  /// Set: contact with the neighbour is allowed at any time (bolted faces, bearings, guides), and
  /// no distance is required. The value is the depth (mm) by which the solids may overlap. The
  /// program cannot distinguish depths below tolerance + chord errors from touching; a smaller
  /// value counts as that sum.
  std::optional<double> contact = {};
  bool ignored = false;  ///< the neighbour is not checked
};

/// Returns "3" (mm), "contact", "contact:0.2" (mm), "ignore", or "" if nothing is set.
std::string ruleText(const NeighbourRule& rule);
/// Parses what ruleText() returns. Throws Error(InvalidInput, "BadRule").
NeighbourRule parseRule(const std::string& text);
/// Throws Error(InvalidInput, "BadRule") if a rule contradicts itself or has an impossible length.
/// `who`: the name that the message gives to the owner of the rule.
void checkRule(const NeighbourRule& rule, const std::string& who);

/// A rule for all neighbours whose names match. In the pattern, * stands for any characters, ? for
/// one.
struct NamedRule {
  std::string pattern;
  NeighbourRule rule = {};
};

/// Parses "NAME=RULE", split at the last "=". Throws Error(InvalidInput, "BadRule").
NamedRule parseNamedRule(const std::string& text);
/// Returns the rule of each of these neighbours. An exact name takes precedence over patterns.
/// Throws Error(InvalidInput, "BadRule") if a rule matches no neighbour, or two rules contradict
/// each other.
std::vector<NeighbourRule> rulesFor(const std::vector<std::string>& names,
                                    const std::vector<NamedRule>& rules);

}  // namespace swept
