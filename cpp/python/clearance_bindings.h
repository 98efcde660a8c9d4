// Clearance for Python; only where the clearance part is built.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "swept/clearance.h"

namespace swept::python {

/// From (name, vertices, triangles), the chord error in mm, the rule: a number (mm), a text or
/// None. `rules`: "NAME=RULE" for those without a rule of their own. Throws Error(InvalidInput,
/// "BadRule").
std::vector<ClearanceNeighbour> neighboursFrom(const pybind11::iterable& items,
                                               const std::vector<std::string>& rules);

void bindClearance(pybind11::module_& module);

}  // namespace swept::python
