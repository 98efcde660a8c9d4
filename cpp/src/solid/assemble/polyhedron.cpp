// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/polyhedron.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <gp_Pln.hxx>

#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector3d;

bool isPolyhedron(const TopoDS_Shape& body) {
  for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) {
    if (BRepAdaptor_Surface(TopoDS::Face(face.Current()), Standard_False).GetType() !=
        GeomAbs_Plane)
      return false;
  }
  for (TopExp_Explorer edge(body, TopAbs_EDGE); edge.More(); edge.Next()) {
    if (BRepAdaptor_Curve(TopoDS::Edge(edge.Current())).GetType() != GeomAbs_Line) return false;
  }
  return true;
}

Polyhedron::Polyhedron(const TopoDS_Shape& body) {
  TopTools_IndexedMapOfShape faceMap;
  TopTools_IndexedDataMapOfShapeListOfShape edgeMap;
  TopExp::MapShapes(body, TopAbs_FACE, faceMap);
  TopExp::MapShapes(body, TopAbs_VERTEX, vertices);
  TopExp::MapShapesAndAncestors(body, TopAbs_EDGE, TopAbs_FACE, edgeMap);
  for (int f = 1; f <= faceMap.Extent(); ++f) {
    BodyFace& face = faces.emplace_back();
    face.shape = TopoDS::Face(faceMap(f));
    const gp_Pln plane = BRepAdaptor_Surface(face.shape).Plane();
    const bool isReversed = (face.shape.Orientation() == TopAbs_REVERSED) == plane.Direct();
    face.normal = (isReversed ? -1 : 1) * vectorOf(plane.Axis().Direction().XYZ());
  }
  for (int e = 1; e <= edgeMap.Extent(); ++e) {
    BodyEdge& edge = edges.emplace_back();
    edge.shape = TopoDS::Edge(edgeMap.FindKey(e).Oriented(TopAbs_FORWARD));
    edge.from = vertices.FindIndex(TopExp::FirstVertex(edge.shape)) - 1;
    edge.to = vertices.FindIndex(TopExp::LastVertex(edge.shape)) - 1;
    edge.start = point(edge.from);
    const Vector3d step = point(edge.to) - edge.start;
    edge.length = step.norm();
    edge.along = step / edge.length;
    std::size_t side = 0;
    for (const TopoDS_Shape& owner : edgeMap(e)) {
      const int f = faceMap.FindIndex(owner) - 1;
      if (side < edge.faces.size()) edge.faces[side++] = f;
      faces[f].edges.push_back(e - 1);
    }
  }
}

Vector3d Polyhedron::point(int vertex) const {
  return vectorOf(BRep_Tool::Pnt(TopoDS::Vertex(vertices(vertex + 1))).XYZ());
}

bool Polyhedron::isConvex(const BodyEdge& edge) const {
  const BodyFace &a = faces[edge.faces[0]], &b = faces[edge.faces[1]];
  for (TopExp_Explorer it(b.shape, TopAbs_EDGE); it.More(); it.Next()) {
    if (!it.Current().IsSame(edge.shape)) continue;
    const double sign = it.Current().Orientation() == TopAbs_REVERSED ? -1 : 1;
    const Vector3d intoFace = b.normal.cross(sign * edge.along);
    constexpr double kFlat = 1e-9;
    return intoFace.dot(a.normal) < -kFlat;
  }
  return false;
}

PosedBody::PosedBody(const TopoDS_Shape& body, const Pose& pose)
    : maker_(std::make_unique<BRepBuilderAPI_Transform>(body, transformOf(pose), Standard_True)) {}

}  // namespace swept::step
