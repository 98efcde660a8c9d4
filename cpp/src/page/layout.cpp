// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/layout.h"

#include <algorithm>

#include "swept/types.h"

namespace swept::page {
namespace {

constexpr std::size_t kQuotedBytes = 40;  // bytes of a wrong placeholder that a message quotes

[[noreturn]] void badTemplate(const std::string& layout, std::size_t at, const std::string& text) {
  const auto line = 1 + std::count(layout.begin(), layout.begin() + std::ptrdiff_t(at), '\n');
  throw Error(Status::InvalidInput, "BadTemplate",
              "line " + std::to_string(line) + " of the template: " + text);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::string filled(const std::string& layout, const std::map<std::string, std::string>& values) {
  std::string out;
  std::size_t done = 0;
  for (std::size_t at; (at = layout.find("{{", done)) != std::string::npos;) {
    out.append(layout, done, at - done);
    const std::size_t end = layout.find("}}", at);
    if (end == std::string::npos) badTemplate(layout, at, "{{ has no closing }}");
    const std::string name = trimmed(layout.substr(at + 2, end - at - 2));
    const auto found = values.find(name);
    if (found == values.end()) {
      std::string known;
      for (const auto& [key, value] : values) known += (known.empty() ? "" : ", ") + key;
      badTemplate(layout, at,
                  "{{" + name.substr(0, kQuotedBytes) +
                      "}} is not a placeholder; use one of these: " + known);
    }
    out += found->second;
    done = end + 2;
  }
  return out.append(layout, done);
}

}  // namespace swept::page
