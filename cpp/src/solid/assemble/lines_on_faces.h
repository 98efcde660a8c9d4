// Edges that are straight in the parameters of a face.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt2d.hxx>

namespace swept::step {

/// Returns the line with the parameters `first` to `last`.
Handle(Geom2d_Curve) lineOn(const gp_Pnt2d& from, const gp_Pnt2d& to, double first, double last);

/// Returns the edge of a face that is a point, but a line in the parameters.
TopoDS_Edge degeneratedEdge(const TopoDS_Vertex& vertex, const gp_Pnt2d& from, const gp_Pnt2d& to,
                            const TopoDS_Face& face);

/// Raises the tolerance of an edge until it contains its curve on a face. The vertices of faces are
/// less exact than their edges.
void coverCurve(const TopoDS_Edge& edge, const TopoDS_Face& face);

}  // namespace swept::step
