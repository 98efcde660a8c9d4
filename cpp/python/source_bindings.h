// The sources of the triangles of an envelope, as numpy arrays with one row for each triangle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace swept::python {

void bindSources(pybind11::module_& module);

}  // namespace swept::python
