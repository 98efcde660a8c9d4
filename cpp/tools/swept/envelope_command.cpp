// swept envelope GENERATOR --motion CSV --output FILE: the main job without FreeCAD.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>

#include "arguments.h"
#include "base/limits.h"
#include "base/safe_file.h"
#include "commands.h"
#include "report_file.h"
#include "runner.h"
#include "swept/body.h"
#include "swept/compute.h"
#include "swept/io.h"
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"
#endif

namespace swept::cli {

const char* const kEnvelopeHelp =
    R"(swept envelope GENERATOR --motion CSV --output FILE [options]
  Computes the envelope of GENERATOR (ply, stl, obj, off; with OpenCASCADE also step, stp, brep,
  brp: all solids of the file are one body) moved along the poses of CSV
  (t,tx,ty,tz,qx,qy,qz,qw or 16 matrix numbers a row; may be packed with gzip or xz).
  --output FILE           ply, stl, obj, off, 3mf, step, stp, brep or brp
  --generator-unit U      mm, cm, m or in: unit of the generator's numbers (default mm)
  --generator-tolerance MM    how far triangles may leave the surface of a solid (default: 0.02 of
                          the cell, or of the smallest cell that the resolution can give)
  --motion-unit U         unit of the translations (default mm)
  --interpolation I       none, linear or screw: motion between two poses (default linear)
  --resolution N          cells along the longest side of the sweep (default 128)
  --cell MM               size of a cell; instead of --resolution
  --tolerance MM          simplify, leaving the surface by at most this (default 0: off)
  --offset MM             grow by a safety distance
  --conservative          envelope that provably contains the sweep
  --keep-cavities         keep sealed-off hollow spaces
  --components M          dc, dmc, equivalence, greedy or consistent (default consistent); the
                          others are for research: only consistent keeps the promise of a closed
                          manifold
  --chord F               bound on the refined motion's chord, in cells (default 0.02)
  --position-filter MM    drop poses while the body stays within this
  --no-cull               sample enclosed faces as well
  --backend B             auto, cpu or gpu (default auto)
  --threads N             threads to use (default: all cores)
  --memory-limit MB       refuse what would take more (default: 3/4 of what is free)
  --report FILE.json      write the report, also of a failure; - for standard output
  --solid-tolerance MM, --max-faces N, --max-megabytes N, --schema S ...
                          for step and brep, see swept --help
  --quiet                 no progress bar, no summary
)";

