// Options and printed summary of all commands that write solids.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "options.h"
#include "swept/solid.h"

namespace swept::cli {

void addSolidOptions(CLI::App& app, SolidOptions& options);

/// Prints one line: faces by kind, size, seconds, deviation.
void printSolid(const WrittenSolid& solid, const std::string& path);

}  // namespace swept::cli
