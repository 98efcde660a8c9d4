// STEP or BREP file -> one triangle mesh a solid. Built only where OpenCASCADE is present.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct ImportedSolid {
  std::string name;  ///< file name without suffix, numbered if there is more than one solid
  TriMesh mesh;      ///< mm; every face has corners of its own
};

/// Every solid of the file; if there is none, all its faces as one open mesh. linearDeflection: mm,
/// how far triangles may leave the surface; angularDeflection: rad between neighbouring triangles.
/// Throws Error(InvalidInput, "BadFile" | "NoSurface"), Error(Cancelled).
std::vector<ImportedSolid> readSolids(const std::string& path, double linearDeflection,
                                      double angularDeflection, RunContext& run);

/// What the kernel finds in a STEP or BREP file.
struct SolidCheck {
  std::int64_t solids = 0, shells = 0, faces = 0, edges = 0;
  bool valid = false;     ///< at least one solid; faces valid, shells closed and oriented
  std::string complaint;  ///< empty when valid
  double volume = 0;      ///< mm^3
};

/// Throws Error(InvalidInput, "BadFile"), Error(Cancelled).
SolidCheck checkSolidFile(const std::string& path, RunContext& run);

}  // namespace swept
