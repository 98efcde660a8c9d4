// Makes the faces of which the envelope of a polyhedron may consist, and the curves along which
// they touch, for motion steps in which the body moves and turns at the same time.
// In:      a body with plane faces and straight edges; its poses.
// Out:     faces in world coordinates: the body at each pose, the surfaces that its convex edges
//          sweep in each step, and the surfaces in which its faces graze the envelope. They are
//          larger than necessary: each covers the whole edge or face and the whole step.
// Units:   mm.
// Cost:    some milliseconds for each face.
// Method:  A point p of the body has the velocity v = linear + angular x p, in coordinates of the
//          body. A face with the normal n touches the envelope where n.v = 0: along a line, which
//          keeps its direction in the face while it moves across it. So the grazing surface is
//          ruled. It has an edge of regression where the line follows the motion; there the surface
//          turns back. Where n.v = 0 on an edge of the face, the swept edge continues smoothly into
//          the grazing surface. All these curves are functions of time, and divide the faces.
// Source:  Abdel-Malek, Blackmore and Joy 2006; Adsul, Machchhar and Sohoni, CAGD 31 (2014).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <optional>
#include <vector>

#include "solid/assemble/divide_faces.h"
#include "solid/assemble/swept_faces.h"
#include "swept/types.h"

namespace swept::step {

struct TurningFaces {
  std::vector<SweptFace> faces;
  std::vector<SweptSection> dividers;
  std::vector<gp_Pnt> crossings;  ///< of dividers
};

/// `body`: a polyhedron (polyhedron.h) in coordinates whose origin is the pivot. `trajectory`: the
/// result of carriedByPivot(). Returns nothing if a face slides along itself or a vertex is at
/// rest.
std::optional<TurningFaces> turningFaces(const TopoDS_Shape& body, const Trajectory& trajectory);

}  // namespace swept::step
