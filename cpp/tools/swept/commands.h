// The commands of the program. Each declares its options on a subcommand of `program` and gives
// what runs it: a function that returns the exit status.
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
