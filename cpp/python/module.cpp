// The compiled module `_swept`: the core for Python, numpy in and out.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>

#include "arrays.h"
#include "clearance_bindings.h"
#include "docstrings.h"
#include "drawing.h"
#include "errors.h"
#include "job.h"
#include "path_bindings.h"
#include "priority.h"
#include "swept/body.h"
#include "swept/check_text.h"
#include "swept/compute.h"
#include "swept/io.h"
#include "swept/preview.h"
#ifdef HAVE_SWEPT_SOLID
#include "swept/solid.h"
#endif
#include "warm_memory.h"

#ifndef SWEPT_VERSION
#define SWEPT_VERSION "unknown"
#endif

namespace swept::python {
namespace {

using RunPointer = std::shared_ptr<RunContext>;

/// A mesh whose arrays Python looks at without copying.
struct Mesh {
  std::shared_ptr<const TriMesh> data;
  double chordError = 0;           ///< mm, of a tessellated solid
  py::list findings = py::list();  ///< of how it was read

  py::array vertices() const {
    return readOnlyView(reinterpret_cast<const double*>(data->vertices.data()),
                        {static_cast<py::ssize_t>(data->vertices.size()), 3}, data);
  }
  py::array triangles() const {
    return readOnlyView(reinterpret_cast<const std::int32_t*>(data->triangles.data()),
                        {static_cast<py::ssize_t>(data->triangles.size()), 3}, data);
  }
};

struct ComputeResult {
  std::shared_ptr<const Result> data;
  py::object report;

