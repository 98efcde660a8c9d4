// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/body_geometry.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <ShapeUpgrade_ShapeDivideClosedEdges.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <utility>

#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Returns the line of constant parameter of a surface along which a curve in its parameters runs,
// with the parameter of this curve. Null if it does not run along one, or not at the same speed.
Handle(Geom_Curve)
    isoAlong(const Handle(Geom_Surface) & surface, const Geom2d_Curve& on, Range range) {
  constexpr double kSame = 1e-12;
  const gp_Pnt2d from = on.Value(range.from), middle = on.Value(range.at(0.5)),
                 to = on.Value(range.to);
  for (const bool isU : {true, false}) {
    const auto fixed = [&](const gp_Pnt2d& p) { return isU ? p.X() : p.Y(); };
    const auto running = [&](const gp_Pnt2d& p) { return isU ? p.Y() : p.X(); };
    const double shift = running(from) - range.from;
    const bool isAlong = std::abs(fixed(middle) - fixed(from)) < kSame &&
                         std::abs(fixed(to) - fixed(from)) < kSame &&
                         std::abs(running(middle) - range.at(0.5) - shift) < kSame &&
                         std::abs(running(to) - range.to - shift) < kSame;
    if (!isAlong) continue;
    Handle(Geom_Curve) iso = isU ? surface->UIso(fixed(from)) : surface->VIso(fixed(from));
    if (const auto part = Handle(Geom_TrimmedCurve)::DownCast(iso)) iso = part->BasisCurve();
    if (const auto circle = Handle(Geom_Circle)::DownCast(iso)) {
      circle->Rotate(circle->Circ().Axis(), shift);
      return iso;
    }
    if (const auto line = Handle(Geom_Line)::DownCast(iso)) {
      line->Translate(shift * gp_Vec(line->Lin().Direction()));
      return iso;
    }
  }
  return {};
}

// The kernel only approximates the curves in which it divides closed faces, with errors of 5e-6 mm.
// Gives these edges their exact curves.
void makeDividingEdgesExact(const TopoDS_Shape& body) {
  constexpr double kNear = 1e-4;  // mm
  for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) {
    Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(face.Current()));
    if (const auto part = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
      surface = part->BasisSurface();
    if (!surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface))) continue;
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      Range range;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
      if (Handle(Geom_BSplineCurve)::DownCast(curve).IsNull()) continue;
      double from, to;
      const Handle(Geom2d_Curve) on =
          BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Current()), from, to);
      if (on.IsNull()) continue;
      const Handle(Geom_Curve) exact = isoAlong(surface, *on, range);
      const double middle = range.at(0.5);
      if (exact.IsNull() || exact->Value(middle).Distance(curve->Value(middle)) > kNear) continue;
      BRep_Builder().UpdateEdge(edge, exact, Precision::Confusion());
      ShapeFix_ShapeTolerance().SetTolerance(edge, Precision::Confusion(), TopAbs_EDGE);
    }
  }
}

// Returns the body with closed faces and edges divided. The kernel marks some of the new edges as
// having other parameters on their faces than in space, so that these faces count as invalid.
// SameParameter() corrects this.
TopoDS_Shape withoutClosedParts(const TopoDS_Shape& body) {
  ShapeUpgrade_ShapeDivideClosed faces(body);
  faces.SetNbSplitPoints(1);
  const TopoDS_Shape open = faces.Perform() ? faces.Result() : body;
  ShapeUpgrade_ShapeDivideClosedEdges edges(open);
  edges.SetNbSplitPoints(1);
  const TopoDS_Shape divided = edges.Perform() ? edges.Result() : open;
  makeDividingEdgesExact(divided);
  BRepLib::SameParameter(divided, Precision::Confusion());
  return divided;
}

Eigen::AlignedBox2d parameterRange(const TopoDS_Face& face) {
  Vector2d low, high;
  BRepTools::UVBounds(face, low.x(), high.x(), low.y(), high.y());
  return {low, high};
}

