// SPDX-License-Identifier: LGPL-2.1-or-later
#include "errors.h"

#include <array>
#include <new>

namespace swept::python {
namespace {

namespace py = pybind11;

constexpr int kStatusCount = static_cast<int>(Status::InternalError) + 1;

// Returns the exception classes, by status. They are never released, because exceptions may be
// raised until the interpreter ends.
std::array<PyObject*, kStatusCount>& classes() {
  static std::array<PyObject*, kStatusCount> table{};
  return table;
}

PyObject* newClass(py::module_& module, const std::string& name, const char* doc,
                   const py::tuple& bases) {
  PyObject* created =
      PyErr_NewExceptionWithDoc(("_swept." + name).c_str(), doc, bases.ptr(), nullptr);
  if (created == nullptr) throw py::error_already_set();
  module.attr(name.c_str()) = py::handle(created);
  return created;
}

void set(Status status, const std::string& code, const std::string& message,
         const py::object& report) {
  const py::handle type(classes()[static_cast<std::size_t>(status)]);
  const py::object error = type(py::str(message));
  error.attr("status") = statusName(status);
  error.attr("code") = code;
  error.attr("report") = report;
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

void raise(Status status, const std::string& code, const std::string& message,
           const py::object& report) {
  set(status, code, message, report);
  throw py::error_already_set();
}

void bindErrors(py::module_& module) {
  const py::handle base =
      newClass(module, "Error",
               "Raised if a run gives no result. status: InvalidInput, ResourceLimit, ...; code: "
               "what was found, such as NonFiniteVertex; report: the report of the run as a dict, "
               "or None if it has no report.",
               py::make_tuple(py::handle(PyExc_RuntimeError)));
  classes()[0] = base.ptr();
  for (int i = 1; i < kStatusCount; ++i) {
    const auto status = static_cast<Status>(i);
    const py::tuple bases = status == Status::InvalidInput
                                ? py::tuple(py::make_tuple(base, py::handle(PyExc_ValueError)))
                                : py::tuple(py::make_tuple(base));
    classes()[static_cast<std::size_t>(i)] =
        newClass(module, statusName(status), "See Error.", bases);
  }
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const Error& error) {
      set(error.status(), error.code(), error.what(), py::none());
    } catch (const std::bad_alloc&) {
      set(Status::OutOfMemory, "OutOfMemory", "memory ran out", py::none());
    }
  });
}

}  // namespace swept::python
