// OBJ and OFF files, in double precision and file order; a look at STL files before OpenMesh reads
// them, which reads on over text that is no number and welds by value, which must not see NaN.
// In:   stream at the start of the file. Out: vertices and faces. OpenMesh's readers are not asked
// for OBJ and OFF: they round to single precision and crash on texture numbers that do not exist.
// Throws Error(InvalidInput, "BadFile") with line and column of what is wrong. Cost: one pass,
// O(file size); text files are held in memory meanwhile.
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

/// Attributes (normals, colours, texture) are skipped; every index is seen to exist.
PolygonList readObj(std::istream& stream, const std::string& path);
PolygonList readOff(std::istream& stream, const std::string& path);
/// Refuses what is no number or not finite.
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
