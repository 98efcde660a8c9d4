// Python functions for meshes in 3D views and in FreeCAD's mesh files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace swept::python {

void bindDrawing(pybind11::module_& module);

}  // namespace swept::python
