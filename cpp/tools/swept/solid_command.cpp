// swept solid MESH --output FILE: a closed mesh becomes a STEP or BREP file, or with --estimate a
// trial says what that would take.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_SOLID
#include <cstdio>
#include <memory>
#include <optional>

#include "commands.h"
#include "files.h"
#include "runner.h"
#include "solid_options.h"

namespace swept::cli {
namespace {

struct SolidJob {
  std::string meshPath, meshFormat, outputPath, outputFormat = "step";
  double unit = 1.0;
  bool estimate = false;  // write nothing
  CommonOptions common;
  StepOptions options;
};

TriMesh meshOf(const SolidJob& job) {
  return meshFrom(inputPath(job.meshPath), job.meshPath, job.meshFormat, job.unit);
}

void printEstimate(const SolidEstimate& estimate) {
  std::printf("estimate: %lld faces, %.3g MB, %.1f s, deviation %.3g mm\n",
              static_cast<long long>(estimate.faces), estimate.megabytes, estimate.seconds,
              estimate.deviation);
}

int runEstimate(const SolidJob& job) {
  const CommonOptions& common = job.common;
  const std::vector<RoledFile> inputs{{"the mesh", job.meshPath}};
  checkIdentity(inputs, {{"--report", common.report}}, common.noClobber);
  checkAccess({}, {{"--report", common.report}});
  Report report;
  std::optional<SolidEstimate> estimate;
  RunContext run;
  run.threads = static_cast<int>(common.threads);
  try {
    std::optional<TriMesh> mesh;
    if (isStream(job.meshPath)) mesh = meshOf(job);
    runWatched(run, common.quiet, [&] {
      checkAccess(inputs, {});
      if (!mesh) mesh = meshOf(job);
      const std::string& kind = job.outputFormat;
      const bool named = !job.outputPath.empty() && job.outputPath != "-";
      const SolidFormat format = solidFormatOf(named ? job.outputPath : "solid." + kind);
      estimate = trySolid(*mesh, job.options, format, run);
    });
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  }
  Json json = reportHead("solid", report.status, report.code, report.message);
  json["input"] = job.meshPath;
  if (estimate) json["estimate"] = Json::parse(toJson(*estimate));
  json["warnings"] = findingsJson(report.warnings);
  writeReport(json, common.report);
  if (estimate && common.report != "-") printEstimate(*estimate);
  if (report.status != Status::Ok) printError(report.status, report.code, report.message);
  return exitStatus(report.status);
}

int runSolid(const SolidJob& job) {
  const CommonOptions& common = job.common;
  const std::vector<RoledFile> inputs{{"the mesh", job.meshPath}};
  const std::vector<RoledFile> outputs{{"--output", job.outputPath}};
  checkIdentity(inputs, {outputs[0], {"--report", common.report}}, common.noClobber);
  checkAccess({}, {{"--report", common.report}});
  Report report;
  StepReport solid;
  RunContext run;
  run.threads = static_cast<int>(common.threads);
  try {
    std::optional<TriMesh> mesh;
    if (isStream(job.meshPath)) mesh = meshOf(job);
    runWatched(run, common.quiet, [&] {
      checkAccess(inputs, outputs);
      if (!mesh) mesh = meshOf(job);
      const Output output(job.outputPath, job.outputFormat);
      solid = writeSolid(*mesh, output.path(), job.options, run);
      output.deliver();
    });
    report.warnings = solid.warnings;
    takeStrict(report, common.strict);
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  }
  const bool made = solid.fileBytes > 0;
  Json json = reportHead("solid", report.status, report.code, report.message);
  json["input"] = job.meshPath;
  if (made) {
    json["output"] = job.outputPath;
    json["solid"] = Json::parse(toJson(solid));
  }
  json["warnings"] = findingsJson(report.warnings);
  writeReport(json, common.report);
  if (made && !common.quiet && common.report != "-" && job.outputPath != "-")
    printSolid(solid, job.outputPath);
  printFindings(report.warnings, common.quiet);
  if (report.status != Status::Ok) printError(report.status, report.code, report.message);
  return exitStatus(report.status);
}

}  // namespace

Run addSolidCommand(CLI::App& program) {
  const auto job = std::make_shared<SolidJob>();
  CLI::App& app = *program.add_subcommand(
      "solid",
      "Makes a solid of a closed mesh. The file is read back and checked before it replaces an old "
      "one.");
  addText(app, "MESH", "FILE", job->meshPath, "ply, stl, obj or off; - for standard input")
      ->required();
  addText(app, "-o,--output", "FILE", job->outputPath,
          "ends in step, stp, brep or brp; - for standard output");
  app.add_flag(
      "--estimate", job->estimate,
      "only say what the solid would take: it is built as a trial, and nothing is written");
  addText(app, "--format", "ply|stl|obj|off", job->meshFormat,
          "format of the mesh, instead of its suffix");
  addText(app, "--output-format", "step|brep", job->outputFormat,
          "format of standard output (default step)");
  addUnit(app, "--unit", job->unit, "unit of the numbers in the mesh (default mm)");
  addCommonOptions(app, job->common);
  addSolidOptions(app, job->options);
  app.footer(
      "Examples:\n  swept solid envelope.ply -o envelope.step\n"
      "  swept solid envelope.ply -o envelope.step --solid-tolerance 0.1 --author \"A. Maker\"\n"
      "  swept solid envelope.ply --solid-tolerance 0.1 --estimate");
  app.callback([job] {
    if (!job->estimate && job->outputPath.empty())
      throw CLI::RequiredError("--output (or --estimate)");
  });
  return [job] {
    job->options.strict = job->common.strict;
    if (job->common.strict && job->options.tolerance <= 0) job->options.exact = true;
    return job->estimate ? runEstimate(*job) : runSolid(*job);
  };
}

}  // namespace swept::cli
#endif
