// swept solid MESH --output FILE: a closed mesh becomes a STEP or BREP file.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_SOLID
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
  CommonOptions common;
  StepOptions options;
};

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
    const auto read = [&] {
      mesh = meshFrom(inputPath(job.meshPath), job.meshPath, job.meshFormat, job.unit);
    };
    if (isStream(job.meshPath)) read();
    runWatched(run, common.quiet, [&] {
      checkAccess(inputs, outputs);
      if (!mesh) read();
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
          "ends in step, stp, brep or brp; - for standard output")
      ->required();
  addText(app, "--format", "ply|stl|obj|off", job->meshFormat,
          "format of the mesh, instead of its suffix");
  addText(app, "--output-format", "step|brep", job->outputFormat,
          "format of standard output (default step)");
  addUnit(app, "--unit", job->unit, "unit of the numbers in the mesh (default mm)");
  addCommonOptions(app, job->common);
  addSolidOptions(app, job->options);
  app.footer(
      "Examples:\n  swept solid envelope.ply -o envelope.step\n"
      "  swept solid envelope.ply -o envelope.step --solid-tolerance 0.1 --author \"A. Maker\"");
  return [job] {
    job->options.strict = job->common.strict;
    if (job->common.strict && job->options.tolerance <= 0) job->options.exact = true;
    return runSolid(*job);
  };
}

}  // namespace swept::cli
#endif
