// Makes the edges along which two faces of a shape intersect exact. The kernel's own curves of
// intersection are up to 1e-5 mm off the surfaces, between the points where a reader of a STEP file
// looks; FreeCAD's check then lists the edges as InvalidCurveOnSurface.
// In:      a shape. Only edges on splines between two faces that cross are changed.
// Out:     new curves of these edges and on their faces, within 1e-8 mm of both surfaces.
// Units:   mm.
// Cost:    some hundred projections for each edge.
// Source:  Newton's method on both surfaces: Patrikalakis and Maekawa 2002.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace swept::step {

void makeSectionsExact(const TopoDS_Shape& shape);

}  // namespace swept::step
