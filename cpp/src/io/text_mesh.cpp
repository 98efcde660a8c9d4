// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/text_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>

#include "base/limits.h"
#include "base/number_text.h"
#include "io/text_scanner.h"

namespace swept {
namespace {

constexpr std::int64_t kMaxIndex = kMaxElements;  // largest value of the index type

Eigen::Vector3d threeNumbers(TextScanner& scan) {
  Eigen::Vector3d p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = toNumber(scan, scan.word());
  return p;
}

void checkCount(std::size_t count, const char* what, const TextScanner& scan) {
  if (count < kMaxElements) return;
  scan.bad("too many " + std::string(what) + "; the limit is " + std::to_string(kMaxElements));
}

// Completes a face from all corners that were added since the last face.
void endFace(PolygonList& list, const TextScanner& scan) {
  const std::size_t corners = list.corners.size() - list.faceStart.back();
  if (corners < 3) scan.bad("a face needs 3 corners, but this face has " + std::to_string(corners));
  list.faceStart.push_back(list.corners.size());
}

[[noreturn]] void notFinite(const std::string& path, const std::string& where) {
  throw Error(Status::InvalidInput, "NonFiniteVertex",
              "'" + path + "', " + where +
                  ": a coordinate is not a finite number; "
                  "export the mesh again from its source");
}

}  // namespace

std::string readAll(std::istream& stream) {
  stream.clear();
  stream.seekg(0, std::ios::end);
  const auto size = stream.tellg();
  stream.seekg(0);
  std::string text(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

double toNumber(TextScanner& scan, std::string_view word) {
  double value = 0;
  if (!parseNumber(word, value)) scan.expected("a number", word);
  return value;
}

std::int64_t toInteger(TextScanner& scan, std::string_view word) {
  std::int64_t value = 0;
  if (!parseInteger(word, value)) scan.expected("a whole number", word);
  return value;
}

bool parseNumber(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  if (text.empty() || text.front() == '+') return false;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range) {
    // A number below the smallest double counts as zero. A number above the largest one is refused.
    const std::size_t mark = text.find_first_of("eE");
    const bool tiny =
        mark != std::string_view::npos && mark + 1 < text.size() && text[mark + 1] == '-';
    value = 0;
    return tiny;
  }
  return error == std::errc{};
}

bool parseInteger(std::string_view text, std::int64_t& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  if (text.empty() || text.front() == '+') return false;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

PolygonList readObj(std::istream& stream, const std::string& path) {
  const std::string text = readAll(stream);
  TextScanner scan(text, path);
  PolygonList list;
  std::int64_t highest = 0;
  std::int64_t highestLine = 0;
  do {
    const std::string_view key = scan.word();
    if (key == "v") {
      checkCount(list.vertices.size(), "vertices", scan);
      list.vertices.push_back(threeNumbers(scan));
    } else if (key == "f") {
      for (std::string_view word = scan.word(); !word.empty(); word = scan.word()) {
        const auto count = static_cast<std::int64_t>(list.vertices.size());
        std::int64_t index = toInteger(scan, word.substr(0, word.find('/')));
        if (index < 0) index += count + 1;
        if (index <= 0 || index > kMaxIndex) scan.expected("a vertex number that exists", word);
        if (index > highest) {
          highest = index;
          highestLine = scan.line();
        }
        list.corners.push_back(static_cast<std::int32_t>(index - 1));
      }
      endFace(list, scan);
    }
  } while (scan.nextLine());
  if (highest > static_cast<std::int64_t>(list.vertices.size())) {
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path + "', line " + std::to_string(highestLine) + ": refers to vertex " +
                    std::to_string(highest) + ", but the file has " +
                    counted(std::ssize(list.vertices), "vertex", "vertices") +
                    ", numbered from 1; the file is damaged: export it again");
  }
  return list;
}

PolygonList readOff(std::istream& stream, const std::string& path) {
  const std::string text = readAll(stream);
  TextScanner scan(text, path);
  const auto nextFilledLine = [&scan] {
    std::string_view word = scan.word();
    while (word.empty() || word.front() == '#') {
      if (!scan.nextLine()) scan.bad("the file ends too early; it is truncated");
      word = scan.word();
    }
    return word;
  };
  // The colours, normals and texture that follow a position are ignored.
  const std::string_view kind = nextFilledLine();
  static const std::vector<std::string_view> kinds{"OFF",   "COFF",   "NOFF",   "CNOFF",  "NCOFF",
                                                   "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) scan.expected("'OFF'", kind);
  std::string_view word = scan.word();
  if (word == "BINARY")
    scan.bad("binary OFF files cannot be read; save the mesh as a text file or as PLY");
  if (word.empty() || word.front() == '#') {
    scan.nextLine();
    word = nextFilledLine();
  }
  std::array<std::int64_t, 2> counts{};
  counts[0] = toInteger(scan, word);
  counts[1] = toInteger(scan, scan.word());
  const auto bytes = static_cast<std::int64_t>(text.size());
  if (counts[0] < 0 || counts[1] < 0 || counts[0] > bytes / 5 || counts[1] > bytes / 7) {
    scan.bad("the counts " + std::to_string(counts[0]) + " and " + std::to_string(counts[1]) +
             " are too large for a file of " + std::to_string(bytes) + " bytes; it is truncated");
  }
  checkCount(static_cast<std::size_t>(counts[0]), "vertices", scan);
  PolygonList list;
  list.vertices.reserve(static_cast<std::size_t>(counts[0]));
  for (std::int64_t i = 0; i < counts[0]; ++i) {
    scan.nextLine();
    Eigen::Vector3d p;
    p[0] = toNumber(scan, nextFilledLine());
    for (int axis = 1; axis < 3; ++axis) p[axis] = toNumber(scan, scan.word());
    list.vertices.push_back(p);
  }
  for (std::int64_t i = 0; i < counts[1]; ++i) {
    scan.nextLine();
    const std::int64_t corners = toInteger(scan, nextFilledLine());
    for (std::int64_t k = 0; k < corners; ++k) {
      word = scan.word();
      const std::int64_t index = toInteger(scan, word);
      if (index < 0 || index >= counts[0]) scan.expected("a vertex number that exists", word);
      list.corners.push_back(static_cast<std::int32_t>(index));
    }
    endFace(list, scan);
  }
  return list;
}

void checkTextStl(std::istream& stream, const std::string& path) {
  const std::string text = readAll(stream);
  TextScanner scan(text, path);
  std::int64_t vertices = 0;
  do {
    const std::string_view key = scan.word();
    if (key != "vertex" && key != "VERTEX") continue;
    if (!threeNumbers(scan).allFinite()) notFinite(path, "line " + std::to_string(scan.line()));
    ++vertices;
  } while (scan.nextLine());
  if (vertices % 3 != 0) {
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path + "' has " + std::to_string(vertices) +
                    " vertices, but the number must be a multiple of 3; the file is truncated");
  }
}

void checkBinaryStl(std::istream& stream, const std::string& path) {
  stream.clear();
  stream.seekg(84);
  static_assert(std::endian::native == std::endian::little);
  std::array<char, 50> facet{};
  for (std::int64_t i = 0; stream.read(facet.data(), facet.size()); ++i) {
    for (int k = 3; k < 12; ++k) {
      float value = 0;
      std::memcpy(&value, facet.data() + 4 * k, 4);
      if (std::isfinite(value)) continue;
      notFinite(path, "triangle " + std::to_string(i) + " (counted from 0)");
    }
  }
}

}  // namespace swept
