// swept study FILE: many runs from one file. The Python package computes them, since a cluster is
// reached through it; this finds the package and becomes its interpreter.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef SWEPT_PYTHON
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "options.h"
#include "swept/types.h"

namespace swept::cli {
namespace {

namespace fs = std::filesystem;

struct StudyJob {
  std::string file;
  std::vector<std::pair<std::string, std::string>> values;  ///< options, in the order declared
  std::vector<std::pair<std::string, bool>> flags;
};

/// Beside the program, in a build or where it is installed; empty: where Python looks by itself.
std::string packageFolder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) return {};
  const fs::path root = program.parent_path().parent_path();
  for (const fs::path& folder : {root / "python", root / "lib/swept/python"})
    if (fs::exists(folder / "swept_volume" / "__main__.py", failed)) return folder.string();
  return {};
}

/// What the interpreter runs. Its path of modules would begin with the current folder, where
/// anybody may have put a file called like one of them.
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
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  throw Error(Status::InvalidInput, "NoPython",
              std::string("'") + SWEPT_PYTHON + "' cannot be started: " + std::strerror(errno) +
                  "; studies need the Python that this program was built for");
}

}  // namespace

Run addStudyCommand(CLI::App& program) {
  const auto job = std::make_shared<StudyJob>();
  CLI::App& app = *program.add_subcommand(
      "study",
      "Computes the runs of a study file, several at once or on a cluster: envelopes, solids and "
      "clearances of many parts and motions. What is done is kept, and one run that fails stops no "
      "other.");
  addText(app, "FILE", "FILE", job->file, "the study: a TOML file, as docs/studies.md says")
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
  value("-o,--output", "FOLDER", "folder for results (default: the one that the file names)");
  value("--jobs", "N", "runs at once on this machine (default: one for each core)");
  value("--scheduler", "ADDRESS",
        "address of a dask scheduler, tcp://host:8786, whose workers compute");
  flag("--send-files",
       "files travel through the scheduler (default: all machines see the same folders)");
  flag("--again", "compute runs again whose results are there");
  flag("--page",
       "also write study.html into the folder for results: one page for people, of all runs");
  flag("--rows", "write the row of each run that has ended as a line of JSON to standard output");
  flag("--no-clobber", "refuse to replace a report or results that are there");
  flag("--strict", "a finding that costs accuracy is a failure of its run, whose results are kept");
  value("--report", "FILE", "write the report of the study as JSON; - for standard output");
  flag("-q,--quiet", "no progress, no summary");
  app.footer(
      "Exit status 0 if all runs are done and clear, 3 if one is not clear, 1 if one failed.\n\n"
      "Examples:\n"
      "  swept study doors.toml --jobs 4 --page\n"
      "  swept study doors.toml --scheduler tcp://cluster:8786 --send-files");
  return [job] { return runStudy(*job); };
}

}  // namespace swept::cli
#endif  // SWEPT_PYTHON