namespace {

struct EnvelopeJob {
  std::string generatorPath;
  std::string motionPath;
  std::string outputPath;
  std::string reportPath;
  double generatorUnit = 1.0;
  std::optional<double> generatorTolerance;
  double motionUnit = 1.0;
  Interpolation interpolation = Interpolation::Linear;
  Options options;
  std::int64_t threads = 0;
  std::int64_t memoryLimitMegabytes = 0;
  bool quiet = false;
#ifdef HAVE_SWEPT_SOLID
  StepOptions solid;
#endif
};

bool isSolidSuffix(const std::string& suffix) {
  return suffix == "step" || suffix == "stp" || suffix == "brep" || suffix == "brp";
}

EnvelopeJob parseJob(const std::vector<std::string>& words) {
  EnvelopeJob job;
  std::int64_t resolution = job.options.resolution;
  constexpr std::int64_t kMaxMegabytes = std::int64_t{1} << 40;
  Arguments a;
  a.text("--motion", job.motionPath);
  a.text("--output", job.outputPath);
  a.text("--report", job.reportPath);
  a.with("--generator-unit", [&](const std::string& t) { job.generatorUnit = parseLengthUnit(t); });
  a.with("--motion-unit", [&](const std::string& t) { job.motionUnit = parseLengthUnit(t); });
  a.with("--interpolation",
         [&](const std::string& t) { job.interpolation = parseInterpolation(t); });
  a.with("--components",
         [&](const std::string& t) { job.options.components = parseComponentMethod(t); });
  a.with("--backend", [&](const std::string& t) { job.options.backend = parseBackend(t); });
  a.integer("--resolution", resolution, 1, 1 << 20);
  a.number("--generator-tolerance", job.generatorTolerance);
  a.number("--cell", job.options.cellSize);
  a.number("--tolerance", job.options.tolerance);
  a.number("--offset", job.options.offset);
  a.number("--chord", job.options.chordTolerance);
  a.number("--position-filter", job.options.positionFilter);
  a.flag("--conservative", job.options.conservative);
  a.flag("--keep-cavities", job.options.keepCavities);
  a.flag("--no-cull", job.options.cull, false);
  a.integer("--threads", job.threads, 0, kMaxThreads);
  a.integer("--memory-limit", job.memoryLimitMegabytes, 1, kMaxMegabytes);
  a.flag("--quiet", job.quiet);
#ifdef HAVE_SWEPT_SOLID
  addSolidOptions(a, job.solid);
#endif
  const std::vector<std::string> positional = a.parse(words);
  const auto bad = [](const std::string& text) {
    throw Error(Status::InvalidInput, "BadOption", text + "; see swept envelope --help");
  };
  if (positional.size() != 1) {
    bad("expected one generator, found " + std::to_string(positional.size()));
  }
  if (job.motionPath.empty()) bad("--motion CSV is missing");
  if (job.outputPath.empty()) bad("--output FILE is missing");
  if (a.wasGiven("--cell") && a.wasGiven("--resolution")) {
    bad("--cell and --resolution exclude one another");
  }
  // Zero means "not given" inside; on the command line it is a mistake.
  if (a.wasGiven("--cell") && !(job.options.cellSize > 0)) {
    bad("--cell must be greater than 0 mm");
  }
#ifdef HAVE_SWEPT_SOLID
  if (job.options.conservative && job.solid.tolerance > 0) {
    bad("--solid-tolerance would let the solid cut into a conservative envelope; leave it out");
  }
  job.solid.exact = job.options.conservative;
#endif
  job.generatorPath = positional[0];
  job.options.resolution = static_cast<int>(resolution);
  return job;
}

// Everything that can be refused before minutes are spent.
void checkTargets(const EnvelopeJob& job) {
  checkReportTarget(job.reportPath);
  const std::string suffix = suffixOf(job.outputPath);
  const bool mesh =
      suffix == "ply" || suffix == "stl" || suffix == "obj" || suffix == "off" || suffix == "3mf";
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
  checkTarget(job.outputPath);
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
#ifdef HAVE_SWEPT_SOLID
  if (isSolidSuffix(suffixOf(job.outputPath)))
    return writeSolid(mesh, job.outputPath, job.solid, run);
#endif
  writeMesh(mesh, job.outputPath);
  return std::nullopt;
}

void printSummary(const Report& report, const std::string& path) {
  std::printf("%s: %lld triangles, volume %.6g mm^3, area %.6g mm^2, cell %.4g mm, %.2f s\n",
              path.c_str(), static_cast<long long>(report.check.triangles), report.check.volume,
              report.check.area, report.cellSize,
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
  for (const Finding& finding : report.warnings) {
    std::fprintf(stderr, "swept: note %s: %s\n", finding.code.c_str(), finding.text.c_str());
  }
}

SolidResult runJob(const EnvelopeJob& job, RunContext& run, Report& report) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  BodyFileOptions files{job.generatorUnit, job.generatorTolerance, {}, job.options.resolution};
  if (job.options.cellSize > 0) files.cellSize = job.options.cellSize;
  const Body body = readBody(job.generatorPath, files, run);
  const Trajectory motion = readTrajectoryCsv(job.motionPath, job.motionUnit, job.interpolation);
  const double reading = since(start);
  Result result = compute(body.mesh, motion, job.options, run);
  report = std::move(result.report);
  report.warnings.insert(report.warnings.begin(), body.findings.begin(), body.findings.end());
  addStage(report, "read", reading);
  if (report.status != Status::Ok) return {};
  const auto writing = Clock::now();
  SolidResult solid = writeOutput(result.mesh, job, run);
  addStage(report, "write", since(writing));
  return solid;
}

void takeError(Report& report, Status status, const std::string& code, const std::string& text) {
  report.status = status;
  report.code = code;
  report.message = text;
}

}  // namespace

int envelopeCommand(const std::vector<std::string>& words) {
  const EnvelopeJob job = parseJob(words);
  Report report;
  SolidResult solid;
  RunContext run;
  run.threads = static_cast<int>(job.threads);
  run.memoryLimitBytes = static_cast<std::uint64_t>(job.memoryLimitMegabytes) << 20;
  try {
    checkTargets(job);
    runWatched(run, job.quiet, [&] { solid = runJob(job, run, report); });
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  } catch (const std::bad_alloc&) {
    takeError(report, Status::OutOfMemory, "OutOfMemory",
              "memory ran out while reading or writing files; close other programs or use a larger "
              "cell");
  }
  const bool ok = report.status == Status::Ok;
  if (!ok) printError(report.status, report.code, report.message);
  writeReport(report, job.reportPath, [&](JsonWriter& json) {
    json.field("output", ok ? job.outputPath : std::string());
#ifdef HAVE_SWEPT_SOLID
    if (solid) writeSolidFields(*solid, json);
#endif
  });
  if (ok && !job.quiet && job.reportPath != "-") {
    printSummary(report, job.outputPath);
#ifdef HAVE_SWEPT_SOLID
    if (solid) printSolid(*solid, job.outputPath);
#endif
  }
  return exitStatus(report.status);
}

}  // namespace swept::cli
