// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/elementary_body.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <utility>

#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

TopoDS_Shape withoutClosedFaces(const TopoDS_Shape& body) {
  ShapeUpgrade_ShapeDivideClosed divider(body);
  divider.SetNbSplitPoints(1);
  return divider.Perform() ? divider.Result() : body;
}

BodySurface surfaceOfFace(const TopoDS_Face& face) {
  const BRepAdaptor_Surface adaptor(face, Standard_False);
  BodySurface surface;
  surface.isPlane = adaptor.GetType() == GeomAbs_Plane;
  const gp_Ax3 axes = surface.isPlane ? adaptor.Plane().Position() : adaptor.Cylinder().Position();
  surface.origin = vectorOf(axes.Location().XYZ());
  surface.x = vectorOf(axes.XDirection().XYZ());
  surface.y = vectorOf(axes.YDirection().XYZ());
  surface.axis = vectorOf(axes.Direction().XYZ());
  if (!surface.isPlane) surface.radius = adaptor.Cylinder().Radius();
  const bool isReversed = (face.Orientation() == TopAbs_REVERSED) == bool(axes.Direct());
  surface.outward = isReversed ? -1 : 1;
  return surface;
}

}  // namespace

Vector3d BodyEdge::at(double u) const { return vectorOf(curve->Value(u).XYZ()); }

Vector3d BodyEdge::tangent(double u) const { return vectorOf(curve->DN(u, 1).XYZ()).normalized(); }

Vector3d BodySurface::normalAt(const Vector3d& p) const {
  if (isPlane) return outward * axis;
  const Vector3d off = p - origin;
  return outward * (off - off.dot(axis) * axis).normalized();
}

double BodySurface::distanceTo(const Vector3d& p) const {
  const Vector3d off = p - origin;
  return isPlane ? off.dot(axis) : off.cross(axis).norm() - radius;
}

Vector2d BodySurface::parametersOf(const Vector3d& p, double angle) const {
  const Vector3d off = p - origin;
  if (isPlane) return {off.dot(x), off.dot(y)};
  const double found = std::atan2(off.dot(y), off.dot(x));
  return {found + 2 * M_PI * std::round((angle - found) / (2 * M_PI)), off.dot(axis)};
}

Vector3d BodySurface::footOfOrigin() const {
  const Vector3d alongAxis = origin.dot(axis) * axis;
  return isPlane ? alongAxis : Vector3d(origin - alongAxis);
}

bool BodySurface::isAtPlaceOf(const BodySurface& other, double distance) const {
  constexpr double kSameDirection = 1e-9;
  if (isPlane != other.isPlane || std::abs(radius - other.radius) > distance) return false;
  if (axis.cross(other.axis).norm() > kSameDirection) return false;
  const Vector3d off = other.origin - origin;
  return (isPlane ? std::abs(off.dot(axis)) : off.cross(axis).norm()) < distance;
}

bool BodySurface::isSame(const BodySurface& other) const {
  constexpr double kSame = 1e-9;  // mm
  const bool isSameSide =
      isPlane ? (outward * axis).dot(other.outward * other.axis) > 0 : outward == other.outward;
  return isSameSide && isAtPlaceOf(other, kSame);
}

bool isElementary(const TopoDS_Shape& body) {
  for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) {
    const auto type = BRepAdaptor_Surface(TopoDS::Face(face.Current()), Standard_False).GetType();
    if (type != GeomAbs_Plane && type != GeomAbs_Cylinder) return false;
  }
  for (TopExp_Explorer edge(body, TopAbs_EDGE); edge.More(); edge.Next()) {
    const auto type = BRepAdaptor_Curve(TopoDS::Edge(edge.Current())).GetType();
    if (type != GeomAbs_Line && type != GeomAbs_Circle) return false;
  }
  return true;
}

