// Reads a moving part from a mesh file or from a solid file (STEP, BREP), which is tessellated.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct BodyFileOptions {
  /// Unit of the numbers in a mesh file; a solid file states its own unit.
  double millimetresPerUnit = 1;
  /// How far (mm) triangles may deviate from the surface of a solid. Not set: derived from the
  /// cell.
  std::optional<double> tolerance;
  /// mm, cell size of the later run; not set: derived from `resolution`
  std::optional<double> cellSize;
  int resolution = 128;  ///< cells along the longest side of the sweep
  /// Largest angle (rad) between adjacent triangles of a solid; 0.2 gives a circle 32 sides.
  double angle = 0.2;
};

struct BodyShape;  // see solid.h
class SolidReader;

struct Body {
  TriMesh mesh;  ///< for a solid, faceOf has the indices of its faces, in the order of the file
  /// mm, how far triangles may deviate from the exact surface; 0: a mesh file.
  double chordError = 0;
  std::vector<Finding> findings;             ///< to be added to the report of the run
  std::shared_ptr<const BodyShape> shape{};  ///< faces and edges of a solid; null: a mesh file
};

/// Tolerance of the triangles as a fraction of the cell. It equals the default of the chord
/// tolerance, so that both errors have the same size.
constexpr double kTessellationFraction = kChordFraction;

/// Returns whether a file holds a solid, judged by its suffix (step, stp, brep, brp). If the suffix
/// is unknown, the first bytes of the file decide.
bool isSolidFile(const std::string& path);

/// Reads all solids of a file as one body. Without a cell size, the tolerance follows from the
/// smallest cell that the sweep of such a body can have at this resolution. Throws
/// Error(InvalidInput, "BadFile" | "NoSurface" | "BadFormat" | "BadOption"), Error(Cancelled).
Body readBody(const std::string& path, const BodyFileOptions& options, RunContext& run);
/// Does the same, but `reader` reads the solid files instead of a geometry kernel. Body::shape is
/// null.
Body readBody(const std::string& path, const BodyFileOptions& options, SolidReader& reader,
              RunContext& run);

struct PartFileOptions {
  /// Unit of the numbers in a mesh file; a solid file states its own unit.
  double millimetresPerUnit = 1;
  /// mm, for a mesh file: how far its triangles deviate from the exact surface.
  double chordError = 0;
  double deflection = 0.05;  ///< mm, how far triangles may deviate from the surface of a solid
};

struct NamedPart {
  std::string name;
  TriMesh mesh;
  double chordError = 0;  ///< mm, how far triangles may deviate from the exact surface
};

/// Reads parts with their names. A mesh file is one part with the name of the file. Each solid of a
/// STEP or BREP file is one part with the name of its product. Throws Error(InvalidInput, "BadFile"
/// | "NoSurface" | "BadFormat"), Error(Cancelled).
std::vector<NamedPart> readParts(const std::string& path, const PartFileOptions& options,
                                 RunContext& run);
/// Does the same, but `reader` reads the solid files instead of a geometry kernel.
std::vector<NamedPart> readParts(const std::string& path, const PartFileOptions& options,
                                 SolidReader& reader, RunContext& run);

}  // namespace swept
