// Reads the faces and edges of a kernel shape as carriers and curves.
// In:      a shape; `faces` gives the numbers of its faces.
// Out:     BodyShape. A surface that no Carrier can hold has the kind Facet.
// Units:   mm.
// Cost:    O(faces + edges).
// The caller holds the KernelSession.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "solid/label/body_shape.h"

namespace swept::step {

BodyShape shapeOf(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces);

}  // namespace swept::step
