// What a search has found, as it stands in reports of one path and of sequences.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/report_json.h"
#include "swept/path.h"

namespace swept::path {

/// Verdict and summary; the path with its figures and its certificate, or how far the search came.
void addAnswer(Json& json, const PathReport& report);

}  // namespace swept::path
