// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sources_file.h"

#include <array>
#include <charconv>

#include "files.h"

namespace swept::cli {
namespace {

/// Appends the shortest text that reads back as exactly this number.
template <class Number>
void addNumber(Number number, std::string& text) {
  std::array<char, 40> digits;
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

void addRow(const SurfaceSource& row, std::string& text) {
  text.append(sourceKindName(row.kind)).append(",");
  addNumber(row.faces[0], text);
  text += ',';
  if (row.faces[1] >= 0) addNumber(row.faces[1], text);
  text += ',';
  addNumber(row.step, text);
  text += ',';
  addNumber(row.timeSeconds, text);
  for (int axis = 0; axis < 3; ++axis) {
    text += ',';
    addNumber(row.point[axis], text);
  }
}

}  // namespace

void writeSources(const Sources& sources, const std::string& path) {
  std::string text = "triangle,kind,face,other_face,step,time_s,x,y,z\n";
  for (std::size_t t = 0; t < sources.of.size(); ++t) {
    addNumber(t, text);
    text += ',';
    if (sources.of[t] == Sources::kNone)
      text += ",,,,,,,";
    else
      addRow((*sources.rows)[sources.of[t]], text);
    text += '\n';
  }
  writeText(text, path);
}

}  // namespace swept::cli
