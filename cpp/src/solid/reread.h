// Whether a solid that was read back is the one that was to be written.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "solid/mesh/half_edge.h"
#include "swept/solid.h"

namespace swept {

/// Says what is wrong with a solid that was read back: it is not sound, it has other numbers of
/// solids and shells than the mesh, or another volume, or, where surfaces were recognised, the
/// tolerance (mm) of an edge or vertex is larger than the solid's. Empty where nothing is wrong.
std::string rereadComplaint(const SolidCheck& read, const step::HalfEdgeMesh& mesh,
                            const StepOptions& options);

}  // namespace swept
