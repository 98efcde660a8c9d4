// Makes solids from faces that share their edges.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace swept::step {

/// Returns how many different faces, edges or other parts of a kind a shape has.
int countOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

/// Returns the diagonal of the box around a shape, mm.
double sizeOf(const TopoDS_Shape& shape);

TopoDS_Compound compoundOf(const std::vector<TopoDS_Face>& faces);
/// Returns the faces of a shape in their order, with their orientations in it.
std::vector<TopoDS_Face> facesIn(const TopoDS_Shape& shape);

/// Returns a solid, or a compound of one solid for each outer shell. Unless `areJoined`, adjacent
/// faces of one surface are joined. `faces`: closed, with their normals outward. Returns a null
/// shape if the volume (mm^3) differs by more than `accuracy`, or if the solid is not valid.
TopoDS_Shape solidOf(const std::vector<TopoDS_Face>& faces, double volume, double accuracy,
                     bool areJoined = false);

/// Returns the shape with adjacent faces of one surface joined, if the kernel can do this.
/// `withEdges`: whether adjacent edges of one curve are joined, too.
TopoDS_Shape joined(const TopoDS_Shape& shape, bool withEdges);

}  // namespace swept::step
