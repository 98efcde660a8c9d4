// Python functions that read and write meshes, motions and solids.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace swept::python {

void bindFiles(pybind11::module_& module);

}  // namespace swept::python
