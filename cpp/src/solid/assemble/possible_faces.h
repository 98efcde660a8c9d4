// Drops faces and parts of faces that do not meet the conditions for faces of the envelope
// (envelope_conditions.h).
// Cost:    some hundred conditions for each face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "solid/assemble/swept_faces.h"
#include "solid/assemble/turning_faces.h"

namespace swept::step {

/// Drops the faces of which no sample meets its conditions, and the curves on them.
void dropImpossible(TurningFaces& made);

struct PossiblePieces {
  TopoDS_Shape shape;
  /// Pieces that nearly meet the conditions: no sample can tell whether they are on the envelope.
  TopTools_MapOfShape unlikely;
};

/// Returns those pieces that meet the conditions of the faces that were divided.
PossiblePieces possiblePieces(const TopoDS_Shape& pieces, const std::vector<SweptFace>& faces);

}  // namespace swept::step
