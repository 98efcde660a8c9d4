// Whether a solid that was read back is the one that was to be written.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "solid/mesh/half_edge.h"
#include "swept/solid.h"

namespace swept {

/// What is wrong with what was read: not sound, other numbers of solids and shells than the mesh
/// has, another volume, or, in a solid with recognised surfaces, an edge or vertex whose tolerance
/// (mm) is above the solid's. Empty: nothing.
std::string rereadComplaint(const SolidCheck& read, const step::HalfEdgeMesh& mesh,
                            const StepOptions& options);

}  // namespace swept
