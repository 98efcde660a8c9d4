// swept mechanism --moving PART MOTION ...: measures distances of parts that move at the same time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <algorithm>
#include <cstdio>
#include <locale>
#include <memory>
#include <sstream>

#include "commands.h"
#include "neighbours.h"
#include "page_file.h"
#include "reported_run.h"
#include "swept/body.h"
#include "swept/io.h"
#include "swept/mechanism.h"

namespace swept::cli {
namespace {

struct MechanismJob {
  std::vector<std::string> moving;   ///< part, motion, part, motion, ...
  std::vector<std::string> ignored;  ///< name, name, ...
  std::vector<std::string> rules;    ///< name, name, rule, ...
  NeighbourFiles still;
  std::string csvPath;
  double partUnit = 1.0;
  double motionUnit = 1.0;
  Interpolation interpolation = Interpolation::Linear;
  MechanismOptions options;
  std::int64_t curve = -1;  ///< points of the graph; -1: 200 if there is a page, else 0
  std::int64_t stamp = -1;
  PageJob page;
  CommonOptions common;
};

void addOptions(CLI::App& app, MechanismJob& job) {
  addWords(app, "--moving", 2, "PART MOTION", job.moving,
           "a moving part and the table of its poses, as for \"swept envelope\". The part takes "
           "the name of its file PART. Repeat the option for each moving part");
  addNeighbourOptions(app, job.still)->required(false);
  addUnit(app, "--moving-unit", job.partUnit,
          "unit of the numbers in moving parts that are meshes (default mm)");
  addUnit(app, "--motion-unit", job.motionUnit,
          "unit of the translations in the motions (default mm)");
  addConverted(
      app, "--interpolation", "linear|screw",
      [&job](const std::string& t) { job.interpolation = parseInterpolation(t); },
      "how a part moves between two poses (default linear). With screw, parts of one "
      "rigid body do not move relative to each other between two poses");
  addDistanceOptions(app, job.options);
  addNumber(
      app, "--range", "MM", job.options.range,
      "list the pairs that come closer than this (default 0: a tenth of the median size of the "
      "parts, or more if a rule needs it)");
  addWords(
      app, "--rule", 3, "PART PART RULE", job.rules,
      "rule for one pair of parts, in place of the required distance: a distance in mm, contact, "
      "contact:MM (the parts may overlap by at most MM mm) or ignore. Repeat the option for each "
      "pair");
  addWords(app, "--ignore", 2, "PART PART", job.ignored,
           "do not check this pair, for example parts that are connected by a joint; the same as "
           "--rule PART PART ignore");
  addDetailOptions(app, job.options, job.curve,
                   "number of points of the graph of distance over time in the report (default 0: "
                   "no graph; with --page 200)",
                   job.stamp);
  addText(app, "--csv", "FILE", job.csvPath,
          "write the results as a CSV table, or - for standard output");
  addPageOptions(app, job.page);
  addCommonOptions(app, job.common);
  app.footer(
      "Exit status 0 if all pairs meet their rules, 3 if a pair is below the required distance, or "
      "in a contact or clash that no rule allows.\n\n"
      "Examples:\n"
      "  swept mechanism --moving boom.stl boom.csv --moving arm.stl arm.csv frame.step "
      "--ignore boom arm --required 5\n"
      "  swept mechanism --moving left.ply left.csv --moving right.ply right.csv --csv -\n"
      "  swept mechanism --moving boom.stl boom.csv frame.step --page report.html");
}

std::vector<MechanismPart> readParts(const MechanismJob& job, RunContext& run,
                                     std::vector<Finding>& findings) {
  std::vector<MechanismPart> parts;
  BodyFileOptions files;
  files.millimetresPerUnit = job.partUnit;
  files.tolerance = job.still.deflection;
  for (std::size_t i = 0; i + 1 < job.moving.size(); i += 2) {
    Body body = readInputBody(job.moving[i], "", files, run);
    const std::string name = utf8FromPath(pathFromUtf8(job.moving[i]).stem());
    for (Finding& finding : body.findings) {
      finding.text = name + ": " + finding.text;
      findings.push_back(std::move(finding));
    }
    parts.push_back({name, std::move(body.mesh),
                     readInputMotion(job.moving[i + 1], job.motionUnit, job.interpolation,
                                     Eigen::Vector3d::Zero()),
                     body.chordError});
  }
  std::vector<ClearanceNeighbour> still = readNeighbours(job.still, run);
  makeNamesUnique(still);
  for (ClearanceNeighbour& part : still)
    parts.push_back({part.name, std::move(part.mesh), {{Pose{}}}, part.chordError});
  return parts;
}

std::vector<PageInput> pageInputs(const MechanismJob& job) {
  std::vector<PageInput> rows;
  if (job.page.path.empty()) return rows;
  for (std::size_t i = 0; i < job.moving.size(); ++i)
    rows.push_back(inputRow(i % 2 == 0 ? "body" : "motion", job.moving[i]));
  for (const std::string& path : job.still.paths) rows.push_back(inputRow("neighbour", path));
  return rows;
}

std::string pageText(const MechanismJob& job, const PageFrame& frame, std::vector<PageInput> inputs,
                     std::vector<MechanismPart> parts, const MechanismReport& report,
                     RunContext& run) {
  std::vector<PagePart> shown;
  for (MechanismPart& part : parts) {
    const bool moves = part.motion.poses.size() > 1;
    shown.push_back({std::move(part.name), std::move(part.mesh),
                     moves ? std::move(part.motion) : Trajectory{}, moves});
  }
  return makePage(job.page, frame, toJson(report), std::move(inputs), std::move(shown), run);
}

void compareWithStamps(const MechanismJob& job, const std::vector<MechanismPart>& parts,
                       const MechanismReport& report, RunContext& run) {
  for (const PairClearance& pair : report.pairs) {
    const StampedClearance least = stampedPair(parts[pair.parts.first], parts[pair.parts.second],
                                               report.time, static_cast<int>(job.stamp), run);
    std::printf(
        "sampled at %lld times, pair %s: smallest distance %.9g mm at t = %.9g s; over the "
        "continuous motion: %.9g mm\n",
        static_cast<long long>(least.poses), pair.clearance.name.c_str(), least.distance,
        least.timeSeconds, pair.clearance.distance);
  }
}

void writeCsv(const MechanismReport& report, const std::string& path) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "first,second,verdict,distance_mm,guaranteed_mm,required_mm,time_s,depth_mm,"
          "depth_bound_mm,first_x,first_y,first_z,second_x,second_y,second_z,seconds_below\n";
  text.precision(12);
  for (const PairClearance& pair : report.pairs) {
    const NeighbourClearance& row = pair.clearance;
    double below = 0;
    for (const TimeInterval& span : row.below) below += span.to - span.from;
    text << quoted(report.names[pair.parts.first]) << ',' << quoted(report.names[pair.parts.second])
         << ',' << clearanceVerdictName(row.verdict) << ',' << row.distance << ',' << row.guaranteed
         << ',' << pair.required << ',' << row.timeSeconds << ',' << row.penetration.depth << ','
         << row.penetration.depthBound;
    for (const Eigen::Vector3d& x : {row.pointOnBody, row.pointOnNeighbour})
      text << ',' << x[0] << ',' << x[1] << ',' << x[2];
    text << ',' << below << '\n';
  }
  writeText(text.str(), path);
}

void printTable(const MechanismReport& report) {
  for (const PairClearance& pair : report.pairs) {
    const NeighbourClearance& row = pair.clearance;
    std::printf("%-36s %-8s %12.6g mm at t = %.6g s", row.name.c_str(),
                clearanceVerdictName(row.verdict), row.distance, row.timeSeconds);
    if (row.verdict == ClearanceVerdict::Clash && row.penetration.known)
      std::printf(", depth %.4g to %.4g mm", row.penetration.depth, row.penetration.depthBound);
    std::printf("  (%.2f s)\n", row.seconds);
  }
  std::printf(
      "%lld pairs stay farther apart than %.4g mm, %zu pairs do not move relative to each other, "
      "%zu pairs are ignored\n",
      static_cast<long long>(report.farPairs), report.range, report.joined.size(),
      report.ignored.size());
  std::printf("%s; %.2f s\n", report.summary.c_str(),
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
}

int runMechanism(const MechanismJob& job) {
  const CommonOptions& common = job.common;
  std::vector<RoledFile> inputs;
  for (std::size_t i = 0; i < job.moving.size(); ++i)
    inputs.push_back({i % 2 == 0 ? "a moving part" : "a motion", job.moving[i]});
  for (const std::string& path : job.still.paths)
    inputs.push_back({"a part that stands still", path});
  addTemplate(job.page, inputs);
  const std::vector<RoledFile> outputs{
      {"--csv", job.csvPath}, {"--report", common.report}, {"--page", job.page.path}};
  std::string page;
  const auto compute = [&](RunContext& run) {
    std::vector<Finding> findings;
    const PageFrame frame = beginPage(job.page);
    std::vector<PageInput> read = pageInputs(job);
    std::vector<MechanismPart> parts = readParts(job, run, findings);
    MechanismReport found = checkMechanism(parts, job.options, run);
    found.warnings.insert(found.warnings.begin(), findings.begin(), findings.end());
    if (job.stamp >= 0 && found.status == Status::Ok) compareWithStamps(job, parts, found, run);
    if (!job.page.path.empty() && found.status == Status::Ok)
      page = pageText(job, frame, std::move(read), std::move(parts), found, run);
    return found;
  };
  const auto report = runReported<MechanismReport>(common, inputs, outputs, compute,
                                                   [&](const MechanismReport& found) {
                                                     if (!job.csvPath.empty())
                                                       writeCsv(found, job.csvPath);
                                                     if (!job.page.path.empty())
                                                       writeText(page, job.page.path);
                                                   });
  if (report.status != Status::Ok) return exitStatus(report.status);
  const bool isTaken = common.report == "-" || job.csvPath == "-" || job.page.path == "-";
  if (!common.quiet && !isTaken) printTable(report);
  return finishReported(report, common,
                        std::all_of(report.pairs.begin(), report.pairs.end(),
                                    [](const auto& pair) { return pair.clearance.meetsRule(); }));
}

}  // namespace

Run addMechanismCommand(CLI::App& program) {
  const auto job = std::make_shared<MechanismJob>();
  CLI::App& app = *program.add_subcommand(
      "mechanism",
      "Measures the smallest distances between parts that move at the same time, each with its own "
      "motion, and to parts that stand still. No approach between two poses is missed.");
  addOptions(app, *job);
  return [job] {
    checkNeighbourOptions(job->still, "");
    checkPageOptions(job->page);
    if (job->curve < 0) job->curve = job->page.path.empty() ? 0 : 200;
    if (job->moving.empty())
      badOption("--moving PART MOTION is missing; give at least one moving part");
    for (std::size_t i = 0; i + 1 < job->ignored.size(); i += 2)
      job->options.rules.push_back({job->ignored[i], job->ignored[i + 1], parseRule("ignore")});
    for (std::size_t i = 0; i + 2 < job->rules.size(); i += 3)
      job->options.rules.push_back(
          {job->rules[i], job->rules[i + 1], parseRule(job->rules[i + 2])});
    job->options.curveSamples = static_cast<int>(job->curve);
    return runMechanism(*job);
  };
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
