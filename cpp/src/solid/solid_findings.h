// Findings about a solid that differs from its mesh more than the caller may expect.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/solid.h"

namespace swept {

/// Returns up to three findings. "SolidSimplified": the solid was simplified although no tolerance
/// was given. "SolidNote": the note of the export, for example on surfaces that it gave up.
/// "SolidInaccurate": the solid deviates from the mesh by more than the tolerance.
std::vector<Finding> solidFindings(const WrittenSolid& solid, const SolidOptions& options);

}  // namespace swept
