// Converts numpy arrays to plain structs, and back.
// In:   arrays of any layout and type that can be converted without loss. Their shapes are checked.
// Out:  copies for the core, which runs without the interpreter lock; for Python, read-only views
//       that keep the memory of the result alive.
// Throws py::value_error for wrong shapes, py::type_error for wrong types, and Error(InvalidInput)
// for bad content.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "swept/types.h"

namespace swept::python {

namespace py = pybind11;

TriMesh meshFromArrays(const py::object& vertices, const py::object& triangles);
/// Converts an integer array (M,) to the form of TriMesh::faceOf.
std::vector<std::int32_t> facesFromArray(const py::object& faces);

/// Converts a motion: (times, quaternions, translations), these three followed by a pivot, (times,
/// matrices), or matrices (K, 4, 4).
Trajectory trajectoryFromObject(const py::object& motion, const std::string& interpolation);
py::tuple trajectoryToArrays(const Trajectory& trajectory);

/// Converts str, bytes or os.PathLike to UTF-8.
std::string pathFromObject(const py::object& path);

/// Converts a sequence of `size` objects. Throws py::value_error(what) if it has another size.
py::tuple tupleOf(const py::handle& item, std::size_t size, const char* what);

/// Parses JSON text to a dict.
py::object parseJson(const std::string& text);

/// Returns a read-only array over memory that `owner` keeps alive.
template <class T>
py::array readOnlyView(const T* data, std::vector<py::ssize_t> shape,
                       const std::shared_ptr<const void>& owner) {
  using Owner = std::shared_ptr<const void>;
  const py::capsule base(new Owner(owner), [](void* kept) { delete static_cast<Owner*>(kept); });
  py::array_t<T> view(std::move(shape), data, base);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

}  // namespace swept::python
