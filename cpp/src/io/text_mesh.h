// Reads OBJ and OFF files in double precision and file order, and checks STL files before OpenMesh
// reads them. OpenMesh silently skips text that is not a number. It also compares vertices to weld
// them, which fails for NaN. Its readers for OBJ and OFF are not used: they round to single
// precision and crash on missing texture indices.
// In:   stream at the start of the file. Out: vertices and faces.
// Throws Error(InvalidInput, "BadFile") with the line and column of the error.
// Cost: one pass, O(file size). A text file is read into memory as a whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "swept/types.h"

namespace swept {

/// Read vertices and faces, ignore normals, colours and texture, and check that every index exists.
PolygonList readObj(std::istream& stream, const std::string& path);
PolygonList readOff(std::istream& stream, const std::string& path);
/// Check that all coordinates are finite numbers; throw Error(InvalidInput, "NonFiniteVertex") if
/// not.
void checkTextStl(std::istream& stream, const std::string& path);
void checkBinaryStl(std::istream& stream, const std::string& path);

std::string readAll(std::istream& stream);
/// Convert a word to a number. Throw like TextScanner::expected() if the word is not a number.
double toNumber(TextScanner& scan, std::string_view word);
std::int64_t toInteger(TextScanner& scan, std::string_view word);
/// Parse a text that must consist of one number, which may have a leading +. The locale does not
/// matter. Return false if the text is anything else.
bool parseNumber(std::string_view text, double& value);
bool parseInteger(std::string_view text, std::int64_t& value);

}  // namespace swept
