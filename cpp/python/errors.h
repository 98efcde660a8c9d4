// Python exceptions of the module: Error, and one subclass for each status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "arrays.h"
#include "swept/types.h"

namespace swept::python {

/// Creates the exception classes. Makes pybind11 translate swept::Error and std::bad_alloc to them.
void bindErrors(pybind11::module_& module);

/// Raises the class of `status` with .status, .code and .report (dict or None).
[[noreturn]] void raise(Status status, const std::string& code, const std::string& message,
                        const pybind11::object& report);

/// Returns the report of a successful run as a dict. Raises an error if the run failed.
template <class Report>
pybind11::object foundOf(const Report& report) {
  pybind11::object found = parseJson(toJson(report));
  if (report.status != Status::Ok) raise(report.status, report.code, report.message, found);
  return found;
}

}  // namespace swept::python
