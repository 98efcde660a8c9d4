// Runs a command whose result is one report: checks the files, watches the run, writes the report
// and prints errors. Also declares the options of all commands that measure distances.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "files.h"
#include "options.h"
#include "runner.h"

namespace swept::cli {

/// Computes a report and returns it. If the run succeeds, deliver() writes its other outputs, such
/// as a table. An error during the run is stored in the report and printed. The report is written
/// if `common` has a file for it, also after an error.
template <class AnyReport>
AnyReport runReported(const CommonOptions& common, const std::vector<RoledFile>& inputs,
                      const std::vector<RoledFile>& outputs,
                      const std::function<AnyReport(RunContext&)>& compute,
                      const std::function<void(const AnyReport&)>& deliver = {}) {
  checkIdentity(inputs, outputs, common.noClobber);
  checkAccess({}, outputs);
  AnyReport report;
  RunContext run;
  run.threads = common.threads;
  try {
    checkAccess(inputs, {});
    keepStreams(inputs);
    runWatched(run, common.quiet, [&] { report = compute(run); });
    takeStrict(report, common.strict);
    if (deliver && report.status == Status::Ok) deliver(report);
  } catch (const Error& error) {
    takeError(report, error.status(), error.code(), error.what());
  }
  if (!common.report.empty()) writeText(toJson(report), common.report);
  if (report.status != Status::Ok) printError(report.status, report.code, report.message);
  return report;
}

/// Prints findings and times on standard error. Returns the exit status. `clear`: all rules are
/// met, or all paths are found.
template <class AnyReport>
int finishReported(const AnyReport& report, const CommonOptions& common, bool clear) {
  printFindings(report.warnings, common.quiet);
  if (common.verbose) printSeconds(report.seconds);
  return clear ? kExitOk : kExitNotClear;
}

/// Adds --required and --accuracy. --tolerance is the earlier name of --accuracy and still works.
template <class Options>
void addDistanceOptions(CLI::App& app, Options& options) {
  addNumber(app, "--required", "MM", options.required,
            "distance that the parts must keep (default 0: only contact and clash are reported)");
  addNumber(app, "--tolerance,--accuracy", "MM", options.tolerance,
            "largest error of a smallest distance (default 0.01)");
}

/// Adds --interval-tolerance, --curve, --no-penetration and --stamp.
template <class Options>
void addDetailOptions(CLI::App& app, Options& options, std::int64_t& curve, const char* aboutCurve,
                      std::int64_t& stamp) {
  addNumber(app, "--interval-tolerance", "MM", options.intervalTolerance,
            "accuracy of the ends of time intervals, as travel of the part in mm (default 0: "
            "10 times --accuracy)");
  addInteger(app, "--curve", curve, 0, 1000000, aboutCurve);
  app.add_flag_callback(
      "--no-penetration", [&options] { options.penetration = false; },
      "do not measure the depth of a clash");
  addInteger(app, "--stamp", stamp, 0, 1000000,
             "for tests, slow: compare with distances measured at each pose, and at N more moments "
             "between each pose and the next");
}

}  // namespace swept::cli
