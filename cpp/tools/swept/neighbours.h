// Reads the parts that stand still from their files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "swept/clearance.h"

namespace swept::cli {

struct NeighbourFiles {
  std::vector<std::string> paths;
  double millimetresPerUnit = 1;  ///< for mesh files
  double chordError = 0;          ///< mm, for mesh files
  double deflection = 0.05;       ///< mm, tolerance of the triangles of solids
  std::vector<NamedRule> rules;
  std::string rulesPath;
};

/// Adds NEIGHBOUR, --neighbour-unit, --neighbour-chord and --deflection. Returns NEIGHBOUR.
CLI::Option* addNeighbourOptions(CLI::App& app, NeighbourFiles& files);
/// Adds --rule and --rules.
void addRuleOptions(CLI::App& app, NeighbourFiles& files);
/// Throws the error for wrong usage. moving: the file of the moving part, which must not be among
/// the neighbours; "" switches this check off (several moving parts, or a part placed elsewhere
/// than in its file).
void checkNeighbourOptions(const NeighbourFiles& files, const std::string& moving);
/// Reads the neighbours with their rules: a mesh file is one neighbour, and each solid of a solid
/// file is one. Throws Error(InvalidInput), with code "BadRule" if rules do not fit, and
/// Error(Cancelled).
std::vector<ClearanceNeighbour> readNeighbours(const NeighbourFiles& files, RunContext& run);

/// Numbers the parts that have the same name, as solids of one file may have.
void makeNamesUnique(std::vector<ClearanceNeighbour>& parts);

/// Returns a text in double quotes, for a CSV table.
std::string quoted(const std::string& text);

}  // namespace swept::cli
