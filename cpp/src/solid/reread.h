// Compares a solid that was read back from its file with the mesh from which it was made.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "solid/mesh/half_edge.h"
#include "swept/solid.h"

namespace swept {

/// Returns what is wrong with a solid that was read back; empty if nothing is wrong. The solid must
/// be valid. It must have the volume of the mesh and as many solids and shells as the mesh. If
/// surfaces were recognised, no edge or vertex may have a tolerance (mm) larger than that of the
/// options. `meshError`: mm, how far the mesh may lie off the solid, if that is more than the
/// tolerance.
std::string rereadComplaint(const SolidCheck& read, const step::HalfEdgeMesh& mesh,
                            const SolidOptions& options, double meshError = 0);

}  // namespace swept