BodySurface surfaceOfFace(const TopoDS_Face& face) {
  using Kind = BodySurface::Kind;
  const BRepAdaptor_Surface adaptor(face, Standard_False);
  BodySurface surface;
  gp_Ax3 axes;
  switch (adaptor.GetType()) {
    case GeomAbs_Plane:
      axes = adaptor.Plane().Position();
      break;
    case GeomAbs_Cylinder:
      surface.kind = Kind::Cylinder;
      axes = adaptor.Cylinder().Position();
      surface.radius = adaptor.Cylinder().Radius();
      break;
    case GeomAbs_Cone:
      surface.kind = Kind::Cone;
      axes = adaptor.Cone().Position();
      surface.radius = adaptor.Cone().RefRadius();
      surface.slope = adaptor.Cone().SemiAngle();
      break;
    case GeomAbs_Sphere:
      surface.kind = Kind::Torus;
      axes = adaptor.Sphere().Position();
      surface.tube = adaptor.Sphere().Radius();
      break;
    case GeomAbs_Torus:
      surface.kind = Kind::Torus;
      axes = adaptor.Torus().Position();
      surface.radius = adaptor.Torus().MajorRadius();
      surface.tube = adaptor.Torus().MinorRadius();
      break;
    default:
      surface.kind = Kind::Other;
      surface.shape = BRep_Tool::Surface(face);
      surface.outward = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
      return surface;
  }
  surface.origin = vectorOf(axes.Location().XYZ());
  surface.x = vectorOf(axes.XDirection().XYZ());
  surface.y = vectorOf(axes.YDirection().XYZ());
  surface.axis = vectorOf(axes.Direction().XYZ());
  const bool isReversed = (face.Orientation() == TopAbs_REVERSED) == bool(axes.Direct());
  surface.outward = isReversed ? -1 : 1;
  return surface;
}

}  // namespace

double angleNear(double other, double angle) {
  return angle + 2 * M_PI * std::round((other - angle) / (2 * M_PI));
}

Vector3d BodyEdge::at(double u) const { return vectorOf(curve->Value(u).XYZ()); }

Vector3d BodyEdge::tangent(double u) const {
  gp_Pnt p;
  gp_Vec along;
  curve->D1(u, p, along);
  return vectorOf(along.XYZ()).normalized();
}

Vector3d BodySurface::awayFromAxis(const Vector3d& p) const {
  const Vector3d off = p - origin;
  return (off - off.dot(axis) * axis).normalized();
}

Vector3d BodySurface::normalAt(const Vector3d& p) const {
  switch (kind) {
    case Kind::Plane:
      return outward * axis;
    case Kind::Cone:
      return outward * (std::cos(slope) * awayFromAxis(p) - std::sin(slope) * axis);
    case Kind::Torus:
      return outward * (p - origin - radius * awayFromAxis(p)).normalized();
    default:
      return outward * awayFromAxis(p);
  }
}

double BodySurface::distanceTo(const Vector3d& p) const {
  const Vector3d off = p - origin;
  const double along = off.dot(axis), fromAxis = off.cross(axis).norm();
  switch (kind) {
    case Kind::Plane:
      return along;
    case Kind::Cone:
      return (fromAxis - radius) * std::cos(slope) - along * std::sin(slope);
    case Kind::Torus:
      return std::hypot(fromAxis - radius, along) - tube;
    default:
      return fromAxis - radius;
  }
}

Vector2d BodySurface::parametersOf(const Vector3d& p, const Vector2d& near) const {
  const Vector3d off = p - origin;
  if (isPlane()) return {off.dot(x), off.dot(y)};
  const double around = angleNear(near.x(), std::atan2(off.dot(y), off.dot(x)));
  const double along = off.dot(axis);
  if (kind != Kind::Torus) return {around, along / std::cos(slope)};
  const Vector3d away = std::cos(around) * x + std::sin(around) * y;
  return {around, angleNear(near.y(), std::atan2(along, off.dot(away) - radius))};
}

Vector3d BodySurface::footOfOrigin() const {
  const Vector3d alongAxis = origin.dot(axis) * axis;
  return isPlane() ? alongAxis : Vector3d(origin - alongAxis);
}

bool BodySurface::isAtPlaceOf(const BodySurface& other, double distance) const {
  constexpr double kSameDirection = 1e-9;
  if (kind != other.kind || shape != other.shape) return false;
  if (std::abs(radius - other.radius) > distance || std::abs(tube - other.tube) > distance)
    return false;
  const Vector3d off = other.origin - origin;
  const bool isParallel = axis.cross(other.axis).norm() < kSameDirection;
  switch (kind) {
    case Kind::Plane:
      return isParallel && std::abs(off.dot(axis)) < distance;
    case Kind::Cylinder:
      return isParallel && off.cross(axis).norm() < distance;
    case Kind::Cone:
      return (axis - other.axis).norm() < kSameDirection && off.norm() < distance &&
             std::abs(slope - other.slope) < kSameDirection;
    case Kind::Torus:
      return isParallel && off.norm() < distance;
    default:
      return true;
  }
}

bool BodySurface::isSame(const BodySurface& other) const {
  constexpr double kSame = 1e-9;  // mm
  const bool isSameSide =
      isPlane() ? (outward * axis).dot(other.outward * other.axis) > 0 : outward == other.outward;
  return isSameSide && isAtPlaceOf(other, kSame);
}

