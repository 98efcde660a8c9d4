// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/ply_header.h"

#include <map>
#include <sstream>

#include "swept/types.h"

namespace swept {
namespace {

constexpr int kMaxHeaderLines = 1000;
constexpr std::size_t kMaxHeaderBytes = 1 << 20;

[[noreturn]] void bad(const std::string& path, int line, const std::string& what) {
  throw Error(Status::InvalidInput, "BadFile",
              "'" + path + "', line " + std::to_string(line) + " of the header: " + what);
}

int bytesOf(const std::string& type, bool* isFloat) {
  static const std::map<std::string, int> sizes{
      {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
      {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
      {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
  *isFloat = type.rfind("float", 0) == 0 || type == "double";
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

PlyProperty parseProperty(std::istringstream& words, const std::string& path, int line) {
  PlyProperty property;
  std::string type;
  bool ignored = false;
  words >> type;
  if (type == "list") {
    words >> type;
    property.countBytes = bytesOf(type, &ignored);
    if (property.countBytes == 0 || ignored)
      bad(path, line, "unknown type of a list count '" + type + "'");
    type.clear();
    words >> type;
  }
  property.bytes = bytesOf(type, &property.isFloat);
  property.isSigned = !property.isFloat && type[0] != 'u';
  if (property.bytes == 0) bad(path, line, "unknown type '" + type + "'");
  if (!(words >> property.name)) bad(path, line, "property without a name");
  return property;
}

// Reads one line of the header. Refuses a line with any error, since the header gives the meaning
// of the data.
void parseLine(const std::string& text, const std::string& path, PlyHeader& header) {
  std::istringstream words(text);
  std::string key;
  if (!(words >> key) || key == "comment" || key == "obj_info") return;
  if (key == "format") {
    std::string format;
    std::string version;
    words >> format >> version;
    if (version != "1.0") bad(path, header.lines, "expected version 1.0, found '" + version + "'");
    if (format == "ascii") {
      header.format = PlyHeader::Format::Ascii;
    } else if (format == "binary_little_endian") {
      header.format = PlyHeader::Format::LittleEndian;
    } else if (format == "binary_big_endian") {
      header.format = PlyHeader::Format::BigEndian;
    } else {
      bad(path, header.lines, "unknown format '" + format + "'");
    }
  } else if (key == "element") {
    PlyElement element;
    if (!(words >> element.name >> element.count) || text.find('-') != std::string::npos) {
      bad(path, header.lines, "expected 'element NAME COUNT', found '" + text + "'");
    }
    header.elements.push_back(element);
  } else if (key == "property") {
    if (header.elements.empty()) bad(path, header.lines, "property before any element");
    header.elements.back().properties.push_back(parseProperty(words, path, header.lines));
  } else {
    bad(path, header.lines, "unknown keyword '" + key + "'");
  }
  std::string more;
  if (words >> more) bad(path, header.lines, "unexpected text after '" + key + "': '" + more + "'");
}

void checkSize(const PlyHeader& header, std::uint64_t fileBytes, const std::string& path) {
  std::uint64_t left = fileBytes - header.dataStart;
  for (const PlyElement& element : header.elements) {
    // In a text file, every value takes at least a digit and a separator.
    const std::uint64_t least = header.format == PlyHeader::Format::Ascii
                                    ? 2 * element.properties.size()
                                    : element.leastBytes();
    if (least != 0 && element.count > (left + 1) / least) {
      throw Error(Status::InvalidInput, "BadFile",
                  "'" + path + "' announces in its header " + std::to_string(element.count) +
                      " entries of the type '" + element.name + "' with at least " +
                      std::to_string(least) + " bytes each, but only " + std::to_string(left) +
                      " bytes follow the header; the file is truncated");
    }
    left -= std::min(left, least * element.count);
  }
}

}  // namespace

std::uint64_t PlyElement::leastBytes() const {
  std::uint64_t sum = 0;
  for (const PlyProperty& p : properties) {
    sum += static_cast<std::uint64_t>(p.countBytes != 0 ? p.countBytes : p.bytes);
  }
  return sum;
}

const PlyElement* PlyHeader::find(const std::string& name) const {
  for (const PlyElement& element : elements) {
    if (element.name == name) return &element;
  }
  return nullptr;
}

PlyHeader readPlyHeader(std::istream& stream, std::uint64_t fileBytes, const std::string& path) {
  PlyHeader header;
  std::string line;
  std::size_t bytes = 0;
  while (true) {
    line.clear();
    char c = 0;
    while (stream.get(c) && c != '\n' && bytes < kMaxHeaderBytes) {
      line.push_back(c);
      ++bytes;
    }
    ++header.lines;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (header.lines == 1 && line != "ply") bad(path, 1, "expected 'ply'");
    if (!stream || bytes >= kMaxHeaderBytes || header.lines > kMaxHeaderLines) {
      bad(path, header.lines, "'end_header' is missing");
    }
    if (line == "end_header") break;
    if (header.lines > 1) parseLine(line, path, header);
  }
  header.dataStart = static_cast<std::uint64_t>(stream.tellg());
  const PlyElement* vertex = header.find("vertex");
  if (vertex == nullptr || header.find("face") == nullptr) {
    bad(path, header.lines, "a mesh needs the elements 'vertex' and 'face'");
  }
  checkSize(header, fileBytes, path);
  return header;
}

}  // namespace swept
