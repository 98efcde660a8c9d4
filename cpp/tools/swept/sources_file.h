// Writes a table that gives, for each triangle of an envelope, the face or edge of the body that
// made it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/sources.h"

namespace swept::cli {

/// Writes a row for each triangle, in the order of the mesh: triangle, kind, face, other_face,
/// step, time_s, x, y, z (mm). Unknown values are empty. Writes to a file, or to standard output
/// for "-". Throws Error(ExportFailed).
void writeSources(const Sources& sources, const std::string& path);

}  // namespace swept::cli
