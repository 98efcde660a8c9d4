// HTML pages (swept/page.h) for Python. Reports are texts; meshes of parts are arrays.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace swept::python {

void bindPage(pybind11::module_& module);

}  // namespace swept::python
