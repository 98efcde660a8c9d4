// Envelope mesh -> B-rep solid -> STEP / BREP. Built only where OpenCASCADE is present.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct StepOptions {
  bool mergeCoplanar = true;      ///< flat regions become single planar faces with holes
  double planarTolerance = 1e-6;  ///< mm: how far a vertex may lie off its region's plane
  double tolerance = 0;   ///< mm; > 0: the solid may leave the mesh by this. Then surfaces are
                          ///< recognised and what is left is simplified before it becomes facets
  bool recognise = true;  ///< with a tolerance: planes, cylinders, cones, spheres and tori
  std::int64_t maxFaces = 120000;  ///< above: Error(ExportFailed, "TooManyFaces") with numbers
  std::string productName = "Swept envelope";
  std::string schema = "AP214IS";  ///< AP214IS | AP242DIS | AP203
  std::string author;              ///< file header; empty: not stated
  std::string organization;        ///< file header; empty: not stated
};

struct StepReport {
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  std::int64_t solids = 0;
  std::vector<std::pair<std::string, std::int64_t>>
      facesByKind;       ///< "plane", "cylinder", ..., "facet"
  double deviation = 0;  ///< mm: largest distance of a mesh vertex from the face that stands for it
  std::string note;      ///< what was given up to get a valid solid; empty: nothing
  bool valid = false;    ///< BRepCheck on what was read back
  double volume = 0;     ///< mm^3 of what was read back
  double meshVolume = 0;  ///< mm^3
  std::uint64_t fileBytes = 0;
  double secondsBuild = 0, secondsWrite = 0, secondsReread = 0;
};

/// Format by suffix: .step/.stp or .brep/.brp. Written beside the target, re-read, checked (one
/// solid per outer shell, valid, same volume), then renamed; on any failure the old file survives
/// and nothing is left behind. Throws Error(ExportFailed, ...), Error(Cancelled).
StepReport writeSolid(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                      RunContext& run);

}  // namespace swept
