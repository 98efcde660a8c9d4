// Makes the solid of a sweep from the faces and edges of the moving body. The mesh of the envelope
// is not needed.
// In:      the faces of swept_faces.h.
// Out:     a kernel solid, or a compound of solids, whose faces are parts of the body's faces and
//          of the surfaces that its edges and contact curves sweep. Nothing, if these do not form a
//          closed surface.
// Units:   mm.
// Cost:    seconds: 2 s for a part of 80 faces, 12 s for one of 240.
// Method:  1. If the sections of the faces are known, they divide the faces (divide_faces.h). Those
//             pieces are taken that have the swept volume on one side only. If they are closed,
//             steps 2 to 5 are not needed.
//          2. Faces without a point on the surface of the swept volume are put aside. The kernel
//             cuts all faces where they intersect (its "general fuse").
//          3. The pieces enclose cells. Sample points on both sides of the pieces tell which cells
//             lie inside the swept volume (swept_interior.h). The envelope bounds these cells.
//          4. Where the pieces do not enclose everything, those are taken that have the swept
//             volume on one side only. Their edges must have two of them each. Where they do not,
//             faces that were put aside are used after all.
//          5. Connected pieces form shells; adjacent pieces of one surface are joined.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Message_ProgressRange.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "solid/assemble/sides.h"
#include "solid/assemble/swept_faces.h"

namespace swept::step {

struct AssembledSweep {
  TopoDS_Shape shape;      ///< null if there is no solid with the volume of the envelope
  bool isCertain = false;  ///< whether the sides of all its faces are certain
  double filled = 0;       ///< mm: the largest width of a groove that the solid does not have
  /// Faces of which the samples are certain. If `shape` is null, there are open edges between
  /// them.
  std::vector<TopoDS_Face> parts = {};
};

/// `faces`: all of which the envelope may consist. `sides`: of the same sweep. `volume` (mm^3) of
/// the envelope, known with this `accuracy` (mm^3). May throw Standard_Failure.
AssembledSweep assembleSweep(const SweptFaces& faces, const Sides& sides, double volume,
                             double accuracy, const Message_ProgressRange& progress);

}  // namespace swept::step
