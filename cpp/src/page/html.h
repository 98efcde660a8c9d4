// Small pieces of HTML and SVG, well-formed as XML too. Numbers are the same in every locale.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "base/report_json.h"

namespace swept::page {

/// Text that stands for itself, in elements and in attributes. What is no UTF-8, and control
/// characters that HTML has no place for, become U+FFFD.
std::string escaped(const std::string& text);

/// A script element with data: no character of the JSON can end it.
std::string dataElement(const char* id, const Json& json);

/// As data: addresses and the 3D view have bytes.
std::string base64(const void* bytes, std::size_t count);

/// <tag class="kind">content</tag>; content is markup. Empty kind: no class.
std::string element(const char* tag, const std::string& content, const std::string& kind = {});

/// A table from markup; the first row is the head. Cells of `numbers` (a letter a column: "n"
/// number, "t" text) are aligned.
std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& columns,
                  const std::vector<std::string>& rowAttributes = {});

/// A section with its heading; nothing where there is no content.
std::string section(const std::string& id, const std::string& heading, const std::string& content);

}  // namespace swept::page
