// A second look at an OBJ, OFF or STL file beside OpenMesh's readers, which round every coordinate
// to single precision and read on over text that is no number. In:   stream at the start of the
// file. Out: vertices in double, in file order, where there are any. Throws Error(InvalidInput,
// "BadFile") with line and column of what is wrong. Cost: one pass, O(file size); text files are
// held in memory meanwhile.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_scanner.h"
#include "swept/types.h"

namespace swept {

struct ExactNumbers {
  bool present = false;  ///< false: single precision is all the file has
  std::vector<Eigen::Vector3d> vertices;
  /// OBJ and OFF: the same mesh with nothing but positions and faces, every number seen to be one
  /// and every index to exist. OpenMesh's readers crash on texture numbers that do not.
  std::string cleaned;
};

ExactNumbers readExactObj(std::istream& stream, const std::string& path);
ExactNumbers readExactOff(std::istream& stream, const std::string& path);
/// STL coordinates are welded by value while reading, which must not see NaN.
void checkTextStl(std::istream& stream, const std::string& path);
void checkBinaryStl(std::istream& stream, const std::string& path);

std::string readAll(std::istream& stream);
/// What a word says; throws as TextScanner::expected() where it is no number.
double toNumber(TextScanner& scan, std::string_view word);
std::int64_t toInteger(TextScanner& scan, std::string_view word);
/// Whole-text number parsing, independent of the locale; a leading + is accepted.
bool parseNumber(std::string_view text, double& value);
bool parseInteger(std::string_view text, std::int64_t& value);

}  // namespace swept
