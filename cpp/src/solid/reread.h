// Compares a solid that was read back from its file with the mesh from which it was made.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "solid/mesh/half_edge.h"
#include "swept/solid.h"

namespace swept {

/// Returns what is wrong with the solid, or an empty text. The solid must be valid and have as many
/// solids and shells as the mesh. Its volume may differ by at most area times tolerance. If
/// surfaces were recognised, no edge or vertex may have a larger tolerance than the solid.
std::string rereadComplaint(const SolidCheck& read, const step::HalfEdgeMesh& mesh,
                            const StepOptions& options);

}  // namespace swept
