// The header of a PLY file, read before any memory is allocated for the data.
// In:   stream at the start of the file, size of the file.
// Out:  counts, layout, start of the data.
// Throws Error(InvalidInput, "BadFile") if the header is damaged or declares more data than the
// file holds.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace swept {

struct PlyProperty {
  std::string name;
  int bytes = 0;       ///< size of the value, or of one list entry
  int countBytes = 0;  ///< size of the count before the entries of a list; 0 for a plain value
  bool isFloat = false;
  bool isSigned = false;  ///< an integer that may be negative
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  /// Returns the size in bytes that one element has in a binary file if all its lists are empty.
  std::uint64_t leastBytes() const;
};

struct PlyHeader {
  enum class Format { Ascii, LittleEndian, BigEndian };
  Format format = Format::Ascii;
  std::vector<PlyElement> elements;
  std::uint64_t dataStart = 0;  ///< offset in the file, bytes
  int lines = 0;                ///< lines of the header
  const PlyElement* find(const std::string& name) const;
};

PlyHeader readPlyHeader(std::istream& stream, std::uint64_t fileBytes, const std::string& path);

}  // namespace swept