BodyGeometry::BodyGeometry(const TopoDS_Shape& body) : shape(withoutClosedParts(body)) {
  TopTools_IndexedMapOfShape faceMap;
  TopTools_IndexedDataMapOfShapeListOfShape edgeMap;
  TopExp::MapShapes(shape, TopAbs_FACE, faceMap);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edgeMap);
  for (int f = 1; f <= faceMap.Extent(); ++f) {
    BodyFace& face = faces.emplace_back();
    face.shape = TopoDS::Face(faceMap(f));
    const BodySurface surface = face.own = surfaceOfFace(face.shape);
    constexpr double kOnBorder = 1e-6;  // of the parameters
    face.range = parameterRange(face.shape);
    face.border = std::make_shared<BRepTopAdaptor_FClass2d>(face.shape, kOnBorder);
    const auto same = std::find_if(surfaces.begin(), surfaces.end(),
                                   [&](const BodySurface& other) { return surface.isSame(other); });
    face.surface = static_cast<int>(same - surfaces.begin());
    if (same == surfaces.end()) surfaces.push_back(surface);
  }
  for (int e = 1; e <= edgeMap.Extent(); ++e) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(edgeMap.FindKey(e)))) continue;
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
      if (side < edge.faces.size()) {
        double from, to;
        if (surfaceOf(f).kind == BodySurface::Kind::Other)
          edge.onFaces[side] = BRep_Tool::CurveOnSurface(edge.shape, faces[f].shape, from, to);
        edge.faces[side++] = f;
      }
      faces[f].edges.push_back(static_cast<int>(edges.size()) - 1);
    }
  }
}

Vector3d BodyGeometry::point(int vertex) const {
  return vectorOf(BRep_Tool::Pnt(TopoDS::Vertex(vertices(vertex + 1))).XYZ());
}

Vector3d BodyGeometry::normalAt(const BodyEdge& edge, int f, double u) const {
  const BodySurface& surface = surfaceOf(f);
  if (surface.kind != BodySurface::Kind::Other) return surface.normalAt(edge.at(u));
  const Handle(Geom2d_Curve)& on = edge.onFaces[f == edge.faces[0] ? 0 : 1];
  if (on.IsNull()) return Vector3d::Zero();
  const gp_Pnt2d q = on->Value(u);
  gp_Pnt p;
  gp_Vec alongU, alongV;
  surface.shape->D1(q.X(), q.Y(), p, alongU, alongV);
  const Vector3d normal = vectorOf(alongU.Crossed(alongV).XYZ());
  return surface.outward * normal.normalized();
}

Vector3d BodyGeometry::intoFace(const BodyEdge& edge, int f, double u) const {
  for (TopExp_Explorer it(faces[f].shape, TopAbs_EDGE); it.More(); it.Next()) {
    if (!it.Current().IsSame(edge.shape)) continue;
    const double sign = it.Current().Orientation() == TopAbs_REVERSED ? -1 : 1;
    return normalAt(edge, f, u).cross(sign * edge.tangent(u));
  }
  return Vector3d::Zero();
}

double BodyGeometry::convexity(const BodyEdge& edge) const {
  const double middle = edge.range.at(0.5);
  const Vector3d normal = normalAt(edge, edge.faces[0], middle);
  return -intoFace(edge, edge.faces[1], middle).dot(normal);
}

Range BodyGeometry::anglesOf(int f) const {
  return {faces[f].range.min().x(), faces[f].range.max().x()};
}

Range BodyGeometry::extentOf(int surface, const Vector3d& origin, const Vector3d& along) const {
  constexpr int kPoints = 32;
  Range extent{HUGE_VAL, -HUGE_VAL};
  for (const BodyFace& face : faces) {
    if (face.surface != surface) continue;
    for (const int e : face.edges) {
      for (int i = 0; i <= kPoints; ++i) {
        const double u = edges[e].range.at(static_cast<double>(i) / kPoints);
        extent = extent.with((edges[e].at(u) - origin).dot(along));
      }
    }
  }
  return extent;
}

TopAbs_State BodyGeometry::placeOf(int f, const Vector3d& p) const {
  const Vector2d on = surfaceOf(f).parametersOf(p, faces[f].range.center());
  return faces[f].border->Perform(gp_Pnt2d(on.x(), on.y()));
}

bool BodyGeometry::isCorner(int vertex, int f) const {
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

bool BodyGeometry::isConvex(const BodyEdge& edge) const {
  constexpr double kFlat = 1e-6;
  return convexity(edge) > kFlat;
}

PosedBody::PosedBody(const TopoDS_Shape& body, const Pose& pose)
    : maker_(std::make_unique<BRepBuilderAPI_Transform>(body, transformOf(pose), Standard_True)) {}

}  // namespace swept::step
