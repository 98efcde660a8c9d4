// The commands of the program. Each function adds a subcommand with its options to `program`. It
// returns a function that runs the command and returns the exit status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace swept::cli {

using Run = std::function<int()>;

Run addEnvelopeCommand(CLI::App& program);
Run addCheckCommand(CLI::App& program);
Run addClearanceCommand(CLI::App& program);
Run addMechanismCommand(CLI::App& program);
Run addOverlapCommand(CLI::App& program);
Run addPathCommand(CLI::App& program);
Run addSequenceCommand(CLI::App& program);
Run addSolidCommand(CLI::App& program);
Run addStudyCommand(CLI::App& program);

}  // namespace swept::cli
