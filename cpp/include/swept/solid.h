// Envelope mesh -> B-rep solid -> STEP / BREP file, and such files -> meshes. Built only where
// OpenCASCADE is present.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Application protocols of STEP: automotive design, and its successor; the latter also with the
/// triangles of the mesh as they are instead of a B-rep (no tolerance then, no limit of faces).
enum class StepSchema { Ap214, Ap242, Ap242Tessellated };
/// ap214 | ap242 | ap242-tessellated; throws Error(InvalidInput, "BadOption") listing the allowed
/// names.
StepSchema parseStepSchema(const std::string& text);

struct StepOptions {
  bool mergeCoplanar = true;      ///< flat regions become single planar faces with holes
  double planarTolerance = 1e-6;  ///< mm: how far a vertex may lie off its region's plane
  /// mm; above 0: the solid may leave the mesh by this. Then surfaces are recognised and what is
  /// left is simplified. 0: exact, unless a limit asks for more (see below).
  double tolerance = 0;
  bool exact = false;  ///< never leave the mesh: what exceeds a limit is refused at once
  /// A solid that leaves the mesh by more than the tolerance is refused instead of a finding:
  /// Error(ExportFailed, "SolidInaccurate").
  bool strict = false;
  /// With a tolerance: planes, cylinders, cones, spheres, tori, extrusions and revolutions.
  bool recognise = true;
  /// Limits. Without a tolerance of its own the solid gets the smallest one that meets them, up to
  /// 1 % of the box diagonal; what still exceeds them is refused as Error(ExportFailed,
  /// "TooManyFaces") with numbers.
  std::int64_t maxFaces = 20000;
  double maxMegabytes = 0;  ///< of the file; 0: no limit
  std::string productName = "Swept envelope";
  StepSchema schema = StepSchema::Ap214;
  std::string author;                              ///< file header; empty: not stated
  std::string organization;                        ///< file header; empty: not stated
  std::array<double, 3> colour{0.93, 0.78, 0.20};  ///< red, green, blue, 0 to 1
};

struct StepReport {
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  std::int64_t solids = 0;
  std::vector<std::pair<std::string, std::int64_t>>
      facesByKind;       ///< "plane", "cylinder", ..., "facet"
  double tolerance = 0;  ///< mm: the one given, or the one that the limits asked for
  double deviation = 0;  ///< mm: largest distance of a mesh vertex from the face that stands for it
  /// mm: largest tolerance of an edge or vertex in what was read back, at most `tolerance` of a
  /// simplified solid
  double edgeTolerance = 0;
  std::string note;       ///< what was given up to get a valid solid; empty: nothing
  bool valid = false;     ///< the kernel's check of what was read back
  double volume = 0;      ///< mm^3 of what was read back
  double meshVolume = 0;  ///< mm^3
  std::uint64_t fileBytes = 0;
  double secondsBuild = 0, secondsWrite = 0, secondsReread = 0;
  std::vector<Finding> warnings;  ///< SolidSimplified, SolidNote, SolidInaccurate
};
/// The key "solid" of a report as JSON text, without the warnings (docs/report.schema.json).
std::string toJson(const StepReport& report);

enum class SolidFormat { Step, Brep };
/// By suffix: .step/.stp or .brep/.brp. Throws Error(ExportFailed, "BadSuffix").
SolidFormat solidFormatOf(const std::string& path);

/// What a solid would take.
struct SolidEstimate {
  std::int64_t triangles = 0;
  std::int64_t faces = 0;
  double megabytes = 0;     ///< of the file
  double seconds = 0;       ///< elapsed, of writeSolid
  double trialSeconds = 0;  ///< elapsed, of the trial itself; part of `seconds`
  double tolerance = 0;     ///< mm, of a trial: the one given, or the one that the limits ask for
  double deviation = 0;     ///< mm, of a trial: as in StepReport
  bool tried = false;       ///< from a trial; else faces is an upper bound
};
/// The key "estimate" of a report as JSON text (docs/report.schema.json).
std::string toJson(const SolidEstimate& estimate);

/// From a look at the mesh: all figures are upper bounds, far too large where surfaces are
/// recognised. Cost: some microseconds a triangle. Throws Error(ExportFailed) where no solid can be
/// made of the mesh at all.
SolidEstimate guessSolid(const TriMesh& mesh, const StepOptions& options, SolidFormat format,
                         RunContext& run);

/// From a trial: the solid is built and written without a file, so faces and bytes are those of
/// writeSolid, and the seconds of what follows are foretold. Cost: writeSolid without reading back.
/// Throws what writeSolid throws before it reads back: Error(ExportFailed, "TooManyFaces", ...),
/// Error(Cancelled).
SolidEstimate trySolid(const TriMesh& mesh, const StepOptions& options, SolidFormat format,
                       RunContext& run);

/// Format by suffix: .step/.stp or .brep/.brp. Written beside the target, re-read, checked (one
/// solid per outer shell, valid, same volume), then renamed; on any failure the old file survives
/// and nothing is left behind. Throws Error(ExportFailed, ...), Error(Cancelled).
StepReport writeSolid(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                      RunContext& run);

struct ImportedSolid {
  /// Of its product in a STEP file of several products, else the file's without suffix; numbered
  /// where several have it.
  std::string name;
  TriMesh mesh;  ///< mm; every face has corners of its own, and its number in the file from 0
};

/// Every solid of the file; if there is none, all its faces as one open mesh. linearDeflection: mm,
/// how far triangles may leave the surface; angularDeflection: rad between neighbouring triangles.
/// Throws Error(InvalidInput, "BadFile" | "NoSurface"), Error(Cancelled).
std::vector<ImportedSolid> readSolids(const std::string& path, double linearDeflection,
                                      double angularDeflection, RunContext& run);

/// What the kernel finds in a STEP or BREP file.
struct SolidCheck {
  std::int64_t solids = 0, shells = 0, faces = 0, edges = 0;
  bool valid = false;        ///< at least one solid; faces valid, shells closed and oriented
  std::string complaint;     ///< empty when valid
  double volume = 0;         ///< mm^3
  double edgeTolerance = 0;  ///< mm: largest tolerance of an edge or vertex
};

/// Throws Error(InvalidInput, "BadFile"), Error(Cancelled).
SolidCheck checkSolidFile(const std::string& path, RunContext& run);

}  // namespace swept
