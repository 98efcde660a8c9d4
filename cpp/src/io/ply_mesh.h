// Reads PLY files, text and binary, in double precision. The files may have additional properties.
// OpenMesh's reader is not used: it rounds to single precision, never stops on a header that it
// does not understand, and its version 11 crashes on unknown properties.
// In:   stream, header and size of the file.
// Out:  vertices and faces in file order. The indices are not checked yet.
// Throws Error(InvalidInput, "BadFile"); the message gives the position of the error.
// Cost: one pass, O(file size). A text file is read into memory as a whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "io/ply_header.h"
#include "io/polygon_list.h"

namespace swept {

PolygonList readPlyMesh(std::istream& stream, const PlyHeader& header, std::uint64_t fileBytes,
                        const std::string& path);

}  // namespace swept
