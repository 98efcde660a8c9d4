// Writes the result of the mesh checker as JSON text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/report.h"

namespace swept {

/// Returns UTF-8 text. The keys are those of "check" in docs/report.md, and also "passes".
std::string toJson(const MeshCheck& check);

}  // namespace swept
