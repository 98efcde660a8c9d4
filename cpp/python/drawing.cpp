// SPDX-License-Identifier: LGPL-2.1-or-later
#include "drawing.h"

#include <algorithm>

#include "arrays.h"
#include "io/freecad_mesh.h"
#include "swept/drawable.h"

namespace swept::python {
namespace {

constexpr const char* kDrawableDoc =
    R"(drawable(vertices, triangles, most=100000, crease=0.6) -> (points, normals, indices)

Converts a mesh for display in a 3D view. Returns points and unit normals, float32 (N, 3), and indices,
int32 (4 M,): three points and -1 for each triangle. Points are duplicated along edges where the surface
turns by more than crease (rad). A mesh of more than about `most` triangles is simplified for display.)";

constexpr const char* kMeshFileDoc =
    R"(freecad_mesh(vertices, triangles) -> bytes

Returns the content of a FreeCAD mesh file (.bms), with coordinates in single precision and the neighbours of
each triangle.)";

py::tuple pyDrawable(const py::object& vertices, const py::object& triangles, std::size_t most,
                     double crease) {
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const auto made = std::make_shared<Drawable>(
      withoutLock([&] { return drawableOf(mesh, std::max<std::size_t>(most, 1), crease); }));
  const auto count = static_cast<py::ssize_t>(made->points.size());
  const auto* points = reinterpret_cast<const float*>(made->points.data());
  const auto* normals = reinterpret_cast<const float*>(made->normals.data());
  return py::make_tuple(
      readOnlyView(points, {count, 3}, made), readOnlyView(normals, {count, 3}, made),
      readOnlyView(made->indices.data(), {static_cast<py::ssize_t>(made->indices.size())}, made));
}

py::bytes pyMeshFile(const py::object& vertices, const py::object& triangles) {
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  return withoutLock([&] { return freecadMesh(mesh); });
}

}  // namespace

void bindDrawing(py::module_& module) {
  module.def("drawable", &pyDrawable, kDrawableDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("most") = 100000, py::arg("crease") = 0.6);
  module.def("freecad_mesh", &pyMeshFile, kMeshFileDoc, py::arg("vertices"), py::arg("triangles"));
}

}  // namespace swept::python
