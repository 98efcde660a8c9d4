// Templates: text with {{placeholders}}.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace swept::page {

/// Replaces each {{name}} in the layout by its value. Blanks inside the braces are allowed. Braces
/// in a value are not replaced. Throws Error(InvalidInput, "BadTemplate") for an unknown name, and
/// for "{{" that no "}}" closes; the message has the number of the line and the text found there.
std::string filled(const std::string& layout, const std::map<std::string, std::string>& values);

}  // namespace swept::page
