// The parts that stand still, from their files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "swept/clearance.h"

namespace swept::cli {

struct NeighbourFiles {
  std::vector<std::string> paths;
  double millimetresPerUnit = 1;  ///< of meshes
  double chordError = 0;          ///< mm, of meshes
  double deflection = 0.05;       ///< mm, to which solids are tessellated
  std::vector<NamedRule> rules;
  std::string rulesPath;
};

/// NEIGHBOUR (the option that is returned), --neighbour-unit, --neighbour-chord and --deflection.
CLI::Option* addNeighbourOptions(CLI::App& app, NeighbourFiles& files);
/// --rule and --rules.
void addRuleOptions(CLI::App& app, NeighbourFiles& files);
/// Throws what a wrong usage is; moving: the file of the part that moves, which is no neighbour of
/// itself ("": there are several, or it is placed where its file does not have it).
void checkNeighbourOptions(const NeighbourFiles& files, const std::string& moving);
/// A mesh is one neighbour, a solid file one a solid; each with its rule. Throws
/// Error(InvalidInput), "BadRule" where rules do not fit; Error(Cancelled).
std::vector<ClearanceNeighbour> readNeighbours(const NeighbourFiles& files, RunContext& run);

/// Gives parts of one name, as solids of one file may have, a number each.
void makeNamesUnique(std::vector<ClearanceNeighbour>& parts);

/// In double quotes, for a table of values with commas between them.
std::string quoted(const std::string& text);

}  // namespace swept::cli
