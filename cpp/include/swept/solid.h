// Converts an envelope mesh to a B-rep solid in a STEP or BREP file, and reads meshes from such
// files. If the library was built without OpenCASCADE, the application must read them: writeSolid()
// then needs a StepReader, and readBody() and readParts() (swept/body.h) need a SolidReader.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {

/// Application protocols of STEP: AP214 (automotive design) and its successor AP242.
/// Ap242Tessellated writes the triangles of the mesh instead of a B-rep; then there is no tolerance
/// and no limit of faces.
enum class StepSchema { Ap214, Ap242, Ap242Tessellated };
/// Parses ap214, ap242 or ap242-tessellated. Throws Error(InvalidInput, "BadOption") with the
/// allowed names.
StepSchema parseStepSchema(const std::string& text);

struct BodyShape;  // the faces and edges of a body, as readSolids() or readBodyShape() found them

/// What an envelope was made from. If the body moves along straight lines or turns about fixed
/// axes, the solid gets the exact faces of the sweep: faces of the body at poses, and surfaces that
/// its edges and contact curves sweep.
struct SolidOrigin {
  Trajectory trajectory;
  std::shared_ptr<const BodyShape> shape;
};

struct SolidOptions {
  bool mergeCoplanar = true;      ///< merge each flat region to one planar face with holes
  double planarTolerance = 1e-6;  ///< mm: how far a vertex may lie off the plane of its region
  /// mm. Above 0: the solid may deviate by this from the mesh; surfaces are recognised, and the
  /// other triangles are simplified. 0: exact, unless a limit requires a tolerance (see maxFaces).
  double tolerance = 0;
  bool exact = false;  ///< never deviate from the mesh: a solid above a limit is refused at once
  /// Refuse a solid that deviates from the mesh by more than the tolerance, with
  /// Error(ExportFailed, "SolidInaccurate"). Otherwise it only gets a finding.
  bool strict = false;
  /// With a tolerance: recognise planes, cylinders, cones, spheres, tori, extrusions and
  /// revolutions.
  bool recognise = true;
  /// With a tolerance and `recognise`: take the surfaces from these data. Null: recognise them in
  /// the mesh.
  std::shared_ptr<const SolidOrigin> origin;
  /// Limits of faces and file size. If `tolerance` is 0, the smallest tolerance that meets the
  /// limits is used, up to 1 % of the diagonal of the bounding box. A solid that still exceeds a
  /// limit is refused with Error(ExportFailed, "TooManyFaces"), whose text has the figures.
  std::int64_t maxFaces = 20000;
  std::optional<double> maxMegabytes;  ///< limit of the file size, above 0; not set: no limit
  std::string productName = "Swept envelope";
  StepSchema schema = StepSchema::Ap214;
  std::string author;                              ///< for the file header; empty: not stated
  std::string organization;                        ///< for the file header; empty: not stated
  std::array<double, 3> colour{0.93, 0.78, 0.20};  ///< red, green, blue, 0 to 1
};

struct WrittenSolid {
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  std::int64_t solids = 0;
  std::vector<std::pair<std::string, std::int64_t>>
      facesByKind;       ///< "plane", "cylinder", ..., "facet"
  double tolerance = 0;  ///< mm: the given tolerance, or the one that the limits required
  /// mm: largest distance of a mesh vertex from the face that replaces its triangles.
  double deviation = 0;
  /// mm: largest tolerance of an edge or vertex in the solid that was read back. For a simplified
  /// solid, at most `tolerance`.
  double edgeTolerance = 0;
  std::string note;       ///< what was given up to get a valid solid; empty: nothing was
  bool valid = false;     ///< result of the kernel's check of the solid that was read back
  double volume = 0;      ///< mm^3, of the solid that was read back
  double meshVolume = 0;  ///< mm^3, of the mesh
  std::uint64_t fileBytes = 0;
  double secondsBuild = 0, secondsWrite = 0, secondsReread = 0;
  std::vector<Finding> warnings;  ///< SolidSimplified, SolidNote, SolidInaccurate
};
/// Returns the key "solid" of a report as JSON text, without the warnings
/// (docs/report.schema.json).
std::string toJson(const WrittenSolid& report);

enum class SolidFormat { Step, Brep };
/// Returns the format for a suffix: .step/.stp or .brep/.brp. Throws Error(ExportFailed,
/// "BadSuffix").
SolidFormat solidFormatOf(const std::string& path);

/// Estimated effort of writing a solid.
struct SolidEstimate {
  std::int64_t triangles = 0;
  std::int64_t faces = 0;
  double megabytes = 0;     ///< of the file
  double seconds = 0;       ///< duration of writeSolid
  double trialSeconds = 0;  ///< the part of `seconds` already spent in the trial
  /// mm, only after a trial: the given tolerance, or the one that the limits require.
  double tolerance = 0;
  double deviation = 0;  ///< mm, only after a trial: as in WrittenSolid
  bool tried = false;    ///< true: the figures come from a trial; false: `faces` is an upper bound
};
/// Returns the key "estimate" of a report as JSON text (docs/report.schema.json).
std::string toJson(const SolidEstimate& estimate);

