// swept clearance BODY --motion CSV NEIGHBOUR...: measures smallest distances over a motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <algorithm>
#include <cstdio>
#include <locale>
#include <map>
#include <memory>
#include <sstream>

#include "base/number_text.h"
#include "commands.h"
#include "neighbours.h"
#include "page_file.h"
#include "reported_run.h"
#include "swept/body.h"
#include "swept/clearance.h"
#include "swept/io.h"

namespace swept::cli {

namespace {

struct ClearanceJob {
  std::string bodyPath, bodyFormat, motionPath, csvPath, offerPath;
  NeighbourFiles neighbours;
  double bodyUnit = 1.0;
  double motionUnit = 1.0;
  Interpolation interpolation = Interpolation::Linear;
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  ClearanceOptions options;
  std::int64_t curve = 200;
  std::int64_t stamp = -1;
  PageJob page;
  CommonOptions common;
};

void addFileOptions(CLI::App& app, ClearanceJob& job) {
  addText(app, "BODY", "FILE", job.bodyPath,
          "the moving part: a file of type ply, stl, obj, off, step, stp, brep or brp, or - for "
          "standard input")
      ->required();
  addNeighbourOptions(app, job.neighbours);
  addRuleOptions(app, job.neighbours);
  addText(app, "--motion", "FILE", job.motionPath,
          "table of poses, as for \"swept envelope\", or - for standard input")
      ->required();
  addText(app, "--body-format", "ply|stl|obj|off|step|brep", job.bodyFormat,
          "format of the moving part, in place of its file extension");
  addUnit(app, "--body-unit", job.bodyUnit,
          "unit of the numbers in a moving part that is a mesh (default mm)");
  addUnit(app, "--motion-unit", job.motionUnit,
          "unit of the translations in the motion (default mm)");
  addText(app, "--csv", "FILE", job.csvPath,
          "write the results as a CSV table, or - for standard output");
  addText(app, "--offer-rules", "FILE", job.offerPath,
          "write the contacts at the first pose as rules and check nothing else, or - for standard "
          "output. Read the file, remove contacts that are not intended, and use it with --rules");
}

void addOptions(CLI::App& app, ClearanceJob& job) {
  addFileOptions(app, job);
  addDistanceOptions(app, job.options);
  addConverted(
      app, "--interpolation", "none|linear|screw",
      [&job](const std::string& t) { job.interpolation = parseInterpolation(t); },
      "how the part moves between two poses (default linear); none: only the poses themselves are "
      "checked");
  addPoint(
      app, "--pivot", job.pivot,
      "point of the moving part that moves in a straight line between two poses, used only with "
      "linear interpolation; coordinates in mm (default 0,0,0: the origin)");
  addNumber(app, "--body-chord", "MM", job.options.bodyChordError,
            "how far the triangles of the moving part deviate from its exact surface (default 0)");
  keepGeneratorNames(app, "--body-", {"format", "unit", "chord"});
  addDetailOptions(app, job.options, job.curve,
                   "number of points of the graph of distance over time (default 200; 0: no graph)",
                   job.stamp);
  addPageOptions(app, job.page);
  addCommonOptions(app, job.common);
  app.footer(
      "Exit status 0 if every neighbour meets its rule, 3 if one is below the required distance, "
      "or in a contact or clash that no rule allows.\n\nExamples:\n  swept clearance gripper.stl "
      "housing.step "
      "bracket.stl --motion path.csv --required 2\n  swept clearance gripper.stl bolt_1.stl "
      "bolt_2.stl cover.step --motion path.csv --required 2 --rule 'bolt*=contact' --rule "
      "cover=5\n  swept clearance gripper.stl housing.step --motion path.csv --csv - --quiet\n  "
      "swept clearance gripper.stl housing.step --motion path.csv --page report.html");
}

void compareWithStamps(const ClearanceJob& job, const TriMesh& body, const Trajectory& motion,
                       const std::vector<ClearanceNeighbour>& parts, const ClearanceReport& report,
                       RunContext& run) {
  std::size_t row = 0;
  for (const ClearanceNeighbour& part : parts) {
    if (part.rule.ignored) continue;
    const StampedClearance least =
        stampedClearance(body, motion, part.mesh, static_cast<int>(job.stamp), run);
    std::printf(
        "sampled at %lld poses against %s: smallest distance %.9g mm at t = %.9g s; over the "
        "continuous motion: %.9g mm\n",
        static_cast<long long>(least.poses), part.name.c_str(), least.distance, least.timeSeconds,
        report.neighbours[row++].distance);
  }
}

double secondsBelow(const NeighbourClearance& row) {
  double seconds = 0;
  for (const TimeInterval& span : row.below) seconds += span.to - span.from;
  return seconds;
}

void writeCsv(const ClearanceReport& report, const std::string& path) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text
      << "neighbour,verdict,distance_mm,guaranteed_mm,time_s,depth_mm,depth_bound_mm,"
         "body_x,body_y,body_z,neighbour_x,neighbour_y,neighbour_z,seconds_below,rule,meets_rule\n";
  text.precision(12);
  for (const NeighbourClearance& row : report.neighbours) {
    text << quoted(row.name) << ',' << clearanceVerdictName(row.verdict) << ',' << row.distance
         << ',' << row.guaranteed << ',' << row.timeSeconds << ',' << row.penetration.depth << ','
         << row.penetration.depthBound;
    for (const Eigen::Vector3d& x : {row.pointOnBody, row.pointOnNeighbour})
      text << ',' << x[0] << ',' << x[1] << ',' << x[2];
    text << ',' << secondsBelow(row) << ',' << ruleText(row.rule) << ','
         << (row.meetsRule() ? "yes" : "no") << '\n';
  }
  for (const std::string& name : report.ignored) text << quoted(name) << ",,,,,,,,,,,,,,ignore,\n";
  writeText(text.str(), path);
}

// Returns the lines of a file of rules that allow the contacts. Neighbours with the same name share
// one line, with the deepest of their contacts.
std::string offeredRules(const ClearanceReport& report) {
  std::map<std::string, double> depths;
  for (const NeighbourClearance& row : report.neighbours)
    if (row.rule.contact) depths[row.name] = std::max(depths[row.name], *row.rule.contact);
  std::string text = "# Contacts at the first pose: " + std::to_string(depths.size()) +
                     " of the neighbours. Remove the contacts that are not intended.\n";
  for (const auto& [name, depth] : depths) {
    NeighbourRule rule;
    rule.contact = depth;
    text += name + "=" + ruleText(rule) + "\n";
  }
  for (const NeighbourClearance& row : report.neighbours)
    if (row.verdict == ClearanceVerdict::Clash && !row.rule.contact)
      text += "# " + row.name +
              " overlaps, but no rule can be offered: the mesh is open, so its depth is unknown. "
              "Repair the mesh.\n";
  return text;
}

/// Prints a line for each neighbour. With `details`, the line also has the effort of the check.
void printTable(const ClearanceReport& report, bool details) {
  for (const NeighbourClearance& row : report.neighbours) {
    std::printf("%-28s %-8s %12.6g mm at t = %.6g s", row.name.c_str(),
                clearanceVerdictName(row.verdict), row.distance, row.timeSeconds);
    if (row.verdict == ClearanceVerdict::Clash && row.penetration.known)
      std::printf(", depth %.4g to %.4g mm", row.penetration.depth, row.penetration.depthBound);
    if (!row.below.empty())
      std::printf(", below the required distance in %s (%.4g s)",
                  counted(std::ssize(row.below), "time span").c_str(), secondsBelow(row));
    if (row.verdict == ClearanceVerdict::Contact && row.meetsRule()) std::printf(", allowed");
    if (details)
      std::printf("  (checked in %.2f s with %lld distance queries and %lld proofs)", row.seconds,
                  static_cast<long long>(row.distanceQueries),
                  static_cast<long long>(row.certificates));
    std::printf("\n");
  }
  std::printf("%s; %.2f s\n", report.summary.c_str(),
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
}

Body readMovingBody(const ClearanceJob& job, RunContext& run) {
  BodyFileOptions options;
  options.millimetresPerUnit = job.bodyUnit;
  options.tolerance = job.neighbours.deflection;
  return readInputBody(job.bodyPath, job.bodyFormat, options, run);
}

Trajectory readMotion(const ClearanceJob& job) {
  return readInputMotion(job.motionPath, job.motionUnit, job.interpolation, job.pivot);
}

std::vector<PageInput> pageInputs(const ClearanceJob& job) {
  std::vector<PageInput> rows;
  if (job.page.path.empty()) return rows;
  rows = {inputRow("body", job.bodyPath), inputRow("motion", job.motionPath)};
  for (const std::string& path : job.neighbours.paths) rows.push_back(inputRow("neighbour", path));
  if (!job.neighbours.rulesPath.empty())
    rows.push_back(inputRow("rules", job.neighbours.rulesPath));
  return rows;
}

std::string pageText(const ClearanceJob& job, const PageFrame& frame, std::vector<PageInput> inputs,
                     Body body, Trajectory motion, std::vector<ClearanceNeighbour> neighbours,
                     const ClearanceReport& report, RunContext& run) {
  std::vector<PagePart> parts{{utf8FromPath(pathFromUtf8(job.bodyPath).stem()),
                               std::move(body.mesh), std::move(motion), true}};
  for (ClearanceNeighbour& part : neighbours)
    parts.push_back({std::move(part.name), std::move(part.mesh)});
  return makePage(job.page, frame, toJson(report), std::move(inputs), std::move(parts), run);
}

/// Reads the inputs and computes the report. `page` receives the page if --page is given.
ClearanceReport compute(const ClearanceJob& job, std::string& page, RunContext& run) {
  const PageFrame frame = beginPage(job.page);
  std::vector<PageInput> inputs = pageInputs(job);
  Body body = readMovingBody(job, run);
  Trajectory motion = readMotion(job);
  std::vector<ClearanceNeighbour> parts = readNeighbours(job.neighbours, run);
  ClearanceOptions options = job.options;
  options.bodyChordError += body.chordError;
  if (!job.offerPath.empty()) return firstContacts(body.mesh, motion, parts, options, run);
  ClearanceReport report = checkClearance(body.mesh, motion, parts, options, run);
  report.warnings.insert(report.warnings.begin(), body.findings.begin(), body.findings.end());
  if (job.stamp >= 0 && report.status == Status::Ok)
    compareWithStamps(job, body.mesh, motion, parts, report, run);
  if (!job.page.path.empty() && report.status == Status::Ok)
    page = pageText(job, frame, std::move(inputs), std::move(body), std::move(motion),
                    std::move(parts), report, run);
  return report;
}

int runClearance(const ClearanceJob& job) {
  const CommonOptions& common = job.common;
  std::vector<RoledFile> inputs{{"the moving part", job.bodyPath}, {"the motion", job.motionPath}};
  for (const std::string& path : job.neighbours.paths) inputs.push_back({"a neighbour", path});
  if (!job.neighbours.rulesPath.empty()) inputs.push_back({"--rules", job.neighbours.rulesPath});
  addTemplate(job.page, inputs);
  const std::vector<RoledFile> outputs{{"--csv", job.csvPath},
                                       {"--report", common.report},
                                       {"--offer-rules", job.offerPath},
                                       {"--page", job.page.path}};
  std::string page;
  const auto report = runReported<ClearanceReport>(
      common, inputs, outputs, [&](RunContext& run) { return compute(job, page, run); },
      [&](const ClearanceReport& found) {
        if (!job.offerPath.empty()) writeText(offeredRules(found), job.offerPath);
        if (!job.csvPath.empty()) writeCsv(found, job.csvPath);
        if (!job.page.path.empty()) writeText(page, job.page.path);
      });
  if (report.status != Status::Ok) return exitStatus(report.status);
  if (!job.offerPath.empty()) {
    printFindings(report.warnings, common.quiet);
    return kExitOk;
  }
  const bool isTaken = common.report == "-" || job.csvPath == "-" || job.page.path == "-";
  if (!common.quiet && !isTaken) printTable(report, common.verbose);
  return finishReported(report, common,
                        std::all_of(report.neighbours.begin(), report.neighbours.end(),
                                    [](const auto& row) { return row.meetsRule(); }));
}

}  // namespace

Run addClearanceCommand(CLI::App& program) {
  const auto job = std::make_shared<ClearanceJob>();
  CLI::App& app = *program.add_subcommand(
      "clearance",
      "Measures the smallest distances between a moving part and parts that stand still, over the "
      "whole motion. No approach between two poses is missed.");
  addOptions(app, *job);
  return [job] {
    checkNeighbourOptions(job->neighbours, job->bodyPath);
    checkPageOptions(job->page);
    if (!job->page.path.empty() && !job->offerPath.empty())
      badOption(
          "--page cannot be combined with --offer-rules, which checks nothing; leave out one of "
          "them");
    job->options.curveSamples = static_cast<int>(job->curve);
    return runClearance(*job);
  };
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
