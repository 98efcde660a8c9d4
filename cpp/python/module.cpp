// The compiled module `_swept`: the core for Python, with numpy arrays as input and output.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <type_traits>

#include "arrays.h"
#include "base/checkpoint_hook.h"
#include "clearance_bindings.h"
#include "docstrings.h"
#include "drawing.h"
#include "errors.h"
#include "file_bindings.h"
#include "job.h"
#include "page_bindings.h"
#include "path_bindings.h"
#include "priority.h"
#include "source_bindings.h"
#include "swept/accuracy.h"
#include "swept/check_text.h"
#include "swept/compute.h"
#include "swept/inaccuracy.h"
#include "swept/preview.h"
#include "values.h"
#include "warm_memory.h"

#ifndef SWEPT_VERSION
#define SWEPT_VERSION "unknown"
#endif

namespace swept::python {
namespace {

struct ComputeResult {
  std::shared_ptr<const Result> data;
  py::object report;

  Mesh mesh() const { return {std::shared_ptr<const TriMesh>(data, &data->mesh), 0, py::list()}; }
  py::array contactTime() const {
    return readOnlyView(data->contactTime.data(),
                        {static_cast<py::ssize_t>(data->contactTime.size())}, data);
  }
  py::object sources() const {
    if (!data->sources.rows) return py::none();
    // The sources own their data, so they remain valid after the result is gone.
    return py::cast(std::make_shared<Sources>(data->sources));
  }
  py::array featureEdges() const {
    return readOnlyView(reinterpret_cast<const std::int32_t*>(data->featureEdges.data()),
                        {static_cast<py::ssize_t>(data->featureEdges.size()), 2}, data);
  }
};

std::optional<std::uint64_t> bytesFromMegabytes(const std::optional<double>& megabytes) {
  if (!megabytes) return std::nullopt;
  if (!(*megabytes >= 0) || *megabytes > 1e12) {
    throw Error(Status::InvalidInput, "BadOption",
                "memory_limit_mb must be 0 (default) or a positive number of MiB");
  }
  return unlessZero(std::optional(static_cast<std::uint64_t>(*megabytes * 1048576.0)));
}

// Converts one option of compute() or estimate(). Raises TypeError if the value has a wrong type,
// and BadOption if the value is a whole number that T cannot hold.
template <class T>
T castOption(const std::string& name, const py::handle& value) {
  try {
    return value.cast<T>();
  } catch (const py::cast_error&) {
    if (PyLong_Check(value.ptr()) != 0 && !std::is_same_v<T, std::string>) {
      throw Error(Status::InvalidInput, "BadOption",
                  "option " + name + " = " + py::repr(value).cast<std::string>() +
                      " is too large for any option; give a smaller number");
    }
    throw py::type_error("option " + name + " cannot be " + py::repr(value).cast<std::string>());
  }
}

void setOption(const std::string& name, const py::handle& value, Options& options,
               RunContext& run) {
  if (name == "resolution")
    options.resolution = castOption<int>(name, value);
  else if (name == "cell")
    options.cellSize = unlessZero(castOption<std::optional<double>>(name, value));
  else if (name == "accuracy")
    setAccuracy(options, castOption<double>(name, value));
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
  else if (name == "chord_tolerance")
    options.chordTolerance = castOption<std::optional<double>>(name, value);
  else if (name == "weld_tolerance")
    options.weldTolerance = castOption<std::optional<double>>(name, value);
  else if (name == "sources")
    options.sources = castOption<bool>(name, value);
  else if (name == "threads")
    run.threads = unlessZero(castOption<std::optional<int>>(name, value));
  else if (name == "memory_limit_mb")
    run.memoryLimitBytes = bytesFromMegabytes(castOption<std::optional<double>>(name, value));
  else
    throw py::type_error("unknown option '" + name + "'");
}

Options optionsFrom(const py::kwargs& keywords, RunContext& run) {
  Options options;
  for (const auto& [name, value] : keywords) {
    setOption(name.cast<std::string>(), value, options, run);
  }
  return options;
}

ComputeResult resultOrRaise(const std::shared_ptr<const Result>& result) {
  return {result, foundOf(result->report)};
}

ComputeResult pyCompute(const py::object& vertices, const py::object& triangles,
                        const py::object& motion, const std::string& interpolation,
                        const py::object& run, const py::object& faces,
                        const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const Options options = optionsFrom(keywords, *context);
  TriMesh body = meshFromArrays(vertices, triangles);
  if (!faces.is_none()) body.faceOf = facesFromArray(faces);
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
                                                 const py::object& faces,
                                                 const py::kwargs& keywords) {
  RunContext run;
  const Options options = optionsFrom(keywords, run);
  TriMesh body = meshFromArrays(vertices, triangles);
  if (!faces.is_none()) body.faceOf = facesFromArray(faces);
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
                    const py::object& motion, const std::string& interpolation, bool trial,
                    const py::object& run, const py::kwargs& keywords) {
  const RunPointer context = runFromObject(run);
  const Options options = optionsFrom(keywords, *context);
  const TriMesh body = meshFromArrays(vertices, triangles);
  const Trajectory trajectory = trajectoryFromObject(motion, interpolation);
  const Estimate found = runWithoutLock(*context, [&] {
    return trial ? estimateByTrial(body, trajectory, options, *context)
                 : estimate(body, trajectory, options);
  });
  py::dict result;
  result["grid"] = py::cast(found.grid);
  result["cell"] = found.cellSize;
  result["memory_bytes"] = found.memoryBytes;
  result["seconds"] = found.seconds;
  result["triangles"] = found.triangles;
  if (found.usefulFilter) result["useful_filter"] = *found.usefulFilter;
  return result;
}

py::dict optionsOfAccuracy(double accuracy) {
  Options options;
  setAccuracy(options, accuracy);
  py::dict found;
  found["cell"] = options.cellSize;
  found["tolerance"] = options.tolerance;
  found["chord_tolerance"] = options.chordTolerance;
  return found;
}

py::object pyCheckMesh(const py::object& vertices, const py::object& triangles,
                       const py::object& run) {
  const RunPointer context = runFromObject(run);
  const TriMesh mesh = meshFromArrays(vertices, triangles);
  const MeshCheck check = runWithoutLock(*context, [&] { return checkMesh(mesh, *context); });
  return parseJson(toJson(check));
}

void bindClasses(py::module_& module) {
  py::class_<RunContext, RunPointer>(module, "RunContext", kRunContextDoc)
      .def(py::init([](const std::optional<int>& threads,
                       const std::optional<double>& memoryLimitMegabytes) {
             auto run = std::make_shared<RunContext>();
             run->threads = unlessZero(threads);
             run->memoryLimitBytes = bytesFromMegabytes(memoryLimitMegabytes);
             return run;
           }),
           py::arg("threads") = py::none(), py::arg("memory_limit_mb") = py::none())
      .def("cancel", &RunContext::cancel,
           "Asks the run to stop and returns without waiting for it.")
      .def_property_readonly("cancelled", &RunContext::isCancelled)
      .def_property_readonly("progress", &RunContext::progress,
                             "Progress of the whole run, 0 to 1. Never decreases.")
      .def_property_readonly(
          "phase", [](const RunContext& run) { return phaseName(run.phase()); },
          "Name of the current stage.")
      .def_property(
          "threads", [](const RunContext& run) { return run.threads; },
          [](RunContext& run, const std::optional<int>& threads) {
            run.threads = unlessZero(threads);
          },
          "Number of threads, or None for all cores.")
      // For tests.
      .def_property_readonly("_checkpoints", &CheckpointHook::passed)
      .def("_cancel_at_checkpoint", &CheckpointHook::cancelAt);
  py::class_<ComputeResult>(module, "Result", kResultDoc)
      .def_property_readonly("mesh", &ComputeResult::mesh)
      .def_property_readonly(
          "vertices", [](const ComputeResult& result) { return result.mesh().vertices(); },
          "float64 (N, 3), mm, read-only")
      .def_property_readonly(
          "triangles", [](const ComputeResult& result) { return result.mesh().triangles(); },
          "int32 (M, 3), read-only")
      .def_readonly("report", &ComputeResult::report,
                    "The report as a dict; docs/report.md describes its keys.")
      .def_property_readonly(
          "contact_time", &ComputeResult::contactTime,
          "float64 (N,): time (s) at which the body touches the vertex. May be empty.")
      .def_property_readonly(
          "feature_edges", &ComputeResult::featureEdges,
          "int32 (E, 2): edges of the mesh along creases, as pairs of vertices. May be empty.")
      .def_property_readonly("sources", &ComputeResult::sources,
                             "Sources, or None if the option sources was not set.")
      .def("recut", &pyRecut, kRecutDoc, py::arg("tolerance"), py::arg("run") = py::none());
}

void bindPreview(py::module_& module) {
  py::class_<PreviewSession>(module, "PreviewSession", kPreviewSessionDoc)
      .def(py::init(&pyPreviewSession), py::arg("vertices"), py::arg("triangles"),
           py::arg("faces") = py::none())
      .def("compute", &pyPreview, kPreviewDoc, py::arg("motion"),
           py::arg("interpolation") = "linear", py::arg("run") = py::none(),
           py::arg("sketch") = false);
}

void bindFunctions(py::module_& module) {
  py::class_<WarmMemory>(module, "WarmMemory", kWarmMemoryDoc)
      .def(py::init<std::size_t>(), py::arg("bytes"))
      .def("touch", &WarmMemory::touch, py::call_guard<py::gil_scoped_release>(),
           "Fetches the pages of the memory. May run in any thread.")
      .def("release", &WarmMemory::release,
           "Gives the memory back to the heap. Call it in the thread that created the object.")
      .def_property_readonly("bytes", &WarmMemory::bytes, "Number of reserved bytes.");
  module.def("stand_back", &lowerRunPriority,
             "Gives later runs a lower priority than the other threads of this process. Call it "
             "before the first run.");
  module.def("compute", &pyCompute, kComputeDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("interpolation") = "linear", py::arg("run") = py::none(),
             py::arg("faces") = py::none());
  module.def("estimate", &pyEstimate, kEstimateDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("motion"), py::arg("interpolation") = "linear", py::arg("trial") = false,
             py::arg("run") = py::none());
  module.def("costs_accuracy", &costsAccuracy, py::arg("code"),
             "costs_accuracy(code: str) -> bool\n\nReturns True if a finding with this code means "
             "that a result is less accurate than requested.");
  module.def(
      "options_of_accuracy", &optionsOfAccuracy, py::arg("accuracy"),
      "options_of_accuracy(accuracy: float) -> dict\n\nReturns the options of compute() that "
      "an accuracy (mm) stands for: cell (mm), tolerance (mm) and chord_tolerance (mm). Raises "
      "InvalidInput unless it is above 0.");
  module.def("check_mesh", &pyCheckMesh, kCheckMeshDoc, py::arg("vertices"), py::arg("triangles"),
             py::arg("run") = py::none());
}

}  // namespace
}  // namespace swept::python

PYBIND11_MODULE(_swept, module) {
  using namespace swept::python;
  module.doc() = kModuleDoc;
  module.attr("__version__") = SWEPT_VERSION;
  bindErrors(module);
  bindFiles(module);
  bindSources(module);
  bindClasses(module);
  bindPreview(module);
  bindFunctions(module);
  bindDrawing(module);
#ifdef HAVE_SWEPT_CLEARANCE
  bindClearance(module);
  bindPath(module);
  bindPage(module);
#endif
}
