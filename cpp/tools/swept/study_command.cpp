// swept study FILE: computes many runs from one file. The Python package does this, since it can
// also use clusters. The command finds the package and replaces its own process by Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef SWEPT_PYTHON
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/safe_file.h"
#include "base/system.h"
#include "commands.h"
#include "options.h"
#include "swept/types.h"

namespace swept::cli {
namespace {

namespace fs = std::filesystem;

struct StudyJob {
  std::string file;
  /// Options in the order of their declaration.
  std::vector<std::pair<std::string, std::string>> values;
  std::vector<std::pair<std::string, bool>> flags;
};

/// Returns the folder of the Python package, relative to the program, in a build or an
/// installation. Returns an empty text if Python must find the package by itself.
std::string packageFolder() {
  const fs::path program = os::programPath();
  if (program.empty()) return {};
  std::error_code failed;
  const fs::path root = program.parent_path().parent_path();
  for (const fs::path& folder : {root / "python", root / "lib/swept/python"})
    if (fs::exists(folder / "swept_volume" / "__main__.py", failed)) return utf8FromPath(folder);
  return {};
}

/// The code that the interpreter runs. It removes the current folder from the module path, since
/// anybody may have put a file with the name of a module there.
constexpr const char* kStart =
    "import sys; sys.path[:] = [p for p in [sys.argv[1], *sys.path] if p]; "
    "from swept_volume.__main__ import main; sys.exit(main(sys.argv[2:]))";

int runStudy(const StudyJob& job) {
  std::vector<std::string> words{SWEPT_PYTHON, "-c", kStart, packageFolder(), "study"};
  for (const auto& [name, value] : job.values)
    if (!value.empty()) words.push_back(name + "=" + value);
  for (const auto& [name, given] : job.flags)
    if (given) words.push_back(name);
  words.insert(words.end(), {"--", job.file});
  const int failed = os::becomeProgram(words);
  throw Error(Status::InvalidInput, "NoPython",
              std::string("'") + SWEPT_PYTHON + "' cannot be started: " + std::strerror(failed) +
                  "; studies need the Python for which this program was built: install it");
}

}  // namespace

Run addStudyCommand(CLI::App& program) {
  const auto job = std::make_shared<StudyJob>();
  CLI::App& app = *program.add_subcommand(
      "study",
      "Computes the runs of a study file (envelopes, solids and clearances of many parts and "
      "motions), several at once or on a cluster. Results of earlier runs are kept, and a run that "
      "fails does not stop the others.");
  addText(app, "FILE", "FILE", job->file, "study file (TOML), as described in docs/studies.md")
      ->required();
  const auto value = [&](const char* names, const char* kind, const char* about) {
    const std::string all = names;
    job->values.emplace_back(all.substr(all.find("--")), "");
    const std::size_t at = job->values.size() - 1;
    addConverted(
        app, names, kind, [job, at](const std::string& text) { job->values[at].second = text; },
        about);
  };
  const auto flag = [&](const char* names, const char* about) {
    const std::string all = names;
    job->flags.emplace_back(all.substr(all.find("--")), false);
    const std::size_t at = job->flags.size() - 1;
    app.add_flag_callback(
        names, [job, at] { job->flags[at].second = true; }, about);
  };
  value("-o,--output", "FOLDER",
        "folder for the results (default: the folder set in the study file, or \"results\" beside "
        "it)");
  value("--jobs", "N",
        "number of runs at the same time on this machine (default: one for each processor core)");
  value("--scheduler", "ADDRESS",
        "address of a Dask scheduler, such as tcp://host:8786; its workers compute the runs");
  flag("--send-files",
       "send the files through the scheduler (default: all machines must see the same folders)");
  flag("--again", "compute all runs again, also those that already have results");
  flag("--page",
       "also write study.html, an HTML page about all runs, into the folder for the results");
  flag("--rows", "write a line of JSON to standard output for each run that has ended");
  flag("--no-clobber", "refuse the study if its report or its results already exist");
  flag("--strict",
       "treat a finding that reduces the accuracy as a failure of its run; the results of the run "
       "are kept");
  value("--report", "FILE", "write a report of the study as JSON, or - for standard output");
  flag("-q,--quiet", "print no progress and no summary");
  app.footer(
      "Exit status 0 if all runs are done and all their rules are met, 3 if a rule is not met, 1 "
      "if a run failed.\n\nExamples:\n  swept study doors.toml --jobs 4 --page\n  swept study "
      "doors.toml "
      "--scheduler tcp://cluster:8786 --send-files");
  return [job] { return runStudy(*job); };
}

}  // namespace swept::cli
#endif  // SWEPT_PYTHON
