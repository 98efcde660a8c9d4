// The report of one command: JSON into a file, or onto standard output for the name "-".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

#include "base/json_writer.h"
#include "swept/report.h"

namespace swept::cli {

/// Throws Error(ExportFailed) if the report could not be written there later. Empty path: no
/// report.
void checkReportTarget(const std::string& path);

/// `extra` adds fields behind those of the report. Empty path: nothing is written.
void writeReport(const Report& report, const std::string& path,
                 const std::function<void(JsonWriter&)>& extra = {});

}  // namespace swept::cli
