// Pages (swept/page.h) for Python: reports as text, parts as arrays.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace swept::python {

void bindPage(pybind11::module_& module);

}  // namespace swept::python
