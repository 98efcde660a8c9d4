// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/html.h"

#include <cstdint>

namespace swept::page {
namespace {

constexpr const char* kNoCharacter = "\xEF\xBF\xBD";  // U+FFFD

/// Replaces every byte that is not valid UTF-8 by U+FFFD, as in reports.
std::string asUtf8(const std::string& text) {
  const std::string json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(json).get<std::string>();
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : asUtf8(text)) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        const bool blank = c == '\t' || c == '\n' || c == '\r';
        if ((byte < 0x20 && !blank) || byte == 0x7f)
          out += kNoCharacter;
        else
          out += c;
      }
    }
  return out;
}

std::string dataElement(const char* id, const Json& json) {
  std::string out = std::string("<script type=\"application/json\" id=\"") + id + "\">";
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<' || c == '>' || c == '&')  // in JSON, only strings contain these characters
      out += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : "\\u0026";
    else
      out += c;
  }
  return out + "</script>\n";
}

std::string base64(const void* bytes, std::size_t count) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* in = static_cast<const std::uint8_t*>(bytes);
  std::string out;
  out.reserve((count + 2) / 3 * 4);
  for (std::size_t i = 0; i < count; i += 3) {
    const std::size_t left = count - i;
    const std::uint32_t three = std::uint32_t(in[i]) << 16 |
                                (left > 1 ? std::uint32_t(in[i + 1]) << 8 : 0) |
                                (left > 2 ? std::uint32_t(in[i + 2]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= left ? kDigits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string element(const char* tag, const std::string& content, const std::string& kind) {
  const std::string attribute = kind.empty() ? "" : " class=\"" + kind + "\"";
  return std::string("<") + tag + attribute + ">" + content + "</" + tag + ">";
}

std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& columns,
                  const std::vector<std::string>& rowAttributes) {
  std::string out = "<div class=\"wide\"><table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += i == 0 ? "<thead><tr>"
                  : "<tr" + (i - 1 < rowAttributes.size() ? rowAttributes[i - 1] : "") + ">";
    for (std::size_t k = 0; k < rows[i].size(); ++k)
      out += element(i == 0 ? "th" : "td", rows[i][k], columns[k] == 'n' ? "number" : "");
    out += i == 0 ? "</tr></thead>\n<tbody>\n" : "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string section(const std::string& id, const std::string& heading, const std::string& content) {
  if (content.empty()) return {};
  return "<section id=\"" + id + "\">\n" + element("h2", escaped(heading)) + "\n" + content +
         "</section>\n";
}

}  // namespace swept::page
