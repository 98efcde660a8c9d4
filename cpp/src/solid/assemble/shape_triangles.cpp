// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/shape_triangles.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

namespace swept::step {
namespace {

void appendFace(const TopoDS_Face& face, std::int32_t number, TriMesh& mesh) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
  if (part.IsNull()) return;
  const gp_Trsf& transform = location.Transformation();
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  for (int i = 1; i <= part->NbNodes(); ++i) {
    const gp_Pnt p = part->Node(i).Transformed(transform);
    mesh.vertices.emplace_back(p.X(), p.Y(), p.Z());
  }
  const bool turned = face.Orientation() == TopAbs_REVERSED;
  for (int i = 1; i <= part->NbTriangles(); ++i) {
    int a = 0;
    int b = 0;
    int c = 0;
    part->Triangle(i).Get(a, b, c);
    if (turned) std::swap(b, c);
    mesh.triangles.push_back({first + a - 1, first + b - 1, first + c - 1});
    mesh.faceOf.push_back(number);
  }
}

}  // namespace

TriMesh meshOf(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces) {
  TriMesh mesh;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next())
    appendFace(TopoDS::Face(f.Current()), faces.FindIndex(f.Current()) - 1, mesh);
  return mesh;
}

TriMesh trianglesOf(const TopoDS_Shape& shape, double deflection, double angle) {
  const BRepMesh_IncrementalMesh mesher(shape, deflection, Standard_False, angle, Standard_True);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return meshOf(shape, faces);
}

}  // namespace swept::step
