// swept solid MESH --output FILE: converts a closed mesh to a STEP or BREP file. With --estimate, a
// trial estimates the number of faces, the size and the time.
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
  bool estimate = false;  // true: only estimate, write nothing
  CommonOptions common;
  SolidOptions options;
};

TriMesh meshOf(const SolidJob& job) {
  return readRepeatably(job.meshPath, [&job](const std::string& file) {
    return meshFrom(file, job.meshPath, job.meshFormat, job.unit);
  });
}

void printEstimate(const SolidEstimate& estimate) {
  std::printf("estimate: %lld faces, %.3g MB, %.1f s, deviation %.3g mm\n",
              static_cast<long long>(estimate.faces), estimate.megabytes, estimate.seconds,
              estimate.deviation);
}

/// Reads the mesh and calls work(mesh, run) as a watched run. Errors are stored in the returned
/// report. `outputs`: the outputs other than the report.
template <class Work>
Report runOnMesh(const SolidJob& job, const std::vector<RoledFile>& outputs, const Work& work) {
  const CommonOptions& common = job.common;
  const std::vector<RoledFile> inputs{{"the mesh", job.meshPath}};
  const RoledFile reportFile{"--report", common.report};
  std::vector<RoledFile> all = outputs;
  all.push_back(reportFile);
  checkIdentity(inputs, all, common.noClobber);
  checkAccess({}, {reportFile});
  Report report;
  RunContext run;
  run.threads = common.threads;
  try {
    checkAccess(inputs, outputs);
    keepStreams(inputs);
    runWatched(run, common.quiet, [&] { report.warnings = work(meshOf(job), run); });
    takeStrict(report, common.strict);
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  }
  return report;
}

/// Writes the report. `found`: further keys beside input and warnings.
void writeSolidReport(const SolidJob& job, const Report& report, const Json& found) {
  Json json = reportHead("solid", report.status, report.code, report.message);
  json["input"] = job.meshPath;
  json.update(found);
  json["warnings"] = findingsJson(report.warnings);
  writeReport(json, job.common.report);
}

int runEstimate(const SolidJob& job) {
  std::optional<SolidEstimate> estimate;
  const Report report = runOnMesh(job, {}, [&](const TriMesh& mesh, RunContext& run) {
    const bool named = !job.outputPath.empty() && job.outputPath != "-";
    const SolidFormat format = solidFormatOf(named ? job.outputPath : "solid." + job.outputFormat);
    estimate = trySolid(mesh, job.options, format, run);
    return std::vector<Finding>();
  });
  Json found = Json::object();
  if (estimate) found["estimate"] = Json::parse(toJson(*estimate));
  writeSolidReport(job, report, found);
  if (estimate && job.common.report != "-") printEstimate(*estimate);
  if (report.status != Status::Ok) printError(report.status, report.code, report.message);
  return exitStatus(report.status);
}

int runSolid(const SolidJob& job) {
  const CommonOptions& common = job.common;
  WrittenSolid solid;
  const Report report =
      runOnMesh(job, {{"--output", job.outputPath}}, [&](const TriMesh& mesh, RunContext& run) {
        writeOutputFile(job.outputPath, job.outputFormat, [&](const std::string& path) {
          solid = writeSolid(mesh, path, job.options, run);
        });
        return solid.warnings;
      });
  const bool made = solid.fileBytes > 0;
  Json found = Json::object();
  if (made) {
    found["output"] = job.outputPath;
    found["solid"] = Json::parse(toJson(solid));
  }
  writeSolidReport(job, report, found);
  if (made && !common.quiet && common.report != "-" && job.outputPath != "-")
    printSolid(solid, job.outputPath);
  printFindings(report.warnings, common.quiet);
  if (report.status != Status::Ok) printError(report.status, report.code, report.message);
  return exitStatus(report.status);
}

}  // namespace

Run addSolidCommand(CLI::App& program) {
  const auto job = std::make_shared<SolidJob>();
  CLI::App& app = *program.add_subcommand("solid",
                                          "Converts a closed mesh to a solid. The new file is read "
                                          "back and checked before it replaces an old one.");
  addText(app, "MESH", "FILE", job->meshPath,
          "closed mesh to convert: a file of type ply, stl, obj or off, or - for standard input")
      ->required();
  addText(app, "-o,--output", "FILE", job->outputPath,
          "file to write, of type step, stp, brep or brp, or - for standard output");
  app.add_flag("--estimate", job->estimate,
               "print how many faces, megabytes and seconds the solid needs; the solid is built, "
               "but not written");
  addText(app, "--format", "ply|stl|obj|off", job->meshFormat,
          "format of the mesh, in place of its file extension");
  addText(app, "--output-format", "step|brep", job->outputFormat,
          "format of the output if it is written to standard output (default step)");
  addUnit(app, "--unit", job->unit, "unit of the numbers in the mesh (default mm)");
  addCommonOptions(app, job->common);
  addSolidOptions(app, job->options);
  app.footer(
      "Examples:\n  swept solid envelope.ply -o envelope.step\n"
      "  swept solid envelope.ply -o envelope.step --solid-tolerance 0.1 --author \"A. Maker\"\n"
      "  swept solid envelope.ply --solid-tolerance 0.1 --estimate");
  app.callback([job, &app] {
    if (!job->estimate && job->outputPath.empty())
      throw CLI::RequiredError("--output (or --estimate)");
    if (app.count("--output-format") > 0)
      checkStreamFormat("--output-format", job->outputFormat, job->outputPath);
  });
  return [job] {
    job->options.strict = job->common.strict;
    if (job->common.strict && job->options.tolerance <= 0) job->options.exact = true;
    return job->estimate ? runEstimate(*job) : runSolid(*job);
  };
}

}  // namespace swept::cli
#endif
