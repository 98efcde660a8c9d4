// swept envelope GENERATOR --motion CSV --output FILE: the main job without FreeCAD.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "base/limits.h"
#include "commands.h"
#include "files.h"
#include "options.h"
#include "runner.h"
#include "sources_file.h"
#include "swept/body.h"
#include "swept/compute.h"
#include "swept/io.h"
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"
#endif

namespace swept::cli {

namespace {

struct EnvelopeJob {
  std::string generatorPath, generatorFormat, motionPath, outputPath, outputFormat = "ply",
                                                                      sourcesPath;
  double generatorUnit = 1.0;
  std::optional<double> generatorTolerance;
  double motionUnit = 1.0;
  Interpolation interpolation = Interpolation::Linear;
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  Options options;
  std::int64_t resolution = 128;
  std::int64_t memoryLimitMegabytes = 0;
  CommonOptions common;
#ifdef HAVE_SWEPT_SOLID
  StepOptions solid;
#endif
};

void addSamplingOptions(CLI::App& app, EnvelopeJob& job) {
  Options& options = job.options;
  addInteger(app, "--resolution", job.resolution, 1, 1 << 20,
             "cells along the longest side of the sweep (default 128)");
  CLI::Option* cell =
      addNumber(app, "--cell", "MM", options.cellSize, "size of a cell; instead of --resolution");
  cell->excludes("--resolution");
  addNumber(app, "--tolerance", "MM", options.tolerance,
            "simplify the surface, which moves by at most this (default 0: off)");
  addNumber(app, "--offset", "MM", options.offset, "grow the envelope by this distance");
  app.add_flag("--conservative", options.conservative, "envelope that provably contains the sweep");
  app.add_flag("--keep-cavities", options.keepCavities, "keep enclosed cavities");
  addConverted(
      app, "--components", "dc|dmc|equivalence|greedy|consistent",
      [&options](const std::string& t) { options.components = parseComponentMethod(t); },
      "for research: only consistent (default) keeps the promise of a closed manifold");
  addNumber(app, "--chord", "F", options.chordTolerance,
            "bound on the refined motion's chord, in cells (default 0.02)");
  addNumber(app, "--position-filter", "MM", options.positionFilter,
            "skip poses while no point of the part has moved farther than this");
  app.add_flag_callback(
      "--no-cull", [&options] { options.cull = false; }, "sample enclosed faces as well");
  addConverted(
      app, "--backend", "auto|cpu|gpu",
      [&options](const std::string& t) { options.backend = parseBackend(t); },
      "processor that samples; the result is the same (default auto)");
  addInteger(app, "--memory-limit", job.memoryLimitMegabytes, 1, std::int64_t{1} << 40,
             "MB; a run that needs more is refused (default: 3/4 of the free memory)");
}

void addOptions(CLI::App& app, EnvelopeJob& job) {
  addText(
      app, "GENERATOR", "FILE", job.generatorPath,
      "the moving body: ply, stl, obj, off, step, stp, brep or brp (all solids of a file are one "
      "body); - for standard input")
      ->required();
  addText(app, "--motion", "FILE", job.motionPath,
          "poses, t,tx,ty,tz,qx,qy,qz,qw or a matrix a row; may be packed with gzip or xz; - for "
          "standard input")
      ->required();
  addText(app, "-o,--output", "FILE", job.outputPath,
          "ply, stl, obj, off, 3mf, step, stp, brep or brp; - for standard output")
      ->required();
  addText(
      app, "--sources", "FILE", job.sourcesPath,
      "table of what made each triangle of the output, with faces counted as in the solid's file, "
      "else triangles of the generator: triangle,kind,face,other_face,step,time_s,x,y,z; - for "
      "standard output");
  addText(app, "--format", "ply|stl|obj|off|3mf|step|brep", job.outputFormat,
          "format of standard output (default ply)");
  addText(app, "--generator-format", "ply|stl|obj|off|step|brep", job.generatorFormat,
          "format of the generator, instead of its suffix");
  addUnit(app, "--generator-unit", job.generatorUnit,
          "unit of the generator's numbers (default mm)");
  addConverted(
      app, "--generator-tolerance", "MM",
      [&job](const std::string& t) {
        job.generatorTolerance = numberOf("--generator-tolerance", t);
      },
      "how far triangles may leave the surface of a solid (default: 0.02 of the cell, or of the "
      "smallest cell that the resolution can give)");
  addUnit(app, "--motion-unit", job.motionUnit, "unit of the translations (default mm)");
  addConverted(
      app, "--interpolation", "none|linear|screw",
      [&job](const std::string& t) { job.interpolation = parseInterpolation(t); },
      "motion between two poses (default linear)");
  addPoint(app, "--pivot", job.pivot,
           "point of the generator that moves straight between two poses, where the interpolation "
           "is linear (default 0,0,0: its origin)");
  addSamplingOptions(app, job);
  addCommonOptions(app, job.common);
#ifdef HAVE_SWEPT_SOLID
  addSolidOptions(app, job.solid);
#endif
  app.footer(
      "Examples:\n"
      "  swept envelope gripper.stl --motion path.csv -o envelope.ply\n"
      "  swept envelope gripper.stl --motion path.csv --motion-unit m --cell 0.5 -o envelope.step\n"
      "  xzcat path.csv.xz | swept envelope gripper.stl --motion - -o - --format stl > out.stl");
}

std::string suffixOfOutput(const EnvelopeJob& job) {
  return job.outputPath == "-" ? job.outputFormat : suffixOf(job.outputPath);
}

void checkOptions(const CLI::App& app, EnvelopeJob& job) {
  // Zero means "not given" inside; on the command line it is a mistake.
  if (app.count("--cell") > 0 && !(job.options.cellSize > 0))
    badOption("--cell must be greater than 0 mm");
#ifdef HAVE_SWEPT_SOLID
  if (job.options.conservative && job.solid.tolerance > 0) {
    badOption(
        "--solid-tolerance would let the solid cut into a conservative envelope; leave it out");
  }
  job.solid.strict = job.common.strict;
  job.solid.exact = job.solid.exact || job.options.conservative ||
                    (job.common.strict && job.solid.tolerance <= 0);
#endif
  job.options.resolution = static_cast<int>(job.resolution);
  job.options.sources = !job.sourcesPath.empty();
  if (job.options.sources && isSolidSuffix(suffixOfOutput(job)))
    badOption("--sources needs a mesh file: write ply, stl, obj, off or 3mf");
}

void checkFormat(const EnvelopeJob& job) {
  const std::string suffix = suffixOfOutput(job);
  const bool mesh = isMeshSuffix(suffix);
  if (!mesh && !isSolidSuffix(suffix)) {
    throw Error(Status::ExportFailed, "BadFormat",
                "'" + job.outputPath + "': unknown format '" + suffix +
                    "'; known are ply, stl, obj, off, 3mf, step, stp, brep, brp");
  }
#ifndef HAVE_SWEPT_SOLID
  if (!mesh) {
    throw Error(Status::ExportFailed, "BadFormat",
                "this program was built without OpenCASCADE and cannot write solids; choose ply, "
                "stl, obj, off or 3mf");
  }
#endif
}

void addStage(Report& report, const std::string& stage, double seconds) {
  auto total = report.seconds.end();
  if (!report.seconds.empty() && report.seconds.back().stage == "total") {
    total = report.seconds.end() - 1;
    total->seconds += seconds;
  }
  report.seconds.insert(total, {stage, seconds});
}

#ifdef HAVE_SWEPT_SOLID
using SolidResult = std::optional<StepReport>;
#else
using SolidResult = std::optional<int>;
#endif

SolidResult writeOutput(const TriMesh& mesh, const EnvelopeJob& job, RunContext& run) {
  run.checkpoint(Phase::Export);
  const Output output(job.outputPath, job.outputFormat);
  SolidResult solid;
#ifdef HAVE_SWEPT_SOLID
  if (isSolidSuffix(suffixOfOutput(job)))
    solid = writeSolid(mesh, output.path(), job.solid, run);
  else
    writeMesh(mesh, output.path());
#else
  writeMesh(mesh, output.path());
#endif
  output.deliver();
  return solid;
}

void printSummary(const Report& report, const std::string& path) {
  std::printf("%s: %lld triangles, volume %.6g mm^3, area %.6g mm^2, cell %.4g mm, %.2f s\n",
              path.c_str(), static_cast<long long>(report.check.triangles), report.check.volume,
              report.check.area, report.cellSize,
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
}

Body readGenerator(const EnvelopeJob& job, RunContext& run) {
  BodyFileOptions files{job.generatorUnit, job.generatorTolerance, {}, job.options.resolution};
  if (job.options.cellSize > 0) files.cellSize = job.options.cellSize;
  return readInputBody(job.generatorPath, job.generatorFormat, files, run);
}

// STL keeps single precision: the report is of the mesh in the file.
void reportAsWritten(TriMesh& mesh, const std::string& suffix, Report& report, RunContext& run) {
  if (suffix != "stl") return;
  mesh = meshAsWritten(mesh, suffix);
  const MeshCheck before = std::exchange(report.check, checkMesh(mesh, run));
  const std::int64_t more = report.check.selfIntersections - before.selfIntersections;
  if (more <= 0 && report.check.passes() == before.passes()) return;
  report.warnings.push_back(
      {"SinglePrecision",
       std::max<std::int64_t>(more, 1),
       {},
       "STL stores seven digits: after rounding, " + std::to_string(more) +
           " more pairs of triangles intersect" +
           (report.check.passes() ? "" : ", and the surface is no longer a closed manifold") +
           "; write PLY, OBJ, OFF or 3MF, or move part and motion closer to the origin"});
}

SolidResult runJob(const EnvelopeJob& job, RunContext& run, Report& report) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  const Body body = readGenerator(job, run);
  const Trajectory motion =
      readInputMotion(job.motionPath, job.motionUnit, job.interpolation, job.pivot);
  const double reading = since(start);
  Result result = compute(body.mesh, motion, job.options, run);
  report = std::move(result.report);
  const std::vector<Finding>& found = body.findings;
  report.warnings.insert(report.warnings.begin(), found.begin(), found.end());
  addStage(report, "read", reading);
  if (report.status == Status::Ok) reportAsWritten(result.mesh, suffixOfOutput(job), report, run);
  takeStrict(report, job.common.strict);
  if (report.status != Status::Ok) return {};
  const auto writing = Clock::now();
  SolidResult solid = writeOutput(result.mesh, job, run);
  if (job.options.sources) writeSources(result.sources, job.sourcesPath);
  addStage(report, "write", since(writing));
  return solid;
}

int runEnvelope(const EnvelopeJob& job) {
  const CommonOptions& common = job.common;
  const std::vector<RoledFile> files{{"the generator", job.generatorPath},
                                     {"the motion", job.motionPath}};
  const std::vector<RoledFile> output{{"--output", job.outputPath}, {"--sources", job.sourcesPath}};
  checkIdentity(files, {output[0], output[1], {"--report", common.report}}, common.noClobber);
  checkAccess({}, {{"--report", common.report}});
  Report report;
  SolidResult solid;
  RunContext run;
  run.threads = static_cast<int>(common.threads);
  run.memoryLimitBytes = static_cast<std::uint64_t>(job.memoryLimitMegabytes) << 20;
  try {
    checkFormat(job);
    checkAccess(files, output);
    keepStreams(files);
    runWatched(run, common.quiet, [&] { solid = runJob(job, run, report); });
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  } catch (const std::bad_alloc&) {
    takeError(report, Status::OutOfMemory, "OutOfMemory",
              "memory ran out while reading or writing files; close other programs or use a larger "
              "cell");
  }
  const bool ok = report.status == Status::Ok;
#ifdef HAVE_SWEPT_SOLID
  if (solid) {
    const std::vector<Finding>& found = solid->warnings;
    report.warnings.insert(report.warnings.end(), found.begin(), found.end());
  }
#endif
  Json json = reportJson(report);
  json["input"] = job.generatorPath;
  json["motion"] = job.motionPath;
  json["pivot"] = {job.pivot.x(), job.pivot.y(), job.pivot.z()};
  if (ok) json["output"] = job.outputPath;
#ifdef HAVE_SWEPT_SOLID
  if (solid) json["solid"] = Json::parse(toJson(*solid));
#endif
  if (!ok) printError(report.status, report.code, report.message);
  writeReport(json, common.report);
  if (ok && !common.quiet && common.report != "-" && job.outputPath != "-") {
    printSummary(report, job.outputPath);
#ifdef HAVE_SWEPT_SOLID
    if (solid) printSolid(*solid, job.outputPath);
#endif
  }
  if (ok) printFindings(report.warnings, common.quiet);
  if (common.verbose) printSeconds(report.seconds);
  return exitStatus(report.status);
}

}  // namespace

Run addEnvelopeCommand(CLI::App& program) {
  const auto job = std::make_shared<EnvelopeJob>();
  CLI::App* app = program.add_subcommand(
      "envelope", "Computes the envelope of a body moved along the poses of a file.");
  addOptions(*app, *job);
  return [job, app] {
    checkOptions(*app, *job);
    return runEnvelope(*job);
  };
}

}  // namespace swept::cli
