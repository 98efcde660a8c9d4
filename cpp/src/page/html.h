// Small pieces of HTML and SVG that are also well-formed XML. Numbers do not depend on the locale.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "base/report_json.h"

namespace swept::page {

/// Escapes text for elements and attributes. Invalid UTF-8, and control characters that HTML does
/// not allow, become U+FFFD.
std::string escaped(const std::string& text);

/// Returns a script element with data. No character of the JSON can end the element.
std::string dataElement(const char* id, const Json& json);

/// Returns the base64 code of bytes, for URLs that contain data and for the 3D view.
std::string base64(const void* bytes, std::size_t count);

/// Returns <tag class="kind">content</tag>. `content` is markup. An empty kind gives no class.
std::string element(const char* tag, const std::string& content, const std::string& kind = {});

/// Returns a table from markup; the first row is the head. `columns` has one letter per column: "n"
/// for numbers, "t" for text.
std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& columns,
                  const std::vector<std::string>& rowAttributes = {});

/// Returns a section with its heading; empty if there is no content.
std::string section(const std::string& id, const std::string& heading, const std::string& content);

}  // namespace swept::page
