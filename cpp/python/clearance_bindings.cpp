// Clearance for Python: reports as dicts, distances as arrays.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance_bindings.h"

#ifdef HAVE_SWEPT_CLEARANCE
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "errors.h"
#include "job.h"
#include "swept/clearance.h"
#include "values.h"

namespace swept::python {
namespace {

constexpr const char* kClearanceDoc =
    R"(clearance(vertices, triangles, motion, neighbours, interpolation='linear', required=0.0,
          tolerance=0.01, body_chord=0.0, interval_tolerance=0.0, curve=200, penetration=True,
          run=None) -> dict

Smallest distance of a moving body to each neighbour over the whole motion; nothing between two poses is
missed. neighbours: list of (name, vertices, triangles) or (name, vertices, triangles, chord error).
Lengths in mm; motion as in compute(). Returns the report: summary, neighbours (verdict clear | below |
contact | clash, distance, guaranteed, time_seconds, pose, points, penetration, below and contact as
time intervals, curve), as docs/clearance.md says. Raises InvalidInput, Cancelled.)";

constexpr const char* kDistanceDoc =
    R"(distance_to_mesh(points, vertices, triangles, run=None) -> float64 (N,)

Distance of each point (N, 3) to a mesh, mm; negative inside if the mesh is closed.)";

py::object pyClearance(const py::object& vertices, const py::object& triangles,
                       const py::object& motion, const py::iterable& neighbours,
                       const std::string& interpolation, double required, double tolerance,
                       double bodyChord, double intervalTolerance, int curve, bool penetration,
                       const py::object& run) {
  const RunPointer context = runFromObject(run);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  std::vector<ClearanceNeighbour> parts;
  for (const py::handle& item : neighbours) parts.push_back(neighbourFrom(item));
  ClearanceOptions options;
  options.required = required;
  options.tolerance = tolerance;
  options.bodyChordError = bodyChord;
  options.intervalTolerance = intervalTolerance;
  options.curveSamples = curve;
  options.penetration = penetration;
  const ClearanceReport report = runWithoutLock(
      *context, [&] { return checkClearance(body, trajectory, parts, options, *context); });
  const py::object found = parseJson(toJson(report));
  if (report.status != Status::Ok) raise(report.status, report.code, report.message, found);
  return found;
}

py::array pyDistanceToMesh(const py::object& points, const py::object& vertices,
                           const py::object& triangles, const py::object& run) {
  const RunPointer context = runFromObject(run);
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(points);
  if (!array || array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error("points must be an array of shape (N, 3)");
  std::vector<Eigen::Vector3d> list(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    list[i] = {array.at(i, 0), array.at(i, 1), array.at(i, 2)};
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const std::vector<double> distances =
      runWithoutLock(*context, [&] { return distanceToMesh(list, mesh, *context); });
  return py::array_t<double>(static_cast<py::ssize_t>(distances.size()), distances.data());
}

}  // namespace

ClearanceNeighbour neighbourFrom(const py::handle& item) {
  const py::tuple parts = py::reinterpret_borrow<py::object>(item).cast<py::tuple>();
  if (parts.size() != 3 && parts.size() != 4)
    throw py::value_error(
        "a neighbour is (name, vertices, triangles) or one more: its chord error");
  return {parts[0].cast<std::string>(), meshFromArrays(parts[1], parts[2]),
          parts.size() == 4 ? parts[3].cast<double>() : 0.0};
}

void bindClearance(py::module_& module) {
  module.def("clearance", &pyClearance, kClearanceDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("neighbours"), py::arg("interpolation") = "linear",
             py::arg("required") = 0.0, py::arg("tolerance") = 0.01, py::arg("body_chord") = 0.0,
             py::arg("interval_tolerance") = 0.0, py::arg("curve") = 200,
             py::arg("penetration") = true, py::arg("run") = py::none());
  module.def("distance_to_mesh", &pyDistanceToMesh, kDistanceDoc, py::arg("points"),
             py::arg("vertices"), py::arg("triangles"), py::arg("run") = py::none());
}

}  // namespace swept::python
#endif  // HAVE_SWEPT_CLEARANCE
