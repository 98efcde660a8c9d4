// The moving part from a file of any kind: a mesh, or a solid (STEP, BREP) that is tessellated.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct BodyFileOptions {
  double millimetresPerUnit = 1;  ///< of a mesh file; a solid states its own unit
  /// mm: how far triangles may leave the surface of a solid; not given: from the cell.
  std::optional<double> tolerance;
  std::optional<double> cellSize;  ///< mm: of the run to come; not given: from resolution
  int resolution = 128;            ///< cells along the longest side of the sweep
  double angle = 0.2;  ///< rad between neighbouring triangles of a solid: a circle has 32 sides
};

struct Body {
  TriMesh mesh;           ///< with the faces of a solid, counted from 0 in the order of its file
  double chordError = 0;  ///< mm: how far triangles may leave the exact surface; 0: a mesh file
  std::vector<Finding> findings;  ///< for the report of the run
};

/// Of a cell: as far as a refined motion leaves its chord, so that both errors are alike.
constexpr double kTessellationFraction = 0.02;

/// Is it a solid by its suffix (step, stp, brep, brp), or by its first bytes where the suffix says
/// nothing?
bool isSolidFile(const std::string& path);

/// All solids of a file are one body. Without a cell size the tolerance follows from the smallest
/// cell that the sweep of such a body can have at this resolution. Throws Error(InvalidInput,
/// "BadFile" | "NoSurface" | "BadFormat" | "BadOption"), Error(Cancelled).
Body readBody(const std::string& path, const BodyFileOptions& options, RunContext& run);

struct PartFileOptions {
  double millimetresPerUnit = 1;  ///< of a mesh file; a solid states its own unit
  double chordError = 0;          ///< mm, of a mesh file: how far it leaves its exact surface
  double deflection = 0.05;       ///< mm: how far triangles may leave the surface of a solid
};

struct NamedPart {
  std::string name;
  TriMesh mesh;
  double chordError = 0;  ///< mm
};

/// Parts that keep their own names: a mesh file is one, named after the file; of a STEP or BREP
/// file each solid is one, named after its product. Throws Error(InvalidInput, "BadFile" |
/// "NoSurface" | "BadFormat"), Error(Cancelled).
std::vector<NamedPart> readParts(const std::string& path, const PartFileOptions& options,
                                 RunContext& run);

}  // namespace swept
