// Clearance for Python; only where the clearance part is built.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "swept/clearance.h"

namespace swept::python {

/// From (name, vertices, triangles) or one more: the chord error in mm.
ClearanceNeighbour neighbourFrom(const pybind11::handle& item);

void bindClearance(pybind11::module_& module);

}  // namespace swept::python
