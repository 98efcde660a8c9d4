// Reads the faces and edges of a kernel shape as carriers and curves.
// In:      a shape; `faces` maps its faces to their numbers.
// Out:     BodyShape. A surface that no Carrier can represent has the kind Facet.
// Units:   mm.
// Cost:    O(faces + edges).
// The caller must hold a KernelSession.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "solid/label/body_shape.h"

namespace swept::step {

BodyShape shapeOf(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces);

}  // namespace swept::step