ElementaryBody::ElementaryBody(const TopoDS_Shape& body) : shape(withoutClosedFaces(body)) {
  TopTools_IndexedMapOfShape faceMap;
  TopTools_IndexedDataMapOfShapeListOfShape edgeMap;
  TopExp::MapShapes(shape, TopAbs_FACE, faceMap);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edgeMap);
  for (int f = 1; f <= faceMap.Extent(); ++f) {
    BodyFace& face = faces.emplace_back();
    face.shape = TopoDS::Face(faceMap(f));
    const BodySurface surface = surfaceOfFace(face.shape);
    const auto same = std::find_if(surfaces.begin(), surfaces.end(),
                                   [&](const BodySurface& other) { return surface.isSame(other); });
    face.surface = static_cast<int>(same - surfaces.begin());
    if (same == surfaces.end()) surfaces.push_back(surface);
  }
  for (int e = 1; e <= edgeMap.Extent(); ++e) {
    BodyEdge& edge = edges.emplace_back();
    edge.shape = TopoDS::Edge(edgeMap.FindKey(e).Oriented(TopAbs_FORWARD));
    edge.from = vertices.FindIndex(TopExp::FirstVertex(edge.shape)) - 1;
    edge.to = vertices.FindIndex(TopExp::LastVertex(edge.shape)) - 1;
    edge.curve = BRep_Tool::Curve(edge.shape, edge.range.from, edge.range.to);
    edge.isStraight = BRepAdaptor_Curve(edge.shape).GetType() == GeomAbs_Line;
    edge.scale = edge.curve->DN(edge.range.from, 1).Magnitude();
    std::size_t side = 0;
    for (const TopoDS_Shape& owner : edgeMap(e)) {
      const int f = faceMap.FindIndex(owner) - 1;
      if (side < edge.faces.size()) edge.faces[side++] = f;
      faces[f].edges.push_back(e - 1);
    }
  }
}

Vector3d ElementaryBody::point(int vertex) const {
  return vectorOf(BRep_Tool::Pnt(TopoDS::Vertex(vertices(vertex + 1))).XYZ());
}

Vector3d ElementaryBody::intoFace(const BodyEdge& edge, int f, double u) const {
  for (TopExp_Explorer it(faces[f].shape, TopAbs_EDGE); it.More(); it.Next()) {
    if (!it.Current().IsSame(edge.shape)) continue;
    const double sign = it.Current().Orientation() == TopAbs_REVERSED ? -1 : 1;
    return surfaceOf(f).normalAt(edge.at(u)).cross(sign * edge.tangent(u));
  }
  return Vector3d::Zero();
}

double ElementaryBody::convexity(const BodyEdge& edge) const {
  const double middle = edge.range.at(0.5);
  const Vector3d normal = surfaceOf(edge.faces[0]).normalAt(edge.at(middle));
  return -intoFace(edge, edge.faces[1], middle).dot(normal);
}

Range ElementaryBody::anglesOf(int f) const {
  double v0, v1;
  Range angles;
  BRepTools::UVBounds(faces[f].shape, angles.from, angles.to, v0, v1);
  return angles;
}

bool ElementaryBody::isCorner(int vertex, int f) const {
  constexpr double kStraight = 1e-6;
  // Of the edges of the face at the vertex: the directions away from it, and into the face.
  std::vector<std::pair<Vector3d, Vector3d>> sides;
  for (const int e : faces[f].edges) {
    const BodyEdge& edge = edges[e];
    if (edge.from == vertex)
      sides.emplace_back(edge.tangent(edge.range.from), intoFace(edge, f, edge.range.from));
    if (edge.to == vertex)
      sides.emplace_back(-edge.tangent(edge.range.to), intoFace(edge, f, edge.range.to));
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (sides[i].first.dot(sides[j].second) > kStraight) return true;
    }
  }
  return false;
}

bool ElementaryBody::isConvex(const BodyEdge& edge) const {
  constexpr double kFlat = 1e-6;
  return convexity(edge) > kFlat;
}

PosedBody::PosedBody(const TopoDS_Shape& body, const Pose& pose)
    : maker_(std::make_unique<BRepBuilderAPI_Transform>(body, transformOf(pose), Standard_True)) {}

}  // namespace swept::step
