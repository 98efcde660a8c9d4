// The program `swept`: chooses the command, turns what is thrown into one line and an exit status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.h"
#include "runner.h"
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"
#endif
#include "swept/types.h"

#ifndef SWEPT_VERSION
#define SWEPT_VERSION "of unknown version"
#endif

namespace swept::cli {
namespace {

struct Command {
  const char* name;
  int (*run)(const std::vector<std::string>&);
  const char* const* help;
};

constexpr Command kCommands[] = {
    {"envelope", envelopeCommand, &kEnvelopeHelp},
    {"check", checkCommand, &kCheckHelp},
#ifdef HAVE_SWEPT_SOLID
    {"solid", solidCommand, &kSolidHelp},
#endif
#ifdef HAVE_SWEPT_CLEARANCE
    {"clearance", clearanceCommand, &kClearanceHelp},
#endif
};

void printHelp() {
  std::puts("swept: envelopes of moving bodies\n\nusage: swept COMMAND ...\n");
  for (const Command& command : kCommands) std::puts(*command.help);
#ifdef HAVE_SWEPT_SOLID
  std::printf("options of solids (swept envelope to a step or brep file, swept solid)\n%s\n",
              kSolidOptionsHelp);
#endif
  std::puts(
      "swept --help, swept --version\n\nExit status: 0 done, 1 failed, 2 wrong usage, "
      "130 cancelled. Lengths are in mm.");
}

int dispatch(const std::vector<std::string>& words) {
  if (words.empty()) {
    printHelp();
    return kExitUsage;
  }
  if (words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
    printHelp();
    return kExitOk;
  }
  if (words[0] == "--version") {
    std::puts("swept " SWEPT_VERSION);
    return kExitOk;
  }
  for (const Command& command : kCommands) {
    if (words[0] != command.name) continue;
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    if (rest.size() == 1 && (rest[0] == "--help" || rest[0] == "-h")) {
      std::fputs(*command.help, stdout);
      return kExitOk;
    }
    return command.run(rest);
  }
  throw Error(Status::InvalidInput, "BadOption",
              "unknown command '" + words[0] + "'; see swept --help");
}

}  // namespace
}  // namespace swept::cli

int main(int argc, char** argv) {
  using namespace swept;
  try {
    return cli::dispatch(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const Error& error) {
    cli::printError(error.status(), error.code(), error.what());
    return error.code() == "BadOption" ? cli::kExitUsage : cli::exitStatus(error.status());
  } catch (const std::bad_alloc&) {
    cli::printError(Status::OutOfMemory, "OutOfMemory",
                    "memory ran out; use a larger cell or smaller files");
  } catch (const std::exception& error) {
    cli::printError(
        Status::InternalError, "Unexpected",
        std::string(error.what()) +
            ": a fault of the program; please report it with the files and the command");
  }
  return cli::kExitFailed;
}
