// Triangles of the faces of a kernel shape.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "swept/types.h"

namespace swept::step {

/// Returns the triangles that the kernel has made before. TriMesh::faceOf has the indices of the
/// faces in `faces`, from 0. No two faces share vertices.
TriMesh meshOf(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces);

/// Makes and returns triangles that deviate from the faces by at most `deflection` (mm), with at
/// most `angle` (rad) between adjacent triangles.
TriMesh trianglesOf(const TopoDS_Shape& shape, double deflection, double angle);

}  // namespace swept::step
