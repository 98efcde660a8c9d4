// SPDX-License-Identifier: LGPL-2.1-or-later
#include "source_bindings.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "docstrings.h"
#include "swept/sources.h"

namespace swept::python {
namespace {

namespace py = pybind11;

/// Returns an array with `width` numbers for each triangle. take(row, to) writes the numbers for a
/// triangle with a known source. For the other triangles, all numbers are `none`.
template <class T, class Take>
py::array_t<T> byTriangle(const Sources& sources, py::ssize_t width, T none, const Take& take) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(sources.of.size())};
  if (width > 1) shape.push_back(width);
  py::array_t<T> array(shape);
  T* to = array.mutable_data();
  const py::gil_scoped_release release;
  for (const std::uint32_t row : sources.of) {
    if (row == Sources::kNone)
      std::fill_n(to, width, none);
    else
      take((*sources.rows)[row], to);
    to += width;
  }
  return array;
}

}  // namespace

void bindSources(py::module_& module) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  py::class_<Sources, std::shared_ptr<Sources>>(module, "Sources", kSourcesDoc)
      .def_property_readonly_static(
          "KINDS",
          [](const py::object&) {
            return py::make_tuple(sourceKindName(SourceKind::Cap), sourceKindName(SourceKind::Edge),
                                  sourceKindName(SourceKind::Graze));
          },
          "Names of the kinds: KINDS[k] is the name of kind k.")
      .def("__len__", [](const Sources& sources) { return sources.of.size(); })
      .def_property_readonly(
          "kind",
          [](const Sources& sources) {
            return byTriangle<std::int8_t>(sources, 1, -1,
                                           [](const SurfaceSource& row, std::int8_t* to) {
                                             *to = static_cast<std::int8_t>(row.kind);
                                           });
          },
          "int8 (M,): kind of the source: 0 cap, 1 edge, 2 graze, -1 unknown.")
      .def_property_readonly(
          "faces",
          [](const Sources& sources) {
            return byTriangle<std::int32_t>(sources, 2, -1,
                                            [](const SurfaceSource& row, std::int32_t* to) {
                                              std::copy_n(row.faces.data(), 2, to);
                                            });
          },
          "int32 (M, 2): for a cap, (face, -1). For an edge, the indices of its two faces, the "
          "lower one first (or (face, -1) at an open edge). For a graze, (face, -1), or the two "
          "faces that meet smoothly.")
      .def_property_readonly(
          "step",
          [](const Sources& sources) {
            return byTriangle<std::int32_t>(
                sources, 1, -1, [](const SurfaceSource& row, std::int32_t* to) { *to = row.step; });
          },
          "int32 (M,): index (from 0) of the pose of a cap, or of the pose at which the motion "
          "step of an edge or graze begins. -1: unknown.")
      .def_property_readonly(
          "time",
          [](const Sources& sources) {
            return byTriangle<double>(sources, 1, kNan, [](const SurfaceSource& row, double* to) {
              *to = row.timeSeconds;
            });
          },
          "float64 (M,): time (s) at which the face or edge was at `point`. nan: unknown.")
      .def_property_readonly(
          "point",
          [](const Sources& sources) {
            return byTriangle<double>(sources, 3, kNan, [](const SurfaceSource& row, double* to) {
              std::copy_n(row.point.data(), 3, to);
            });
          },
          "float64 (M, 3): a point (mm) of the exact surface near the triangle. The face or edge "
          "is at this point at `time`. nan: unknown.");
}

}  // namespace swept::python
