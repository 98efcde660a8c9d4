// Options and report of solids, shared by the commands that write them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/report_json.h"
#include "options.h"
#include "swept/step_export.h"

namespace swept::cli {

void addSolidOptions(CLI::App& app, StepOptions& options);

/// The key "solid" of a report.
Json solidJson(const StepReport& solid);

/// What the solid is short of the mesh: simplified although no tolerance was given, or what had to
/// be given up to get a valid one.
std::vector<Finding> solidFindings(const StepReport& solid, const StepOptions& options);

/// One line: faces by kind, size, seconds, deviation.
void printSolid(const StepReport& solid, const std::string& path);

}  // namespace swept::cli
