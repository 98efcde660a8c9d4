// Fine triangles of a body, or of the faces of another shape.
// Units:   mm.
// Cost:    some microseconds per triangle.
// Method:  The kernel's mesher makes coarse triangles. A side is halved if it is too far from the
//          curve of its edge, or from the surface of the face. Each triangle is cut at the middles
//          of its sides. This is repeated until all sides are near enough; a plane keeps its large
//          triangles. (If the kernel is to make such fine triangles, it takes minutes, and it makes
//          none that are finer than the tolerances of edges.)
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

#include "swept/types.h"

namespace swept::step {

struct FineTriangles {
  TriMesh mesh;     ///< no two faces share vertices
  double accuracy;  ///< mm: how far the triangles may lie from the body
};

/// Makes them as accurate as a limit of their number allows. `size`: of the body, mm.
FineTriangles fineTriangles(const TopoDS_Shape& body, double size);

/// Returns triangles that lie within `distance` (mm) of the faces of a shape, or farther away where
/// a face would have more than a million of them. TriMesh::faceOf has the indices of the faces in
/// the shape, from 0.
TriMesh trianglesWithin(const TopoDS_Shape& shape, double distance);

}  // namespace swept::step
