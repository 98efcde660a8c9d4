// swept sequence --part PART HOW ...: finds paths for parts that are installed one after the other.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "neighbours.h"
#include "path_options.h"
#include "reported_run.h"
#include "swept/body.h"
#include "swept/io.h"
#include "swept/sequence.h"

namespace swept::cli {
namespace {

struct SequenceJob {
  std::vector<std::string> parts;    ///< file, how, file, how, ...
  std::vector<std::string> rules;    ///< name, name, rule, ...
  std::vector<std::string> ignored;  ///< name, name, ...
  NeighbourFiles still;
  std::string folder;
  double partUnit = 1, partChord = 0;
  SequenceOptions options;
  std::int64_t seed = 1;
  CommonOptions common;
};

constexpr const char* kHow =
    "out:R (the part comes from any place at least R mm away), out:X,Y,Z (it comes from beyond all "
    "other parts in this direction), from:PLACEMENT (it comes from this placement, written as for "
    "--start of swept path) or motion:FILE (it follows the motion in this file)";

bool removePrefix(const std::string& text, const std::string& word, std::string& rest) {
  if (text.rfind(word + ":", 0) != 0) return false;
  rest = text.substr(word.size() + 1);
  return true;
}

void addOptions(CLI::App& app, SequenceJob& job) {
  addWords(app, "--part", 2, "PART HOW", job.parts,
           "a part in its installed position, and how it gets there. The part takes the name of "
           "its file PART. HOW is " +
               std::string(kHow) + ". Repeat the option for each part");
  addNeighbourOptions(app, job.still)->required(false);
  addUnit(app, "--part-unit", job.partUnit,
          "unit of the numbers in parts that are meshes (default mm)");
  addNumber(app, "--part-chord", "MM", job.partChord,
            "how far the triangles of parts that are meshes deviate from their exact surfaces "
            "(default 0)");
  addConverted(
      app, "--order", "given|find",
      [&job](const std::string& t) {
        if (t != "given" && t != "find") badOption("--order is '" + t + "'; allowed: given, find");
        job.options.findOrder = t == "find";
      },
      "given (default): install the parts in the order of the options; find: search for an order "
      "by taking the parts out");
  addSearchOptions(app, job.options.path, job.seed);
  addWords(app, "--rule", 3, "PART PART RULE", job.rules,
           "rule for one pair of parts, in place of the required distance: a distance in mm or "
           "ignore. Repeat the option for each pair");
  addWords(app, "--ignore", 2, "PART PART", job.ignored,
           "do not check this pair, for example a screw and its thread");
  addText(app, "-o,--output", "FOLDER", job.folder,
          "existing folder for the motions: one file NAME.csv for each part, all with the same "
          "time axis");
  addCommonOptions(app, job.common);
  app.footer(
      "Exit status 0 if all parts have a path, 3 if not.\n\nExamples:\n"
      "  swept sequence --part gear.stl out:0,0,1 --part lid.stl out:200 box.step --order find "
      "--clearance 0.5 -o motions\n"
      "  swept sequence --part pin.stl from:0,0,80 --part clip.stl motion:clip.csv plate.stl "
      "--release 8");
}

/// Reads from `how` where the part comes from. Returns false if `how` gives a motion file instead.
bool readOrigin(const std::string& how, PathTask& task) {
  std::string rest;
  if (removePrefix(how, "motion", rest)) return false;
  if (removePrefix(how, "out", rest))
    task.extraction = extractionOf("--part ... out", rest);
  else if (removePrefix(how, "from", rest))
    task.start = placementOf("--part ... from", rest);
  else
    badOption("--part PART HOW: HOW is '" + how + "', which is not understood; give " + kHow);
  return true;
}

void readHow(const SequenceJob& job, const std::string& how, SequencePart& part) {
  if (readOrigin(how, part.task)) return;
  std::string file;
  removePrefix(how, "motion", file);
  part.motion = readInputMotion(file, 1, job.options.path.interpolation, {0, 0, 0});
}

std::vector<SequencePart> readParts(const SequenceJob& job, RunContext& run,
                                    std::vector<Finding>& findings) {
  BodyFileOptions file;
  file.millimetresPerUnit = job.partUnit;
  file.tolerance = job.still.deflection;
  std::vector<SequencePart> parts;
  for (std::size_t i = 0; i + 1 < job.parts.size(); i += 2) {
    SequencePart part;
    part.name = utf8FromPath(pathFromUtf8(job.parts[i]).stem());
    readHow(job, job.parts[i + 1], part);
    Body body = readInputBody(job.parts[i], "", file, run);
    for (Finding& finding : body.findings) {
      finding.text = part.name + ": " + finding.text;
      findings.push_back(std::move(finding));
    }
    part.mesh = std::move(body.mesh);
    part.chordError = body.chordError > 0 ? body.chordError : job.partChord;
    parts.push_back(std::move(part));
  }
  return parts;
}

SequenceReport compute(const SequenceJob& job, RunContext& run) {
  std::vector<Finding> findings;
  const std::vector<SequencePart> parts = readParts(job, run, findings);
  std::vector<ClearanceNeighbour> read;
  if (!job.still.paths.empty()) read = readNeighbours(job.still, run);
  makeNamesUnique(read);
  std::vector<StillPart> still;
  for (ClearanceNeighbour& part : read)
    still.push_back({std::move(part.name), std::move(part.mesh), part.chordError});
  SequenceOptions options = job.options;
  options.path.seed = static_cast<std::uint64_t>(job.seed);
  SequenceReport report = findSequence(parts, still, options, run);
  report.warnings.insert(report.warnings.begin(), findings.begin(), findings.end());
  return report;
}

std::string motionFile(const SequenceJob& job, std::size_t part) {
  const std::string name = utf8FromPath(pathFromUtf8(job.parts[2 * part]).stem()) + ".csv";
  return utf8FromPath(pathFromUtf8(job.folder) / pathFromUtf8(name));
}

void printSteps(const SequenceReport& report) {
  for (const SequenceStep& step : report.steps) {
    std::printf("%-24s %-14s", report.names[step.part].c_str(), pathVerdictName(step.path.verdict));
    if (!report.timeline.empty()) std::printf(" %8.2f to %8.2f s ", step.begin, step.end);
    std::printf(" %s\n", step.path.summary.c_str());
  }
  std::printf("%s; %.2f s\n", report.summary.c_str(),
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
}

int runSequence(const SequenceJob& job) {
  const CommonOptions& common = job.common;
  std::vector<RoledFile> inputs, outputs{{"--report", common.report}};
  for (std::size_t i = 0; i < job.parts.size(); i += 2) {
    inputs.push_back({"a part", job.parts[i]});
    std::string motion;
    if (removePrefix(job.parts[i + 1], "motion", motion)) inputs.push_back({"a motion", motion});
  }
  for (const std::string& path : job.still.paths) inputs.push_back({"a neighbour", path});
  if (!job.folder.empty()) {
    if (!std::filesystem::is_directory(pathFromUtf8(job.folder)))
      badOption("--output: the folder '" + job.folder +
                "' does not exist; create it, or choose another");
    for (std::size_t i = 0; i < job.parts.size() / 2; ++i)
      outputs.push_back({"--output", motionFile(job, i)});
  }
  const auto report = runReported<SequenceReport>(
      common, inputs, outputs, [&](RunContext& run) { return compute(job, run); },
      [&](const SequenceReport& found) {
        std::vector<std::pair<std::string, std::string>> motions;
        for (std::size_t i = 0; !job.folder.empty() && i < found.timeline.size(); ++i)
          motions.emplace_back(motionTable(found.timeline[i]), motionFile(job, i));
        writeTexts(motions);
      });
  if (report.status != Status::Ok) return exitStatus(report.status);
  if (!common.quiet && common.report != "-") printSteps(report);
  return finishReported(report, common, report.verdict == SequenceVerdict::Found);
}

}  // namespace

Run addSequenceCommand(CLI::App& program) {
  const auto job = std::make_shared<SequenceJob>();
  CLI::App& app = *program.add_subcommand(
      "sequence",
      "Finds installation paths for parts that are installed one after the other. Each part keeps "
      "its distance from all parts already in place. You give the order, or the search finds one.");
  addOptions(app, *job);
  return [job] {
    checkNeighbourOptions(job->still, "");
    if (job->parts.empty()) badOption("--part PART HOW is missing; give at least one part");
    for (std::size_t i = 1; i < job->parts.size(); i += 2) {
      PathTask task;
      readOrigin(job->parts[i], task);
    }
    for (std::size_t i = 0; i + 1 < job->ignored.size(); i += 2)
      job->options.rules.push_back({job->ignored[i], job->ignored[i + 1], parseRule("ignore")});
    for (std::size_t i = 0; i + 2 < job->rules.size(); i += 3)
      job->options.rules.push_back(
          {job->rules[i], job->rules[i + 1], parseRule(job->rules[i + 2])});
    return runSequence(*job);
  };
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
