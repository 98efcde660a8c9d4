// Finds the curves in which the faces of one straight move intersect each other, where they are
// edges of the swept volume.
// In:      the body at the start of the move, cut at its contact curves; which of its edges sweep.
// Out:     kernel edges in world coordinates.
// Units:   mm.
// Cost:    O(c e) for c sweeping edges and e edges of the body; 2 s for a part of 80 faces.
// Method:  Seen along the move, the face that an edge sweeps is a curve. Where two such curves
//          cross, the two faces intersect in a line along the move. Where such a curve passes
//          before or behind a face of the body, the section is the curve, projected along the move
//          onto the face; it ends where the curve crosses the border of the face. So all these
//          sections follow from crossings of plane curves. The kernel's intersections of surfaces
//          fail where two faces are nearly tangent; these do not.
//          A. Appel, The notion of quantitative invisibility and the machine rendering of solids,
//          1967: the same idea, for drawings of polyhedra.
// Limits:  sections of faces of the body at the start with faces of the body at the end are not
//          found.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Vec.hxx>
#include <vector>

#include "solid/assemble/sides.h"

namespace swept::step {

/// A face of the body at the start of a straight move.
struct CapFace {
  TopoDS_Face face;
  bool atStart = false, atEnd = false;  ///< whether it may bound the envelope there
};

/// A curve in which the face that an edge sweeps intersects another face.
struct StraightSection {
  TopoDS_Edge edge;
  int sweeping;        ///< index of the edge
  int other = -1;      ///< index of the edge that sweeps the other face,
  int cap = -1;        ///< or index of that face, if it is one of the body
  bool atEnd = false;  ///< whether it is the face at the end of the move
};

/// `sweeping`: the edges that sweep faces. `borders`: all edges of the body.
std::vector<StraightSection> straightSections(const std::vector<CapFace>& caps,
                                              const std::vector<TopoDS_Edge>& sweeping,
                                              const std::vector<TopoDS_Edge>& borders,
                                              const gp_Vec& shift, const Sides& sides);

}  // namespace swept::step
