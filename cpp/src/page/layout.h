// Templates: text with {{placeholders}}.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace swept::page {

/// Replaces each {{name}} in the layout by its value. Blanks inside the braces are allowed. Braces
/// in a value are not replaced. Throws Error(InvalidInput, "BadTemplate") with the line and the
/// text for an unknown name and for {{ without }}.
std::string filled(const std::string& layout, const std::map<std::string, std::string>& values);

}  // namespace swept::page
