// Triangles of the faces of a kernel shape.
// Units:   mm.
// Method:  the kernel's mesher makes them. It fails for some faces that go all the way round, such
//          as a cone whose border has vertices at different places of its two circles. If that
//          happens, all such faces of the shape are cut in two, and the mesher is called again.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "swept/types.h"

namespace swept::step {

/// A face, or a part of it, in which triangles are stored.
struct FaceWithTriangles {
  TopoDS_Face face;
  int number;  ///< of the face in the shape, from 0
};

class ShapeTriangles {
 public:
  /// Makes triangles that deviate from the faces by at most `deflection` (mm), with at most `angle`
  /// (rad) between adjacent triangles. They are stored in the shape, too.
  ShapeTriangles(const TopoDS_Shape& shape, double deflection, double angle);

  /// Returns the triangles of a part of the shape. TriMesh::faceOf has the indices of the faces in
  /// the whole shape, from 0. No two faces share vertices.
  TriMesh of(const TopoDS_Shape& part) const;

  std::vector<FaceWithTriangles> facesWithTriangles() const;

 private:
  TopTools_IndexedMapOfShape faces_;
  std::vector<TopoDS_Shape> meshed_;  // by face: the face, or the parts into which it was cut
};

}  // namespace swept::step
