// Texts of the files in shaders/, embedded by the build.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept::gl {

/// Returns null if there is no such file.
const char* shaderSource(const std::string& name);

}  // namespace swept::gl
