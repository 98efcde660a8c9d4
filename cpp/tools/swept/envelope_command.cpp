// swept envelope BODY --motion CSV --output FILE: computes an envelope.
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
#include "swept/accuracy.h"
#include "swept/body.h"
#include "swept/compute.h"
#include "swept/io.h"
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"
#endif

namespace swept::cli {

namespace {

struct EnvelopeJob {
  std::string bodyPath, bodyFormat, motionPath, outputPath, outputFormat = "ply", sourcesPath;
  double bodyUnit = 1.0;
  std::optional<double> bodyTolerance;
  double motionUnit = 1.0;
  Interpolation interpolation = Interpolation::Linear;
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  Options options;
  std::int64_t resolution = 128;
  double accuracy = 0;  // mm; used if --accuracy is given
  std::optional<std::int64_t> memoryLimitMegabytes;
  CommonOptions common;
#ifdef HAVE_SWEPT_SOLID
  SolidOptions solid;
#endif
};

void addSamplingOptions(CLI::App& app, EnvelopeJob& job) {
  Options& options = job.options;
  CLI::Option* accuracy = addNumber(
      app, "--accuracy", "MM", job.accuracy,
      "how far the surface may lie from the true one; chooses cell size, tolerance and chord, in "
      "place of --resolution, --cell, --tolerance and --chord-tolerance");
  addInteger(app, "--resolution", job.resolution, 4, 16384,
             "number of grid cells along the longest side of the box around the swept volume, 4 to "
             "16384 (default 128)");
  CLI::Option* cell = addNumber(app, "--cell", "MM", options.cellSize,
                                "edge length of a grid cell, in place of --resolution");
  cell->excludes("--resolution");
  addNumber(
      app, "--tolerance", "MM", options.tolerance,
      "simplify the surface; it moves by at most this distance (default 0: no simplification)");
  addNumber(app, "--offset", "MM", options.offset,
            "grow the envelope by this distance on all sides (default 0)");
  app.add_flag("--conservative", options.conservative,
               "make an envelope that provably contains the swept volume");
  app.add_flag("--keep-cavities", options.keepCavities,
               "keep enclosed cavities as inner shells (default: they are filled)");
  addConverted(
      app, "--components", "dc|dmc|equivalence|greedy|consistent",
      [&options](const std::string& t) { options.components = parseComponentMethod(t); },
      "for research: how separate pieces of surface in one cell are recognised; only consistent "
      "(default) guarantees a closed manifold");
  addNumber(app, "--chord-tolerance", "MM", options.chordTolerance,
            "largest deviation of the computed motion from the true one, up to the size of a cell "
            "(default 0: 0.02 of a cell)");
  addNumber(app, "--position-filter", "MM", options.positionFilter,
            "skip poses as long as no point of the part has moved farther than this since the last "
            "pose used (default 0: use all poses)");
  for (const char* other : {"--resolution", "--cell", "--tolerance", "--chord-tolerance"}) {
    accuracy->excludes(app.get_option(other));
  }
  app.add_flag_callback(
      "--no-cull", [&options] { options.cull = false; },
      "also sample faces that are provably enclosed; slower, for tests");
  addConverted(
      app, "--backend", "auto|cpu|gpu",
      [&options](const std::string& t) { options.backend = parseBackend(t); },
      "processor that computes the envelope (default auto); the result does not depend on it");
  addInteger(app, "--memory-limit", job.memoryLimitMegabytes, 1, std::int64_t{1} << 40,
             "largest amount of memory in MiB; a run that needs more is refused (default: 3/4 of "
             "the free memory)");
}

void addOptions(CLI::App& app, EnvelopeJob& job) {
  addText(app, "BODY", "FILE", job.bodyPath,
          "the moving part: a file of type ply, stl, obj, off, step, stp, brep or brp, or - for "
          "standard input. All solids of a file move as one part")
      ->required();
  addText(
      app, "--motion", "FILE", job.motionPath,
      "table of poses, or - for standard input. Each row holds t,tx,ty,tz,qx,qy,qz,qw (s, mm, "
      "unit quaternion), or the 12, 16 or 17 numbers of a matrix. The file may be compressed with "
      "gzip or xz")
      ->required();
  addText(app, "-o,--output", "FILE", job.outputPath,
          "file to write, of type ply, stl, obj, off, 3mf, step, stp, brep or brp, or - for "
          "standard output")
      ->required();
  addText(app, "--sources", "FILE", job.sourcesPath,
          "write a table of what made each triangle of the output, or - for standard output. "
          "Columns: triangle,kind,face,other_face,step,time_s,x,y,z. Faces are numbered as in the "
          "file of the solid; for a mesh, each triangle is a face");
  addText(app, "--format", "ply|stl|obj|off|3mf|step|brep", job.outputFormat,
          "format of the output if it is written to standard output (default ply)");
  addText(app, "--body-format", "ply|stl|obj|off|step|brep", job.bodyFormat,
          "format of the moving part, in place of its file extension");
  addUnit(app, "--body-unit", job.bodyUnit,
          "unit of the numbers in a moving part that is a mesh (default mm)");
  addConverted(
      app, "--body-tolerance", "MM",
      [&job](const std::string& t) { job.bodyTolerance = numberOf("--body-tolerance", t); },
      "how far the triangles of a moving part that is a solid may deviate from its surface "
      "(default: 0.02 of the cell "
      "size; with --resolution, 0.02 of the smallest cell size that this resolution can give)");
  keepGeneratorNames(app, "--body-", {"format", "unit", "tolerance"});
  addUnit(app, "--motion-unit", job.motionUnit,
          "unit of the translations in the motion (default mm)");
  addConverted(
      app, "--interpolation", "none|linear|screw",
      [&job](const std::string& t) { job.interpolation = parseInterpolation(t); },
      "how the part moves between two poses (default linear); none: only the poses themselves "
      "count");
  addPoint(
      app, "--pivot", job.pivot,
      "point of the moving part that moves in a straight line between two poses, used only with "
      "linear interpolation; coordinates in mm (default 0,0,0: the origin)");
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
  if (app.count("--cell") > 0 && !(job.options.cellSize.value_or(0) > 0))
    badOption("--cell must be greater than 0 mm");
  if (app.count("--accuracy") > 0) setAccuracy(job.options, job.accuracy);
#ifdef HAVE_SWEPT_SOLID
  if (job.options.conservative && job.solid.tolerance > 0) {
    badOption(
        "--solid-tolerance cannot be combined with --conservative, because the solid could then "
        "cut into the swept volume; leave out one of them");
  }
  job.solid.strict = job.common.strict;
  job.solid.exact = job.solid.exact || job.options.conservative ||
                    (job.common.strict && job.solid.tolerance <= 0);
#endif
  if (app.count("--format") > 0) checkStreamFormat("--format", job.outputFormat, job.outputPath);
  job.options.resolution = static_cast<int>(job.resolution);
  job.options.sources = !job.sourcesPath.empty();
  if (job.options.sources && isSolidSuffix(suffixOfOutput(job)))
    badOption("--sources needs an output that is a mesh; write ply, stl, obj, off or 3mf");
}

void checkFormat(const EnvelopeJob& job) {
  const std::string suffix = suffixOfOutput(job);
  const bool mesh = isMeshSuffix(suffix);
  if (!mesh && !isSolidSuffix(suffix)) {
    throw Error(Status::ExportFailed, "BadFormat",
                "'" + job.outputPath +
                    "' does not end in .ply, .stl, .obj, .off, .3mf, .step, .stp, .brep or .brp, "
                    "so the format is unknown");
  }
#ifndef HAVE_SWEPT_SOLID
  if (!mesh) {
    throw Error(Status::ExportFailed, "BadFormat",
                "this program was built without OpenCASCADE and cannot write solids; use ply, stl, "
                "obj, off or 3mf");
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
using SolidResult = std::optional<WrittenSolid>;
#else
using SolidResult = std::optional<int>;
#endif

// Returns whether the output is a solid whose surfaces may be derived from the body: from its
// faces, and from the surfaces that its edges and faces sweep (SolidOrigin).
bool wantsBodyFaces(const EnvelopeJob& job, const Body& body) {
#ifdef HAVE_SWEPT_SOLID
  const Options& options = job.options;
  return body.shape != nullptr && isSolidSuffix(suffixOfOutput(job)) && job.solid.recognise &&
         !job.solid.exact && options.offset == 0 && !options.conservative &&
         options.positionFilter == 0;
#else
  static_cast<void>(job);
  static_cast<void>(body);
  return false;
#endif
}

SolidResult writeOutput(const Result& result, const Body& body, const Trajectory& motion,
                        const EnvelopeJob& job, RunContext& run) {
  run.checkpoint(Phase::Export);
  SolidResult solid;
  writeOutputFile(job.outputPath, job.outputFormat, [&](const std::string& path) {
#ifdef HAVE_SWEPT_SOLID
    if (isSolidSuffix(suffixOfOutput(job))) {
      SolidOptions options = job.solid;
      if (wantsBodyFaces(job, body)) {
        options.origin = std::make_shared<const SolidOrigin>(SolidOrigin{motion, body.shape});
      }
      solid = writeSolid(result.mesh, path, options, run);
      return;
    }
#else
    static_cast<void>(body);
    static_cast<void>(motion);
#endif
    writeMesh(result.mesh, path);
  });
  return solid;
}

void printSummary(const Report& report, const std::string& path) {
  std::printf("%s: %lld triangles, volume %.6g mm^3, area %.6g mm^2, cell %.4g mm, %.2f s\n",
              path.c_str(), static_cast<long long>(report.check.triangles), report.check.volume,
              report.check.area, report.cellSize,
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
}

Body readMovingBody(const EnvelopeJob& job, RunContext& run) {
  const BodyFileOptions files{job.bodyUnit, job.bodyTolerance, job.options.cellSize,
                              job.options.resolution};
  return readInputBody(job.bodyPath, job.bodyFormat, files, run);
}

// STL stores single precision. So for STL, rounds the mesh in the same way and checks it again: the
// report then describes the mesh in the file.
void reportAsWritten(TriMesh& mesh, const std::string& suffix, Report& report, RunContext& run) {
  if (suffix != "stl") return;
  mesh = meshAsWritten(mesh, suffix);
  const MeshCheck before = std::exchange(report.check, checkMesh(mesh, run));
  const std::int64_t more =
      report.check.selfIntersections.value_or(0) - before.selfIntersections.value_or(0);
  if (more <= 0 && report.check.passes() == before.passes()) return;
  report.warnings.push_back(
      {"SinglePrecision",
       std::max<std::int64_t>(more, 1),
       {},
       "STL stores only seven digits: after rounding, " + std::to_string(more) +
           " more pairs of triangles intersect" +
           (report.check.passes() ? "" : ", and the surface is no longer a closed manifold") +
           "; write PLY, OBJ, OFF or 3MF, or move the part and its motion closer to the origin"});
}

SolidResult runJob(const EnvelopeJob& job, RunContext& run, Report& report) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  const Body body = readMovingBody(job, run);
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
  SolidResult solid = writeOutput(result, body, motion, job, run);
  if (job.options.sources) writeSources(result.sources, job.sourcesPath);
  addStage(report, "write", since(writing));
  return solid;
}

int runEnvelope(const EnvelopeJob& job) {
  const CommonOptions& common = job.common;
  const std::vector<RoledFile> files{{"the moving part", job.bodyPath},
                                     {"the motion", job.motionPath}};
  const std::vector<RoledFile> output{{"--output", job.outputPath}, {"--sources", job.sourcesPath}};
  checkIdentity(files, {output[0], output[1], {"--report", common.report}}, common.noClobber);
  checkAccess({}, {{"--report", common.report}});
  Report report;
  SolidResult solid;
  RunContext run;
  run.threads = common.threads;
  if (job.memoryLimitMegabytes)
    run.memoryLimitBytes = static_cast<std::uint64_t>(*job.memoryLimitMegabytes) << 20;
  try {
    checkFormat(job);
    checkAccess(files, output);
    keepStreams(files);
    runWatched(run, common.quiet, [&] { solid = runJob(job, run, report); });
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  } catch (const std::bad_alloc&) {
    takeError(report, Status::OutOfMemory, "OutOfMemory",
              "memory ran out while files were read or written; close other programs, or use a "
              "larger cell");
  }
  const bool ok = report.status == Status::Ok;
#ifdef HAVE_SWEPT_SOLID
  if (solid) {
    const std::vector<Finding>& found = solid->warnings;
    report.warnings.insert(report.warnings.end(), found.begin(), found.end());
  }
#endif
  Json json = reportJson(report);
  json["input"] = job.bodyPath;
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
      "envelope", "Computes the envelope of a part that moves along the poses of a file.");
  addOptions(*app, *job);
  return [job, app] {
    checkOptions(*app, *job);
    return runEnvelope(*job);
  };
}

}  // namespace swept::cli
