// Templates: text with {{placeholders}}.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace swept::page {

/// The layout with each {{name}} (blanks inside are allowed) replaced by its value, once: what a
/// value holds is left alone. Throws Error(InvalidInput, "BadTemplate"), naming the line and what
/// stands there, for an unknown name and for {{ without }}.
std::string filled(const std::string& layout, const std::map<std::string, std::string>& values);

}  // namespace swept::page
