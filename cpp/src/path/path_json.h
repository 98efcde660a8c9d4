// Writes the result of a search, for reports of a single path and of sequences.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/report_json.h"
#include "swept/path.h"

namespace swept::path {

/// Adds verdict and summary to `json`. Then adds the path with its figures and its certificate, or
/// how far the search came.
void addAnswer(Json& json, const PathReport& report);

}  // namespace swept::path
