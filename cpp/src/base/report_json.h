// The fields of a report as JSON, for those who add fields of their own to the same object.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/json_writer.h"
#include "swept/report.h"

namespace swept {

/// Writes the keys of README.md, "The report", into an object that the caller has opened.
void writeCheckFields(const MeshCheck& check, JsonWriter& json);
void writeReportFields(const Report& report, JsonWriter& json);

}  // namespace swept
