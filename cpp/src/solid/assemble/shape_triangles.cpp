// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/shape_triangles.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>

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

bool hasTriangles(const TopoDS_Shape& face) {
  TopLoc_Location location;
  return !BRep_Tool::Triangulation(TopoDS::Face(face), location).IsNull();
}

void mesh(const TopoDS_Shape& shape, double deflection, double angle) {
  const BRepMesh_IncrementalMesh mesher(shape, deflection, Standard_False, angle, Standard_True);
}

}  // namespace

ShapeTriangles::ShapeTriangles(const TopoDS_Shape& shape, double deflection, double angle) {
  mesh(shape, deflection, angle);
  TopExp::MapShapes(shape, TopAbs_FACE, faces_);
  for (int f = 1; f <= faces_.Extent(); ++f) meshed_.push_back(faces_(f));
  if (std::all_of(meshed_.begin(), meshed_.end(), hasTriangles)) return;
  ShapeUpgrade_ShapeDivideClosed divider(shape);
  if (!divider.Perform()) return;
  const TopoDS_Shape divided = divider.Result();
  BRepTools::Clean(divided);
  mesh(divided, deflection, angle);
  for (TopoDS_Shape& face : meshed_) face = divider.GetContext()->Apply(face);
}

std::vector<FaceWithTriangles> ShapeTriangles::facesWithTriangles() const {
  std::vector<FaceWithTriangles> faces;
  for (std::size_t f = 0; f < meshed_.size(); ++f) {
    for (TopExp_Explorer it(meshed_[f], TopAbs_FACE); it.More(); it.Next())
      faces.push_back({TopoDS::Face(it.Current()), static_cast<int>(f)});
  }
  return faces;
}

TriMesh ShapeTriangles::of(const TopoDS_Shape& part) const {
  TriMesh result;
  for (TopExp_Explorer f(part, TopAbs_FACE); f.More(); f.Next()) {
    const int number = faces_.FindIndex(f.Current()) - 1;
    const bool isTurned = f.Current().Orientation() != faces_(number + 1).Orientation();
    for (TopExp_Explorer it(meshed_[number], TopAbs_FACE); it.More(); it.Next()) {
      const TopoDS_Shape face = isTurned ? it.Current().Reversed() : it.Current();
      appendFace(TopoDS::Face(face), number, result);
    }
  }
  return result;
}

}  // namespace swept::step
