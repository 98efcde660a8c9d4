// PLY files, text and binary, in double precision and with properties of any kind beside the mesh.
// OpenMesh's reader is not asked: it rounds to single precision, reads on for ever over a header it
// does not understand, and its version 11 crashes on properties that it does not know.
// In:   stream, its header and size. Out: vertices and faces in file order, indices not yet
// checked. Throws Error(InvalidInput, "BadFile") with the place of what is wrong. Cost: one pass,
// O(file size); text files are held in memory meanwhile.
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
