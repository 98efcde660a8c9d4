// Options and summary of solids, shared by the commands that write them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "options.h"
#include "swept/solid.h"

namespace swept::cli {

void addSolidOptions(CLI::App& app, StepOptions& options);

/// One line: faces by kind, size, seconds, deviation.
void printSolid(const StepReport& solid, const std::string& path);

}  // namespace swept::cli
