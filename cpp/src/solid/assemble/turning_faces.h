// Makes the faces of which the envelope of a body may consist, and the curves along which they
// touch, for motion steps in which the body moves and turns at the same time.
// In:      a body that is one solid; its poses.
// Out:     faces in world coordinates: the body at each pose, the surfaces that its convex edges
//          sweep in each step, and the surfaces in which its faces graze the envelope. They are
//          larger than necessary: each covers the whole edge or face and the whole step. What
//          slides along a surface has one face for all its copies (fixed_surfaces.h).
// Units:   mm.
// Cost:    some milliseconds for each face.
// Method:  A face touches the envelope along contact curves (contact_curves.h), which sweep its
//          grazing surface. Where a contact curve meets an edge of the face, the surface that the
//          edge sweeps continues smoothly into the grazing surface. Where a contact curve follows
//          the motion, the grazing surface has an edge of regression and turns back. All these
//          curves divide the faces. They are zeros of functions of two parameters (zero_curves.h).
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
  std::vector<SweptSection> folds;  ///< dividers at which a face turns back
  std::vector<gp_Pnt> crossings;    ///< of dividers and folds
};

/// `body`: in coordinates whose origin is the pivot. `trajectory`: the result of carriedByPivot().
/// Returns nothing if a vertex is at rest, or if a round face turns about its axis. Leaves out what
/// has no regular surface.
std::optional<TurningFaces> turningFaces(const TopoDS_Shape& body, const Trajectory& trajectory);

}  // namespace swept::step
