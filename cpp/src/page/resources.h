// Texts that the build embeds into the library (cmake/embed_texts.cmake).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept::page {

/// Returns the text of a file in resources/page. "view" gives the bundled 3D view, which is empty
/// if the build has none. Returns null for an unknown name.
const char* resourceText(const std::string& name);

}  // namespace swept::page
