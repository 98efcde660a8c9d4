// Clearance checks for Python. Built only together with the clearance part of the core.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "swept/clearance.h"

namespace swept::python {

/// Converts neighbours. Each item is (name, vertices, triangles), optionally followed by the chord
/// error (mm) and then by the rule: a number (mm), a text or None. `rules`: texts "NAME=RULE" for
/// items without their own rule. Throws Error(InvalidInput, "BadRule").
std::vector<ClearanceNeighbour> neighboursFrom(const pybind11::iterable& items,
                                               const std::vector<std::string>& rules);

void bindClearance(pybind11::module_& module);

}  // namespace swept::python
