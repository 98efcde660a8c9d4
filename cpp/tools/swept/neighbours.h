// Command-line options for the neighbours (the parts that stand still), and reading of their files.
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

/// Adds NEIGHBOUR, --neighbour-unit, --neighbour-chord and --deflection. Returns the option
/// NEIGHBOUR.
CLI::Option* addNeighbourOptions(CLI::App& app, NeighbourFiles& files);
/// Adds --rule and --rules.
void addRuleOptions(CLI::App& app, NeighbourFiles& files);
/// Throws an error for wrong usage. `moving`: the file of the moving part, which must not be among
/// the neighbours; "" leaves out this check. Commands with no moving part or with several pass "".
/// So does `swept path`: at its goal, the part need not be where its file places it, so the same
/// file may also be a neighbour.
void checkNeighbourOptions(const NeighbourFiles& files, const std::string& moving);
/// Reads the neighbours with their rules. A mesh is one neighbour; each solid of a solid file is
/// one. Throws Error(InvalidInput), with "BadRule" if a rule matches no neighbour or contradicts
/// another; Error(Cancelled).
std::vector<ClearanceNeighbour> readNeighbours(const NeighbourFiles& files, RunContext& run);

/// Appends numbers to names that occur several times, such as those of solids of one file.
void makeNamesUnique(std::vector<ClearanceNeighbour>& parts);

/// Returns the text in double quotes, as a field of a CSV table.
std::string quoted(const std::string& text);

}  // namespace swept::cli
