// The parts that stand still, from their files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/clearance.h"

namespace swept::cli {

struct NeighbourFileOptions {
  double millimetresPerUnit = 1;  ///< of meshes
  double chordError = 0;          ///< mm, of meshes
  double deflection = 0.05;       ///< mm, to which solids are tessellated
};

/// A mesh is one neighbour, a solid file one a solid. Throws Error(InvalidInput), Error(Cancelled).
std::vector<ClearanceNeighbour> readNeighbours(const std::vector<std::string>& paths,
                                               const NeighbourFileOptions& options,
                                               RunContext& run);

}  // namespace swept::cli
