// The program `swept`: selects the command, and turns exceptions into a message and an exit status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/fault_text.h"
#include "base/system.h"
#include "commands.h"
#include "files.h"
#include "manual.h"
#include "options.h"
#include "runner.h"
#include "swept/types.h"

#ifndef SWEPT_VERSION
#define SWEPT_VERSION "of unknown version"
#endif

namespace swept::cli {
namespace {

using Commands = std::vector<std::pair<std::string, Run>>;

constexpr const char* kExitStatuses =
    "Exit status: 0 success, 1 failure, 2 wrong usage, 3 a rule is not met\n(clearance, mechanism, "
    "overlap, study) or a path is missing (path, sequence), 130 or 143 cancelled (128 plus the "
    "number of the signal). Lengths are in mm.";

Commands addCommands(CLI::App& program) {
  Commands commands;
  commands.emplace_back("envelope", addEnvelopeCommand(program));
  commands.emplace_back("check", addCheckCommand(program));
#ifdef HAVE_SWEPT_SOLID
  commands.emplace_back("solid", addSolidCommand(program));
#endif
#ifdef HAVE_SWEPT_CLEARANCE
  commands.emplace_back("clearance", addClearanceCommand(program));
  commands.emplace_back("mechanism", addMechanismCommand(program));
  commands.emplace_back("overlap", addOverlapCommand(program));
  commands.emplace_back("path", addPathCommand(program));
  commands.emplace_back("sequence", addSequenceCommand(program));
#endif
#ifdef SWEPT_PYTHON
  commands.emplace_back("study", addStudyCommand(program));
#endif
  CLI::App& manual = *program.add_subcommand("manual", "Prints the manual page.");
  manual.footer("Examples:\n  swept manual | man -l -");
  commands.emplace_back("manual", [&program] {
    writeText(manualPage(program), "-");
    return kExitOk;
  });
  CLI::App& completion = *program.add_subcommand("completion", "Prints completions for a shell.");
  const auto shell = std::make_shared<std::string>();
  addText(completion, "SHELL", "bash|zsh|fish", *shell, "bash, zsh or fish")->required();
  completion.footer("Examples:\n  source <(swept completion bash)");
  commands.emplace_back("completion", [&program, shell] {
    writeText(completions(program, *shell), "-");
    return kExitOk;
  });
  return commands;
}

std::string commandOf(const CLI::App& program) {
  const auto given = program.get_subcommands();
  return given.empty() ? std::string() : " " + given[0]->get_name();
}

// Returns a message in the style of this program for an error of CLI11.
std::string refusal(const CLI::ParseError& error, const CLI::App& program,
                    const std::vector<std::string>& words) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const bool missing = text.find("missing") != std::string::npos;
    return text.substr(0, text.find(':')) + (missing ? " needs a value" : " is given twice");
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return text;
  if (commandOf(program).empty()) return "unknown command '" + words[0] + "'";
  // The text ends with all words that no option takes, from the last one to the first one.
  const std::string unexpected = text.substr(text.rfind(": ") + 1) + " ";
  std::vector<std::string> files;
  for (const std::string& word : words) {
    if (unexpected.find(" " + word + " ") == std::string::npos) continue;
    if (word.size() > 1 && word[0] == '-') return "unknown option '" + word + "'";
    files.push_back(word);
  }
  return "too many files: '" + (files.empty() ? unexpected : files.front()) + "'";
}

/// Keeps the lines of the text below the options, which are commands to copy. CLI11 from 2.5 on
/// would wrap them.
template <class Formatter>
void keepLines(Formatter& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); })
    formatter.enable_footer_formatting(false);
}

int dispatch(std::vector<std::string> words) {
  CLI::App program("envelopes of moving parts", "swept");
  program.set_version_flag("-V,--version", "swept " SWEPT_VERSION);
  program.footer(kExitStatuses);
  program.get_formatter()->column_width(32);
  keepLines(*program.get_formatter());
  const Commands commands = addCommands(program);
  if (!words.empty() && words[0] == "help") {  // `swept help COMMAND`, as in version 0.1
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    const auto given = program.get_subcommands();
    writeText(given.empty() ? program.help() : given[0]->help("swept"), "-");
    return kExitOk;
  } catch (const CLI::CallForVersion&) {
    writeText("swept " SWEPT_VERSION "\n", "-");
    return kExitOk;
  } catch (const CLI::ParseError& error) {
    badOption(refusal(error, program, words) + "; see swept" + commandOf(program) + " --help");
  } catch (const Error& error) {
    badOption(error.what() + ("; see swept" + commandOf(program)) + " --help");
  }
  for (const auto& [name, run] : commands)
    if (program.got_subcommand(name)) return run();
  writeText(program.help(), "-");
  return kExitUsage;
}

}  // namespace
}  // namespace swept::cli

int main(int argc, char** argv) {
  using namespace swept;
  os::ignoreWriteSignals();
  try {
    const int status = cli::dispatch(os::commandLine(argc, argv));
    cli::flushStandardOutput();
    return status;
  } catch (const Error& error) {
    cli::printError(error.status(), error.code(), error.what());
    const bool usage = error.code() == "BadOption" || error.code() == "SameFile";
    return usage ? cli::kExitUsage : cli::exitStatus(error.status());
  } catch (const std::bad_alloc&) {
    cli::printError(Status::OutOfMemory, "OutOfMemory",
                    "memory ran out; use a larger cell, or smaller files");
  } catch (const std::exception& error) {
    cli::printError(Status::InternalError, "Unexpected",
                    error.what() + faultText("the files and the command"));
  }
  return cli::kExitFailed;
}
