// Options and report of solids, shared by the commands that write them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "arguments.h"
#include "base/json_writer.h"
#include "swept/solid.h"

namespace swept::cli {

/// Lines of the help, one an option.
extern const char* const kSolidOptionsHelp;

void addSolidOptions(Arguments& arguments, StepOptions& options);

/// The key "solid" of a report.
void writeSolidFields(const StepReport& solid, JsonWriter& json);

/// One line: faces by kind, size, seconds, deviation.
void printSolid(const StepReport& solid, const std::string& path);

}  // namespace swept::cli
