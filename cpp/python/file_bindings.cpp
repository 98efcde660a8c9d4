// SPDX-License-Identifier: LGPL-2.1-or-later
#include "file_bindings.h"

#include <pybind11/stl.h>

#include <optional>

#include "docstrings.h"
#include "errors.h"
#include "job.h"
#include "readers.h"
#include "swept/body.h"
#include "swept/io.h"
#include "swept/solid.h"
#include "values.h"

namespace swept::python {
namespace {

py::list findingsToList(const std::vector<Finding>& findings) {
  py::list list;
  for (const Finding& finding : findings) {
    py::dict item;
    item["code"] = finding.code;
    item["count"] = finding.count;
    item["first"] = py::cast(finding.first);
    item["text"] = finding.text;
    list.append(item);
  }
  return list;
}

Mesh pyReadMesh(const py::object& path, const std::string& unit) {
  const std::string name = pathFromObject(path);
  const double scale = parseLengthUnit(unit);
  TriMesh mesh = withoutLock([&] { return readMesh(name, scale); });
  return {std::make_shared<const TriMesh>(std::move(mesh)), 0, py::list()};
}

Mesh pyReadBody(const py::object& path, const std::string& unit,
                const std::optional<double>& tolerance, const std::optional<double>& cell,
                int resolution, const py::object& run, double angle, const py::object& reader) {
  const RunPointer context = runFromObject(run);
  const std::string name = pathFromObject(path);
  const BodyFileOptions options{parseLengthUnit(unit), tolerance, cell, resolution, angle};
  std::optional<PythonSolidReader> caller;
  if (!reader.is_none()) caller.emplace(py::cast<py::function>(reader));
  Body body = runWithoutLock(*context, [&] {
    return caller ? readBody(name, options, *caller, *context) : readBody(name, options, *context);
  });
  return {std::make_shared<const TriMesh>(std::move(body.mesh)), body.chordError,
          findingsToList(body.findings), std::move(body.shape)};
}

/// The faces and edges of a solid, opaque for Python.
struct Shape {
  std::shared_ptr<const BodyShape> data;
};

py::object shapeOf(const Mesh& mesh) {
  return mesh.shape == nullptr ? py::none() : py::cast(Shape{mesh.shape});
}

Shape pyReadBodyShape(const py::object& path, const py::object& run) {
  const RunPointer context = runFromObject(run);
  const std::string name = pathFromObject(path);
  return {runWithoutLock(*context, [&] { return readBodyShape(name, *context); })};
}

/// Returns (name, mesh) for each part.
py::list pyReadParts(const py::object& path, const std::string& unit, double chordError,
                     double deflection, const py::object& run, const py::object& reader) {
  const RunPointer context = runFromObject(run);
  const std::string name = pathFromObject(path);
  const PartFileOptions options{parseLengthUnit(unit), chordError, deflection};
  std::optional<PythonSolidReader> caller;
  if (!reader.is_none()) caller.emplace(py::cast<py::function>(reader));
  std::vector<NamedPart> parts = runWithoutLock(*context, [&] {
    return caller ? readParts(name, options, *caller, *context)
                  : readParts(name, options, *context);
  });
  py::list list;
  for (NamedPart& part : parts) {
    const auto mesh = std::make_shared<const TriMesh>(std::move(part.mesh));
    list.append(py::make_tuple(part.name, Mesh{mesh, part.chordError, py::list()}));
  }
  return list;
}

void pyWriteMesh(const py::object& path, const py::object& vertices, const py::object& triangles,
                 bool noClobber) {
  const std::string name = pathFromObject(path);
  if (noClobber) requireAbsent("the file", name);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const py::gil_scoped_release release;
  writeMesh(mesh, name);
}

py::tuple pyReadTrajectory(const py::object& path, const std::string& unit) {
  const std::string name = pathFromObject(path);
  const double scale = parseLengthUnit(unit);
  return trajectoryToArrays(
      withoutLock([&] { return readTrajectoryCsv(name, scale, Interpolation::None); }));
}

/// Returns the quaternions and translations nearest to the given rigid matrices.
py::tuple pyPosesFromMatrices(const py::object& times, const py::object& matrices) {
  return trajectoryToArrays(trajectoryFromObject(py::make_tuple(times, matrices), "none"));
}

/// Converts the argument `origin`: (motion, interpolation, shape).
std::shared_ptr<const SolidOrigin> originFromObject(const py::object& given) {
  if (given.is_none()) return nullptr;
  const auto parts = py::cast<py::tuple>(given);
  SolidOrigin origin;
  origin.trajectory = trajectoryFromObject(parts[0], py::cast<std::string>(parts[1]));
  origin.shape = py::cast<Shape>(parts[2]).data;
  return std::make_shared<const SolidOrigin>(std::move(origin));
}

SolidOptions solidOptions(const py::dict& keywords) {
  SolidOptions options;
  for (const auto& [key, value] : keywords) {
    const std::string name = py::cast<std::string>(key);
    if (name == "merge_coplanar") {
      options.mergeCoplanar = py::cast<bool>(value);
    } else if (name == "planar_tolerance") {
      options.planarTolerance = py::cast<double>(value);
    } else if (name == "tolerance") {
      options.tolerance = py::cast<double>(value);
    } else if (name == "exact") {
      options.exact = py::cast<bool>(value);
    } else if (name == "strict") {
      options.strict = py::cast<bool>(value);
    } else if (name == "recognise") {
      options.recognise = py::cast<bool>(value);
    } else if (name == "origin") {
      options.origin = originFromObject(py::reinterpret_borrow<py::object>(value));
    } else if (name == "max_faces") {
      options.maxFaces = py::cast<std::int64_t>(value);
    } else if (name == "max_megabytes") {
      options.maxMegabytes = unlessZero(py::cast<std::optional<double>>(value));
    } else if (name == "product_name") {
      options.productName = py::cast<std::string>(value);
    } else if (name == "schema") {
      options.schema = parseStepSchema(py::cast<std::string>(value));
    } else if (name == "author") {
      options.author = py::cast<std::string>(value);
    } else if (name == "organization") {
      options.organization = py::cast<std::string>(value);
    } else if (name == "colour") {
      options.colour = py::cast<std::array<double, 3>>(value);
    } else {
      throw Error(Status::InvalidInput, "BadOption",
                  "unknown option '" + name + "'; see help(_swept.write_solid)");
    }
  }
  return options;
}

/// Writes a solid. The `reader` of the caller checks the written file or, if `reader` is None, the
/// OpenCASCADE of this module does.
WrittenSolid writeWith(const py::object& reader, const TriMesh& mesh, const std::string& name,
                       const SolidOptions& options, RunContext& run) {
  if (!reader.is_none()) {
    PythonStepReader checker(py::cast<py::function>(reader));
    return runWithoutLock(run, [&] { return writeSolid(mesh, name, options, checker, run); });
  }
  return runWithoutLock(run, [&] { return writeSolid(mesh, name, options, run); });
}

py::object pyWriteSolid(const py::object& path, const py::object& vertices,
                        const py::object& triangles, const py::object& run, bool noClobber,
                        const py::object& reader, const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const std::string name = pathFromObject(path);
  if (noClobber) requireAbsent("the file", name);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const SolidOptions options = solidOptions(keywords);
  const WrittenSolid report = writeWith(reader, mesh, name, options, *context);
  py::object result = parseJson(toJson(report));
  result["warnings"] = findingsToList(report.warnings);
  return result;
}

py::dict pyEstimateSolid(const py::object& vertices, const py::object& triangles,
                         const py::object& run, const std::string& format, bool quick,
                         const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const SolidOptions options = solidOptions(keywords);
  const SolidFormat kind = solidFormatOf("solid." + format);
  const SolidEstimate found = runWithoutLock(*context, [&] {
    return quick ? guessSolid(mesh, options, kind, *context)
                 : trySolid(mesh, options, kind, *context);
  });
  return parseJson(toJson(found));
}

}  // namespace

void bindFiles(py::module_& module) {
  py::class_<Shape>(module, "BodyShape", "The faces and edges of a solid, for write_solid().");
  py::class_<Mesh>(module, "Mesh", kMeshDoc)
      .def_property_readonly("vertices", &Mesh::vertices, "float64 (N, 3), mm, read-only")
      .def_property_readonly("triangles", &Mesh::triangles, "int32 (M, 3), read-only")
      .def_property_readonly("faces", &facesOf,
                             "int32 (M,), read-only: for each triangle, the index of its face of "
                             "the solid, in the order of the file. None for a mesh file.")
      .def_readonly(
          "chord_error", &Mesh::chordError,
          "How far (mm) the triangles of a solid may deviate from its surface. 0 for a mesh file.")
      .def_property_readonly("shape", &shapeOf, "BodyShape of a solid. None for a mesh file.")
      .def_readonly("findings", &Mesh::findings,
                    "Findings from reading a solid, in the form of the warnings of a report.");
  module.def("read_body_shape", &pyReadBodyShape,
             "Reads the faces and edges of a STEP or BREP file (mm), without triangles. Raises "
             "InvalidInput, Cancelled.",
             py::arg("path"), py::arg("run") = py::none());
  module.def("read_mesh", &pyReadMesh, kReadMeshDoc, py::arg("path"), py::arg("unit") = "mm");
  module.def("read_body", &pyReadBody, kReadBodyDoc, py::arg("path"), py::arg("unit") = "mm",
             py::arg("tolerance") = py::none(), py::arg("cell") = py::none(),
             py::arg("resolution") = 128, py::arg("run") = py::none(), py::arg("angle") = 0.2,
             py::arg("reader") = py::none());
  module.def("read_parts", &pyReadParts, kReadPartsDoc, py::arg("path"), py::arg("unit") = "mm",
             py::arg("chord_error") = 0.0, py::arg("deflection") = 0.05,
             py::arg("run") = py::none(), py::arg("reader") = py::none());
  module.def("write_mesh", &pyWriteMesh, kWriteMeshDoc, py::arg("path"), py::arg("vertices"),
             py::arg("triangles"), py::arg("no_clobber") = false);
  module.def("read_trajectory_csv", &pyReadTrajectory, kReadTrajectoryDoc, py::arg("path"),
             py::arg("unit") = "mm");
  module.def("poses_from_matrices", &pyPosesFromMatrices,
             "poses_from_matrices(times (K,), matrices (K, 4, 4)) -> (times, quaternions (K, 4), "
             "translations (K, 3))",
             py::arg("times"), py::arg("matrices"));
  module.def("write_solid", &pyWriteSolid, kWriteSolidDoc, py::arg("path"), py::arg("vertices"),
             py::arg("triangles"), py::arg("run") = py::none(), py::arg("no_clobber") = false,
             py::arg("reader") = py::none());
  module.def("estimate_solid", &pyEstimateSolid, kEstimateSolidDoc, py::arg("vertices"),
             py::arg("triangles"), py::arg("run") = py::none(), py::arg("format") = "step",
             py::arg("quick") = false);
#ifdef HAVE_SWEPT_SOLID
  module.attr("HAS_SOLIDS") = true;
#else
  module.attr("HAS_SOLIDS") = false;
#endif
}

}  // namespace swept::python
