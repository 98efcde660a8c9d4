// Values that several parts of the module return to Python (meshes without a copy) or receive
// (runs).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "arrays.h"
#include "base/unless_zero.h"
#include "swept/body.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::python {

namespace py = pybind11;

using RunPointer = std::shared_ptr<RunContext>;

/// A mesh whose arrays Python can read without a copy.
struct Mesh {
  std::shared_ptr<const TriMesh> data;
  double chordError = 0;  ///< mm, for a solid: how far the triangles deviate from its surface
  py::list findings = py::list();            ///< findings from reading the file
  std::shared_ptr<const BodyShape> shape{};  ///< faces and edges of a solid; null: a mesh file

  py::array vertices() const {
    return readOnlyView(reinterpret_cast<const double*>(data->vertices.data()),
                        {static_cast<py::ssize_t>(data->vertices.size()), 3}, data);
  }
  py::array triangles() const {
    return readOnlyView(reinterpret_cast<const std::int32_t*>(data->triangles.data()),
                        {static_cast<py::ssize_t>(data->triangles.size()), 3}, data);
  }
};

/// Returns the face of each triangle as an int32 array (M,), or None if the faces are not known.
inline py::object facesOf(const Mesh& mesh) {
  if (mesh.data->faceOf.empty()) return py::none();
  return readOnlyView(mesh.data->faceOf.data(),
                      {static_cast<py::ssize_t>(mesh.data->faceOf.size())}, mesh.data);
}

inline RunPointer runFromObject(const py::object& run) {
  return run.is_none() ? std::make_shared<RunContext>() : run.cast<RunPointer>();
}

}  // namespace swept::python
