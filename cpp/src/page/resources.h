// Texts that the build puts into the library (cmake/embed_texts.cmake).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept::page {

/// A file of resources/page, or "view": the bundled 3D view, empty where there is none. Null:
/// unknown name.
const char* resourceText(const std::string& name);

}  // namespace swept::page
