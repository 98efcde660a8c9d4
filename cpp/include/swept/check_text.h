// What the checker found, as JSON text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/report.h"

namespace swept {

/// UTF-8; keys as in docs/report.md, and `passes`.
std::string toJson(const MeshCheck& check);

}  // namespace swept