/// Estimates from the mesh alone. All figures are upper bounds, far too large if surfaces can be
/// recognised. Cost: some microseconds for each triangle. Throws Error(ExportFailed) if no solid
/// can be made from the mesh at all.
SolidEstimate guessSolid(const TriMesh& mesh, const SolidOptions& options, SolidFormat format,
                         RunContext& run);

/// Estimates by a trial: builds and writes the solid, but makes no file. Faces and bytes are those
/// of writeSolid; the duration of its remaining steps is estimated. Cost: as writeSolid without
/// reading back. Throws what writeSolid throws before it reads back: Error(ExportFailed,
/// "TooManyFaces", ...), Error(Cancelled).
SolidEstimate trySolid(const TriMesh& mesh, const SolidOptions& options, SolidFormat format,
                       RunContext& run);

/// Writes a solid; the suffix gives the format: .step/.stp or .brep/.brp. The file is written
/// beside the target, read back, checked (one solid for each outer shell, valid, same volume) and
/// then renamed. After a failure the old file is unchanged and no new file remains. Throws
/// Error(ExportFailed, ...), Error(Cancelled).
WrittenSolid writeSolid(const TriMesh& mesh, const std::string& path, const SolidOptions& options,
                        RunContext& run);

/// Result of the kernel's check of a STEP or BREP file.
struct SolidCheck {
  std::int64_t solids = 0, shells = 0, faces = 0, edges = 0;
  /// There is at least one solid, all faces are valid, all shells closed and oriented.
  bool valid = false;
  std::string complaint;     ///< empty if valid
  double volume = 0;         ///< mm^3
  double edgeTolerance = 0;  ///< mm: largest tolerance of an edge or vertex
};

/// A reader of STEP files that the application provides, for example with FreeCAD. A library that
/// was built without a geometry kernel uses it, so that no two kernels get into one process.
class StepReader {
 public:
  struct Answer {
    SolidCheck check;
    /// Indices of the faces that are not valid, from 0, in the order of the file.
    std::vector<std::int32_t> badFaces;
  };
  virtual ~StepReader() = default;
  /// Reads a STEP file, given as its text. Called in the thread of the run. An exception ends the
  /// run.
  virtual Answer read(const std::string& text) = 0;
};
/// Does the same as the function above, but uses `reader` instead of a geometry kernel. STEP files
/// only. The file is the same as with a kernel, except if the kernel would find intersecting faces
/// or edges that do not lie on their faces. `reader` cannot find these.
WrittenSolid writeSolid(const TriMesh& mesh, const std::string& path, const SolidOptions& options,
                        StepReader& reader, RunContext& run);

struct ImportedSolid {
  /// The name of its product. If all solids have the same product name (also if there is only one
  /// solid), or if one has none: the name of the file without suffix. Equal names are numbered.
  std::string name;
  TriMesh mesh;  ///< mm; no two faces share vertices; faceOf has the index of the face in the file
};

/// Reads all solids of a file. If there is none, reads all faces as one open mesh. `shape`, unless
/// null, receives the faces and edges of the whole file.
/// linearDeflection: how far (mm) triangles may deviate from the surface. angularDeflection: angle
/// (rad) between adjacent triangles. Throws Error(InvalidInput, "BadFile" | "NoSurface"),
/// Error(Cancelled). Without a kernel: Error(InvalidInput, "BadFormat").
std::vector<ImportedSolid> readSolids(const std::string& path, double linearDeflection,
                                      double angularDeflection, RunContext& run,
                                      std::shared_ptr<const BodyShape>* shape = nullptr);

/// A reader of STEP and BREP files that the application provides, for example with FreeCAD's Part
/// module. readBody() and readParts() (swept/body.h) use it if this library was built without a
/// geometry kernel.
class SolidReader {
 public:
  virtual ~SolidReader() = default;
  /// Does what readSolids() does. Called in the thread of the run. An exception ends the run.
  virtual std::vector<ImportedSolid> read(const std::string& path, double linearDeflection,
                                          double angularDeflection) = 0;
};

/// Reads the faces and edges of a STEP or BREP file, for SolidOrigin. Throws like readSolids().
std::shared_ptr<const BodyShape> readBodyShape(const std::string& path, RunContext& run);

/// Throws Error(InvalidInput, "BadFile" | "BadFormat"), Error(Cancelled).
SolidCheck checkSolidFile(const std::string& path, RunContext& run);

}  // namespace swept
