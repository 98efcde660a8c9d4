// swept path PART --goal POSE NEIGHBOUR...: finds a path without collisions to the installed
// position.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <cstdio>
#include <memory>

#include "commands.h"
#include "neighbours.h"
#include "path_options.h"
#include "reported_run.h"
#include "swept/body.h"
#include "swept/path.h"

namespace swept::cli {

namespace {

struct PathJob {
  std::string partPath, partFormat, output;
  double partUnit = 1;
  NeighbourFiles neighbours;
  PathTask task;
  PathOptions options;
  std::int64_t seed = 1;
  CommonOptions common;
};

void addPlacements(CLI::App& app, PathJob& job) {
  addText(app, "PART", "FILE", job.partPath,
          "the part to install: a file of type ply, stl, obj, off, step, stp, brep or brp, or - "
          "for standard input")
      ->required();
  addNeighbourOptions(app, job.neighbours);
  addRuleOptions(app, job.neighbours);
  addConverted(
      app, "--goal", "X,Y,Z[,QX,QY,QZ,QW]",
      [&job](const std::string& t) { job.task.goal = placementOf("--goal", t); },
      "placement of the part at the end of the path: mm, and a unit quaternion (default: the "
      "placement in its file)");
  addConverted(
      app, "--start", "X,Y,Z[,QX,QY,QZ,QW]",
      [&job](const std::string& t) { job.task.start = placementOf("--start", t); },
      "placement of the part at the start of the path");
  addConverted(
      app, "--extract", "RADIUS|X,Y,Z",
      [&job](const std::string& t) { job.task.extraction = extractionOf("--extract", t); },
      "in place of a start: take the part out to this distance (mm), or in this direction past all "
      "neighbours");
  app.add_option_function<std::vector<std::string>>(
         "--via",
         [&job](const std::vector<std::string>& list) {
           for (const std::string& t : list) job.task.via.push_back(placementOf("--via", t));
         },
         "a placement through which the path must pass. Repeat the option for more placements, in "
         "order from start to goal")
      ->type_name("X,Y,Z[,QX,QY,QZ,QW]")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addOptions(CLI::App& app, PathJob& job) {
  addPlacements(app, job);
  addSearchOptions(app, job.options, job.seed);
  addText(app, "--part-format", "ply|stl|obj|off|step|brep", job.partFormat,
          "format of the part, in place of its file extension");
  addUnit(app, "--part-unit", job.partUnit,
          "unit of the numbers in a part that is a mesh (default mm)");
  addNumber(app, "--part-chord", "MM", job.options.bodyChordError,
            "how far the triangles of the part deviate from its exact surface (default 0)");
  keepGeneratorNames(app, "--part-", {"format", "unit", "chord"});
  addText(app, "-o,--output", "FILE", job.output,
          "write the keys of the path as a table of poses, or - for standard output");
  addCommonOptions(app, job.common);
  app.footer(
      "Exit status 0 if a path is found, 3 if not.\n\nExamples:\n"
      "  swept path starter.stl bay.step --extract 300 --clearance 2 -o path.csv\n"
      "  swept path pin.stl plate.stl --start 0,0,80 --release 12 --clearance 0.5 -o path.csv");
}

PathReport compute(const PathJob& job, RunContext& run) {
  BodyFileOptions file;
  file.millimetresPerUnit = job.partUnit;
  file.tolerance = job.neighbours.deflection;
  const Body part = readInputBody(job.partPath, job.partFormat, file, run);
  const std::vector<ClearanceNeighbour> neighbours = readNeighbours(job.neighbours, run);
  PathOptions options = job.options;
  options.bodyChordError += part.chordError;
  options.seed = static_cast<std::uint64_t>(job.seed);
  PathReport report = findPath(part.mesh, job.task, neighbours, options, run);
  report.warnings.insert(report.warnings.begin(), part.findings.begin(), part.findings.end());
  return report;
}

int runPath(const PathJob& job) {
  const CommonOptions& common = job.common;
  std::vector<RoledFile> inputs{{"the part", job.partPath}};
  for (const std::string& path : job.neighbours.paths) inputs.push_back({"a neighbour", path});
  if (!job.neighbours.rulesPath.empty()) inputs.push_back({"--rules", job.neighbours.rulesPath});
  const std::vector<RoledFile> outputs{{"--output", job.output}, {"--report", common.report}};
  const auto isFound = [](const PathReport& r) { return r.verdict == PathVerdict::Found; };
  const auto report = runReported<PathReport>(
      common, inputs, outputs, [&](RunContext& run) { return compute(job, run); },
      [&](const PathReport& r) {
        if (isFound(r) && !job.output.empty()) writeText(motionTable(r.path), job.output);
      });
  if (report.status != Status::Ok) return exitStatus(report.status);
  if (!common.quiet && common.report != "-" && job.output != "-")
    std::printf("%s; %.2f s\n", report.summary.c_str(), report.seconds.back().seconds);
  return finishReported(report, common, isFound(report));
}

}  // namespace

Run addPathCommand(CLI::App& program) {
  const auto job = std::make_shared<PathJob>();
  CLI::App& app = *program.add_subcommand(
      "path",
      "Finds an installation path: a motion with few keys on which a part reaches its installed "
      "position and keeps its distance from parts that stand still, also between the keys.");
  addOptions(app, *job);
  return [job] {
    checkNeighbourOptions(job->neighbours, "");  // the part's own file may be a neighbour, too
    return runPath(*job);
  };
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
