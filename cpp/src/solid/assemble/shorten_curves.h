// Cuts the splines of edges to the parts that the edges use. A STEP file contains a spline as a
// whole for each edge on it.
// Cost:    O(poles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace swept::step {

/// The edges themselves change.
void shortenCurves(const TopoDS_Shape& shape);

}  // namespace swept::step
