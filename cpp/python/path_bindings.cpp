// Installation paths for Python: reports as dicts, motions as arrays.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_bindings.h"

#ifdef HAVE_SWEPT_CLEARANCE
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "clearance_bindings.h"
#include "errors.h"
#include "job.h"
#include "swept/io.h"
#include "swept/path.h"
#include "values.h"

namespace swept::python {
namespace {

constexpr const char* kFindPathDoc =
    R"(find_path(vertices, triangles, goal, neighbours, start=None, extract=None, via=(), clearance=0.0,
          release=0.0, translation_only=False, max_angle=None, interpolation='linear', tolerance=0.01,
          body_chord=0.0, budget=60.0, seed=1, run=None) -> (dict, motion or None)

A motion that brings the part to its goal and keeps the clearance from every neighbour, between its keys
as well. goal, start, via: arrays (4, 4). extract, instead of a start: a radius in mm, or a direction
(x, y, z). neighbours: as for clearance(). Lengths in mm, max_angle in rad, budget in s. Returns the
report (docs/paths.md) and (times, quaternions, translations), or None where none was found. Raises
InvalidInput (GoalBlocked, StartBlocked, ...), Cancelled.)";

Pose poseFrom(const py::handle& value, const char* name) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array || array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throw py::value_error(std::string(name) + " must be an array of shape (4, 4)");
  return poseFromMatrix(array.data(), 0, 0);
}

Extraction extractionFrom(const py::object& value) {
  Extraction extraction;
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
    extraction.radius = value.cast<double>();
    return extraction;
  }
  const auto d = value.cast<std::vector<double>>();
  if (d.size() != 3) throw py::value_error("extract is a radius or a direction (x, y, z)");
  extraction.direction = Eigen::Vector3d(d[0], d[1], d[2]);
  return extraction;
}

py::tuple pyFindPath(const py::object& vertices, const py::object& triangles,
                     const py::object& goal, const py::iterable& neighbours,
                     const py::object& start, const py::object& extract, const py::iterable& via,
                     double clearance, double release, bool translationOnly,
                     const std::optional<double>& maxAngle, const std::string& interpolation,
                     double tolerance, double bodyChord, double budget, std::uint64_t seed,
                     const py::object& run) {
  const RunPointer context = runFromObject(run);
  const TriMesh part = meshFromArrays(vertices, triangles);
  PathTask task;
  task.goal = poseFrom(goal, "goal");
  if (!start.is_none()) task.start = poseFrom(start, "start");
  if (!extract.is_none()) task.extraction = extractionFrom(extract);
  for (const py::handle& item : via) task.via.push_back(poseFrom(item, "via"));
  std::vector<PathNeighbour> parts;
  for (const py::handle& item : neighbours) parts.push_back({neighbourFrom(item), {}});
  PathOptions options;
  options.clearance = clearance;
  options.tolerance = tolerance;
  options.bodyChordError = bodyChord;
  options.release = release;
  options.translationOnly = translationOnly;
  options.largestTurn = maxAngle;
  options.interpolation = parseInterpolation(interpolation);
  options.budgetSeconds = budget;
  options.seed = seed;
  const PathReport report =
      runWithoutLock(*context, [&] { return findPath(part, task, parts, options, *context); });
  const py::object found = parseJson(toJson(report));
  if (report.status != Status::Ok) raise(report.status, report.code, report.message, found);
  if (report.verdict != PathVerdict::Found) return py::make_tuple(found, py::none());
  return py::make_tuple(found, trajectoryToArrays(report.path));
}

}  // namespace

void bindPath(py::module_& module) {
  module.def("find_path", &pyFindPath, kFindPathDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("goal"), py::arg("neighbours"), py::arg("start") = py::none(),
             py::arg("extract") = py::none(), py::arg("via") = py::tuple(),
             py::arg("clearance") = 0.0, py::arg("release") = 0.0,
             py::arg("translation_only") = false, py::arg("max_angle") = py::none(),
             py::arg("interpolation") = "linear", py::arg("tolerance") = 0.01,
             py::arg("body_chord") = 0.0, py::arg("budget") = 60.0, py::arg("seed") = 1,
             py::arg("run") = py::none());
}

}  // namespace swept::python
#endif  // HAVE_SWEPT_CLEARANCE
