// What a PLY file says about itself, read before anything is allocated for it.
// In:   stream at the start of the file, size of the file. Out: counts, layout, start of the data.
// Throws Error(InvalidInput, "BadFile") where the header is broken or promises more than is there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace swept {

struct PlyProperty {
  std::string name;
  int bytes = 0;       ///< of the value, or of one list entry
  int countBytes = 0;  ///< lists: of the count; 0 for a plain value
  bool isFloat = false;
  bool isSigned = false;  ///< a whole number that may be below 0
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  /// Least bytes of one element in a binary file (empty lists).
  std::uint64_t leastBytes() const;
};

struct PlyHeader {
  enum class Format { Ascii, LittleEndian, BigEndian };
  Format format = Format::Ascii;
  std::vector<PlyElement> elements;
  std::uint64_t dataStart = 0;  ///< bytes
  int lines = 0;                ///< of the header
  const PlyElement* find(const std::string& name) const;
};

PlyHeader readPlyHeader(std::istream& stream, std::uint64_t fileBytes, const std::string& path);

}  // namespace swept
