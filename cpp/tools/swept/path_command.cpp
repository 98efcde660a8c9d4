// swept path PART --goal POSE NEIGHBOUR...: how the part gets to its place, clear all the way.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <cstdio>
#include <locale>
#include <memory>
#include <numbers>
#include <sstream>

#include "commands.h"
#include "neighbours.h"
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

std::vector<double> numbersOf(const std::string& name, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream fields(text);
  for (std::string field; std::getline(fields, field, ',');)
    numbers.push_back(numberOf(name, field));
  return numbers;
}

Pose poseOf(const std::string& name, const std::string& text) {
  const std::vector<double> n = numbersOf(name, text);
  if (n.size() != 3 && n.size() != 7)
    badOption(name + " is '" + text +
              "'; a placement is x,y,z in mm or x,y,z,qx,qy,qz,qw with a unit quaternion");
  Pose pose;
  pose.translation = {n[0], n[1], n[2]};
  if (n.size() == 7) pose.rotation = Eigen::Quaterniond(n[6], n[3], n[4], n[5]);
  return pose;
}

Extraction extractionOf(const std::string& text) {
  const std::vector<double> n = numbersOf("--extract", text);
  Extraction extraction;
  if (n.size() == 1)
    extraction.radius = n[0];
  else if (n.size() == 3)
    extraction.direction = Eigen::Vector3d(n[0], n[1], n[2]);
  else
    badOption("--extract is '" + text + "'; allowed: a radius in mm or a direction x,y,z");
  return extraction;
}

void addPlaces(CLI::App& app, PathJob& job) {
  addText(app, "PART", "FILE", job.partPath,
          "the part: ply, stl, obj, off, step, stp, brep or brp; - for standard input")
      ->required();
  addNeighbourOptions(app, job.neighbours);
  addRuleOptions(app, job.neighbours);
  addConverted(
      app, "--goal", "X,Y,Z[,QX,QY,QZ,QW]",
      [&job](const std::string& t) { job.task.goal = poseOf("--goal", t); },
      "where the part belongs (default: as it stands in its file)");
  addConverted(
      app, "--start", "X,Y,Z[,QX,QY,QZ,QW]",
      [&job](const std::string& t) { job.task.start = poseOf("--start", t); },
      "where it comes from");
  addConverted(
      app, "--extract", "RADIUS|X,Y,Z",
      [&job](const std::string& t) { job.task.extraction = extractionOf(t); },
      "instead of a start: just get it out, so far (mm) or past all neighbours in this direction");
  app.add_option_function<std::vector<std::string>>(
         "--via",
         [&job](const std::vector<std::string>& list) {
           for (const std::string& t : list) job.task.via.push_back(poseOf("--via", t));
         },
         "a placement that the path has to pass; may be given again, from start to goal")
      ->type_name("X,Y,Z[,QX,QY,QZ,QW]")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addOptions(CLI::App& app, PathJob& job) {
  addPlaces(app, job);
  PathOptions& o = job.options;
  addNumber(app, "--clearance", "MM", o.clearance,
            "distance to keep from every neighbour (default 0: more than the tolerance)");
  addNumber(app, "--tolerance", "MM", o.tolerance, "as for swept clearance (default 0.01)");
  addNumber(app, "--release", "MM", o.release,
            "contact is allowed until the part is so far out (default 0)");
  app.add_flag_callback(
      "--translation-only", [&o] { o.translationOnly = true; }, "the part never turns");
  addConverted(
      app, "--max-angle", "DEG",
      [&o](const std::string& t) {
        o.largestTurn = numberOf("--max-angle", t) * std::numbers::pi / 180;
      },
      "largest turn from how the part stands at the goal (default 180)");
  addNumber(app, "--budget", "S", o.budgetSeconds, "time after which a search ends (default 60)");
  addInteger(app, "--seed", job.seed, 0, std::int64_t{1} << 53,
             "another seed, perhaps another path (default 1)");
  addConverted(
      app, "--interpolation", "linear|screw",
      [&o](const std::string& t) { o.interpolation = parseInterpolation(t); },
      "motion between two keys (default linear)");
  addText(app, "--generator-format", "ply|stl|obj|off|step|brep", job.partFormat,
          "format of the part, instead of its suffix");
  addUnit(app, "--generator-unit", job.partUnit, "unit of the part's numbers (default mm)");
  addNumber(app, "--generator-chord", "MM", o.bodyChordError,
            "how far the part's triangles leave its exact surface (default 0)");
  addText(app, "-o,--output", "FILE", job.output, "write the keys; - for standard output");
  addCommonOptions(app, job.common);
  app.footer(
      "Exit status 0 if a path is found, 3 if not.\n\nExamples:\n"
      "  swept path starter.stl bay.step --extract 300 --clearance 2 -o path.csv\n"
      "  swept path pin.stl plate.stl --start 0,0,80 --release 12 --clearance 0.5 -o path.csv");
}

std::string tableOf(const Trajectory& path) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << "t,tx,ty,tz,qx,qy,qz,qw\n";
  for (const Pose& pose : path.poses) {
    const Eigen::Vector3d& x = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    text << pose.timeSeconds << ',' << x[0] << ',' << x[1] << ',' << x[2] << ',' << q.x() << ','
         << q.y() << ',' << q.z() << ',' << q.w() << '\n';
  }
  return text.str();
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
  const auto report = runReported<PathReport>(common, inputs, outputs,
                                              [&](RunContext& run) { return compute(job, run); });
  if (report.status != Status::Ok) return exitStatus(report.status);
  const bool found = report.verdict == PathVerdict::Found;
  if (found && !job.output.empty()) writeText(tableOf(report.path), job.output);
  if (!common.quiet && common.report != "-" && job.output != "-")
    std::printf("%s; %.2f s\n", report.summary.c_str(), report.seconds.back().seconds);
  return finishReported(report, common, found);
}

}  // namespace

Run addPathCommand(CLI::App& program) {
  const auto job = std::make_shared<PathJob>();
  CLI::App& app = *program.add_subcommand(
      "path",
      "How a part gets to its place between parts that stand still: a motion of few keys "
      "that is clear of them between the keys as well.");
  addOptions(app, *job);
  return [job] {
    checkNeighbourOptions(job->neighbours, "");  // it is placed elsewhere
    return runPath(*job);
  };
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
