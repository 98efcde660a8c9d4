// Reads STL files, text and binary. Their coordinates have single precision.
// In:   stream at the start of the file, size of the file.
// Out:  vertices and triangles in file order. Corners with equal coordinates are one vertex.
//       Triangles with two equal corners are left out.
// Throws Error(InvalidInput, "BadFile") with the position of the error, or "NonFiniteVertex".
// Cost: O(n log n) for n triangles. A text file is read into memory as a whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "io/polygon_list.h"

namespace swept {

PolygonList readStl(std::istream& stream, std::uint64_t fileBytes, const std::string& path);

}  // namespace swept