  Mesh mesh() const { return {std::shared_ptr<const TriMesh>(data, &data->mesh), 0, py::list()}; }
  py::array contactTime() const {
    return readOnlyView(data->contactTime.data(),
                        {static_cast<py::ssize_t>(data->contactTime.size())}, data);
  }
  py::array featureEdges() const {
    return readOnlyView(reinterpret_cast<const std::int32_t*>(data->featureEdges.data()),
                        {static_cast<py::ssize_t>(data->featureEdges.size()), 2}, data);
  }
};

std::uint64_t bytesFromMegabytes(double megabytes) {
  if (!(megabytes >= 0) || megabytes > 1e12) {
    throw Error(Status::InvalidInput, "BadOption",
                "memory_limit_mb must be 0 (default) or a positive number of MiB");
  }
  return static_cast<std::uint64_t>(megabytes * 1048576.0);
}

RunPointer runFromObject(const py::object& run) {
  return run.is_none() ? std::make_shared<RunContext>() : run.cast<RunPointer>();
}

// One option of compute() and estimate(); what is no number, name or flag is a TypeError, a whole
// number that no option could hold a BadOption.
template <class T>
T castOption(const std::string& name, const py::handle& value) {
  try {
    return value.cast<T>();
  } catch (const py::cast_error&) {
    if (PyLong_Check(value.ptr()) != 0) {
      throw Error(Status::InvalidInput, "BadOption",
                  "option " + name + " = " + py::repr(value).cast<std::string>() +
                      " is beyond what any option takes");
    }
    throw py::type_error("option " + name + " cannot be " + py::repr(value).cast<std::string>());
  }
}

void takeOption(const std::string& name, const py::handle& value, Options& options,
                RunContext& run) {
  if (name == "resolution")
    options.resolution = castOption<int>(name, value);
  else if (name == "cell")
    options.cellSize = castOption<double>(name, value);
  else if (name == "components")
    options.components = parseComponentMethod(castOption<std::string>(name, value));
  else if (name == "backend")
    options.backend = parseBackend(castOption<std::string>(name, value));
  else if (name == "keep_cavities")
    options.keepCavities = castOption<bool>(name, value);
  else if (name == "cull")
    options.cull = castOption<bool>(name, value);
  else if (name == "tolerance")
    options.tolerance = castOption<double>(name, value);
  else if (name == "offset")
    options.offset = castOption<double>(name, value);
  else if (name == "conservative")
    options.conservative = castOption<bool>(name, value);
  else if (name == "position_filter")
    options.positionFilter = castOption<double>(name, value);
  else if (name == "chord")
    options.chordTolerance = castOption<double>(name, value);
  else if (name == "weld")
    options.weldTolerance = castOption<double>(name, value);
  else if (name == "threads")
    run.threads = castOption<int>(name, value);
  else if (name == "memory_limit_mb")
    run.memoryLimitBytes = bytesFromMegabytes(castOption<double>(name, value));
  else
    throw py::type_error("unknown option '" + name + "'");
}

Options optionsFrom(const py::kwargs& keywords, RunContext& run) {
  Options options;
  for (const auto& [name, value] : keywords) {
    takeOption(name.cast<std::string>(), value, options, run);
  }
  return options;
}

ComputeResult resultOrRaise(const std::shared_ptr<const Result>& result) {
  const py::object report = parseJson(toJson(result->report));
  if (result->report.status != Status::Ok) {
    raise(result->report.status, result->report.code, result->report.message, report);
  }
  return {result, report};
}

ComputeResult pyCompute(const py::object& vertices, const py::object& triangles,
                        const py::object& motion, const std::string& interpolation,
                        const py::object& run, const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const Options options = optionsFrom(keywords, *context);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  auto result = std::make_shared<Result>(
      runWithoutLock(*context, [&] { return compute(body, trajectory, options, *context); }));
  return resultOrRaise(result);
}

ComputeResult pyRecut(const ComputeResult& from, double tolerance, const py::object& run) {
  const RunPointer context = runFromObject(run);
  auto result = std::make_shared<Result>();
  result->report = from.data->report;
  result->kept = from.data->kept;
  runWithoutLock(*context, [&] { recut(*result, tolerance, *context); });
  return resultOrRaise(result);
}

std::unique_ptr<PreviewSession> pyPreviewSession(const py::object& vertices,
                                                 const py::object& triangles,
                                                 const py::kwargs& keywords) {
  RunContext run;
  const Options options = optionsFrom(keywords, run);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const py::gil_scoped_release release;
  return std::make_unique<PreviewSession>(body, options, run);
}

ComputeResult pyPreview(PreviewSession& session, const py::object& motion,
                        const std::string& interpolation, const py::object& run, bool sketch) {
  const RunPointer context = runFromObject(run);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  return resultOrRaise(std::make_shared<Result>(runWithoutLock(*context, [&] {
    return sketch ? session.sketch(trajectory, *context) : session.compute(trajectory, *context);
  })));
}

py::dict pyEstimate(const py::object& vertices, const py::object& triangles,
                    const py::object& motion, const std::string& interpolation,
                    const py::kwargs& keywords) {
  RunContext run;
  const Options options = optionsFrom(keywords, run);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  const Estimate found = runWithoutLock(run, [&] { return estimate(body, trajectory, options); });
  py::dict result;
  result["grid"] = py::cast(found.grid);
  result["cell"] = found.cellSize;
  result["memory_bytes"] = found.memoryBytes;
  result["seconds"] = found.seconds;
  result["triangles"] = found.triangles;
  return result;
}

py::object pyCheckMesh(const py::object& vertices, const py::object& triangles,
                       const py::object& run) {
  const RunPointer context = runFromObject(run);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const MeshCheck check = runWithoutLock(*context, [&] { return checkMesh(mesh, *context); });
  return parseJson(toJson(check));
}

Mesh pyReadMesh(const py::object& path, const std::string& unit) {
  const std::string name = pathFromObject(path);
  const double scale = parseLengthUnit(unit);
  auto mesh = std::make_shared<TriMesh>();
  {
    const py::gil_scoped_release release;
    *mesh = readMesh(name, scale);
  }
  return {mesh, 0, py::list()};
}

Mesh pyReadBody(const py::object& path, const std::string& unit,
                const std::optional<double>& tolerance, const std::optional<double>& cell,
                int resolution, const py::object& run) {
  const RunPointer context = runFromObject(run);
  const std::string name = pathFromObject(path);
  const BodyFileOptions options{parseLengthUnit(unit), tolerance, cell, resolution};
  Body body = runWithoutLock(*context, [&] { return readBody(name, options, *context); });
  py::list findings;
  for (const Finding& finding : body.findings) {
    py::dict item;
    item["code"] = finding.code;
    item["count"] = finding.count;
    item["first"] = py::cast(finding.first);
    item["text"] = finding.text;
    findings.append(item);
  }
  return {std::make_shared<const TriMesh>(std::move(body.mesh)), body.chordError, findings};
}

void pyWriteMesh(const py::object& path, const py::object& vertices, const py::object& triangles) {
  const std::string name = pathFromObject(path);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const py::gil_scoped_release release;
  writeMesh(mesh, name);
}

py::tuple pyReadTrajectory(const py::object& path, const std::string& unit) {
  const std::string name = pathFromObject(path);
  const double scale = parseLengthUnit(unit);
  Trajectory trajectory;
  {
    const py::gil_scoped_release release;
    trajectory = readTrajectoryCsv(name, scale, Interpolation::None);
  }
  return trajectoryToArrays(trajectory);
}

/// Rigid matrices as the quaternions and translations nearest to them.
py::tuple pyPosesFromMatrices(const py::object& times, const py::object& matrices) {
  return trajectoryToArrays(trajectoryFromObject(py::make_tuple(times, matrices), "none"));
}

#ifdef HAVE_SWEPT_SOLID
StepOptions solidOptions(const py::dict& keywords) {
  StepOptions options;
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
    } else if (name == "recognise") {
      options.recognise = py::cast<bool>(value);
    } else if (name == "max_faces") {
      options.maxFaces = py::cast<std::int64_t>(value);
    } else if (name == "max_megabytes") {
      options.maxMegabytes = py::cast<double>(value);
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

py::dict solidReport(const StepReport& report) {
  py::dict result, kinds;
  for (const auto& [kind, count] : report.facesByKind) kinds[kind.c_str()] = count;
  result["solids"] = report.solids;
  result["faces"] = report.faces;
  result["faces_by_kind"] = kinds;
  result["edges"] = report.edges;
  result["valid"] = report.valid;
  result["tolerance"] = report.tolerance;
  result["deviation"] = report.deviation;
  result["note"] = report.note;
  result["volume"] = report.volume;
  result["mesh_volume"] = report.meshVolume;
  result["file_bytes"] = report.fileBytes;
  result["seconds_build"] = report.secondsBuild;
  result["seconds_write"] = report.secondsWrite;
  result["seconds_reread"] = report.secondsReread;
  return result;
}

py::dict pyWriteSolid(const py::object& path, const py::object& vertices,
                      const py::object& triangles, const py::object& run,
                      const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const std::string name = pathFromObject(path);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const StepOptions options = solidOptions(keywords);
  return solidReport(
      runWithoutLock(*context, [&] { return writeSolid(mesh, name, options, *context); }));
}

py::dict pyEstimateSolid(const py::object& vertices, const py::object& triangles,
                         const py::object& run, const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const StepOptions options = solidOptions(keywords);
  const SolidEstimate found =
      runWithoutLock(*context, [&] { return estimateSolid(mesh, options, *context); });
  py::dict result;
  result["triangles"] = found.triangles;
  result["faces"] = found.faces;
  result["megabytes"] = found.megabytes;
  result["seconds"] = found.seconds;
  return result;
}
#else
[[noreturn]] void refuseSolids(const py::args&, const py::kwargs&) {
  throw Error(Status::ExportFailed, "BadFormat",
              "this module was built without OpenCASCADE and cannot write solids");
}
#endif

void bindClasses(py::module_& module) {
  py::class_<RunContext, RunPointer>(module, "RunContext", kRunContextDoc)
      .def(py::init([](int threads, double memoryLimitMegabytes) {
             auto run = std::make_shared<RunContext>();
             run->threads = threads;
             run->memoryLimitBytes = bytesFromMegabytes(memoryLimitMegabytes);
             return run;
           }),
           py::arg("threads") = 0, py::arg("memory_limit_mb") = 0.0)
      .def("cancel", &RunContext::cancel, "Asks the run to stop; returns at once.")
      .def_property_readonly("cancelled", &RunContext::isCancelled)
      .def_property_readonly("progress", &RunContext::progress, "Whole run, 0 to 1; never falls.")
      .def_property_readonly(
          "phase", [](const RunContext& run) { return phaseName(run.phase()); },
          "Name of the stage under way.")
      .def_readwrite("threads", &RunContext::threads)
      // For tests.
      .def_property_readonly("_checkpoints", &RunContext::checkpoints)
      .def("_cancel_at_checkpoint",
           [](RunContext& run, std::uint64_t n) { run.cancelAtCheckpoint = n; });
  py::class_<Mesh>(module, "Mesh", kMeshDoc)
      .def_property_readonly("vertices", &Mesh::vertices, "float64 (N, 3), mm, read-only")
      .def_property_readonly("triangles", &Mesh::triangles, "int32 (M, 3), read-only")
      .def_readonly("chord_error", &Mesh::chordError,
                    "mm: how far triangles of a solid may leave its surface; 0: a mesh file")
      .def_readonly("findings", &Mesh::findings,
                    "How a solid was read, as in a report's warnings.");
  py::class_<ComputeResult>(module, "Result", kResultDoc)
      .def_property_readonly("mesh", &ComputeResult::mesh)
      .def_property_readonly(
          "vertices", [](const ComputeResult& result) { return result.mesh().vertices(); },
          "float64 (N, 3), mm, read-only")
      .def_property_readonly(
          "triangles", [](const ComputeResult& result) { return result.mesh().triangles(); },
          "int32 (M, 3), read-only")
      .def_readonly("report", &ComputeResult::report, "dict, keys as in README.md")
      .def_property_readonly("contact_time", &ComputeResult::contactTime,
                             "float64 (N,): s at which the vertex is touched; may be empty")
      .def_property_readonly("feature_edges", &ComputeResult::featureEdges,
                             "int32 (E, 2): vertex pairs along creases; may be empty")
      .def("recut", &pyRecut, kRecutDoc, py::arg("tolerance"), py::arg("run") = py::none());
}

void bindPreview(py::module_& module) {
  py::class_<PreviewSession>(module, "PreviewSession", kPreviewSessionDoc)
      .def(py::init(&pyPreviewSession), py::arg("vertices"), py::arg("triangles"))
      .def("compute", &pyPreview, kPreviewDoc, py::arg("motion"),
           py::arg("interpolation") = "linear", py::arg("run") = py::none(),
           py::arg("sketch") = false);
}

void bindFunctions(py::module_& module) {
  py::class_<WarmMemory>(module, "WarmMemory", kWarmMemoryDoc)
      .def(py::init<std::size_t>(), py::arg("bytes"))
      .def("touch", &WarmMemory::touch, py::call_guard<py::gil_scoped_release>(),
           "Fetches the pages; any thread.")
      .def("release", &WarmMemory::release, "Leaves them to the heap; the thread that made it.")
      .def_property_readonly("bytes", &WarmMemory::bytes, "Bytes that are held.");
  module.def(
      "stand_back", &standBack,
      "From now on runs leave the processor to other threads of this process first. Ask before "
      "the first run.");
  module.def("compute", &pyCompute, kComputeDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("interpolation") = "linear", py::arg("run") = py::none());
  module.def("estimate", &pyEstimate, kEstimateDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("interpolation") = "linear");
  module.def("check_mesh", &pyCheckMesh, kCheckMeshDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("run") = py::none());
  module.def("read_mesh", &pyReadMesh, kReadMeshDoc, py::arg("path"), py::arg("unit") = "mm");
  module.def("read_body", &pyReadBody, kReadBodyDoc, py::arg("path"), py::arg("unit") = "mm",
             py::arg("tolerance") = py::none(), py::arg("cell") = py::none(),
             py::arg("resolution") = 128, py::arg("run") = py::none());
  module.def("write_mesh", &pyWriteMesh, kWriteMeshDoc, py::arg("path"), py::arg("vertices"),
             py::arg("triangles"));
  module.def("read_trajectory_csv", &pyReadTrajectory, kReadTrajectoryDoc, py::arg("path"),
             py::arg("unit") = "mm");
  module.def("poses_from_matrices", &pyPosesFromMatrices,
             "poses_from_matrices(times (K,), matrices (K, 4, 4)) -> (times, quaternions (K, 4), "
             "translations (K, 3))",
             py::arg("times"), py::arg("matrices"));
#ifdef HAVE_SWEPT_SOLID
  module.def("write_solid", &pyWriteSolid, kWriteSolidDoc, py::arg("path"), py::arg("vertices"),
             py::arg("triangles"), py::arg("run") = py::none());
  module.def("estimate_solid", &pyEstimateSolid, kEstimateSolidDoc, py::arg("vertices"),
             py::arg("triangles"), py::arg("run") = py::none());
#else
  module.def("write_solid", &refuseSolids);
  module.def("estimate_solid", &refuseSolids);
#endif
}

}  // namespace
}  // namespace swept::python

PYBIND11_MODULE(_swept, module) {
  using namespace swept::python;
  module.doc() = kModuleDoc;
  module.attr("__version__") = SWEPT_VERSION;
#ifdef HAVE_SWEPT_SOLID
  module.attr("HAS_SOLIDS") = true;
#else
  module.attr("HAS_SOLIDS") = false;
#endif
  bindErrors(module);
  bindClasses(module);
  bindPreview(module);
  bindFunctions(module);
  bindDrawing(module);
#ifdef HAVE_SWEPT_CLEARANCE
  bindClearance(module);
  bindPath(module);
#endif
}
