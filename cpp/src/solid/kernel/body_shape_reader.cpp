// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/body_shape_reader.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "base/sort_unique.h"
#include "solid/carrier/traces.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

Vector3d pointOf(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
Vector3d vectorOf(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }
Vector3d vectorOf(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }

void setFrame(const gp_Ax3& axes, Carrier& carrier) {
  carrier.point = pointOf(axes.Location());
  carrier.axis = vectorOf(axes.Direction());
  carrier.xdir = vectorOf(axes.XDirection());
}

Carrier carrierOf(const BRepAdaptor_Surface& surface) {
  Carrier carrier;
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      carrier.kind = CarrierKind::Plane;
      setFrame(surface.Plane().Position(), carrier);
      break;
    case GeomAbs_Cylinder:
      carrier.kind = CarrierKind::Cylinder;
      setFrame(surface.Cylinder().Position(), carrier);
      carrier.radius = surface.Cylinder().Radius();
      break;
    case GeomAbs_Cone:
      carrier.kind = CarrierKind::Cone;
      setFrame(surface.Cone().Position(), carrier);
      carrier.radius = surface.Cone().RefRadius();
      carrier.setHalfAngle(surface.Cone().SemiAngle());
      break;
    case GeomAbs_Sphere:
      carrier.kind = CarrierKind::Sphere;
      setFrame(surface.Sphere().Position(), carrier);
      carrier.radius = surface.Sphere().Radius();
      break;
    case GeomAbs_Torus:
      carrier.kind = CarrierKind::Torus;
      setFrame(surface.Torus().Position(), carrier);
      carrier.radius = surface.Torus().MajorRadius();
      carrier.minor = surface.Torus().MinorRadius();
      break;
    default:
      break;
  }
  return carrier;
}

std::vector<double> breaksOf(const BRepAdaptor_Curve& curve, double from, double to) {
  const int count = curve.NbIntervals(GeomAbs_C2);
  TColStd_Array1OfReal knots(1, count + 1);
  curve.Intervals(knots, GeomAbs_C2);
  std::vector<double> breaks{from};
  for (int i = 1; i <= count + 1; ++i) {
    if (knots(i) > from && knots(i) < to) breaks.push_back(knots(i));
  }
  breaks.push_back(to);
  return breaks;
}

Curve generalCurve(const BRepAdaptor_Curve& curve, double from, double to) {
  const auto exact = [&](double t) {
    gp_Pnt at;
    gp_Vec slope;
    curve.D1(t, at, slope);
    return CurvePoint{pointOf(at), vectorOf(slope)};
  };
  // Many files contain lines and circles as splines.
  constexpr int kSamples = 32;
  std::vector<Vector3d> points;
  for (int i = 0; i <= kSamples; ++i) points.push_back(exact(from + (to - from) * i / kSamples).at);
  const bool closed = (points.front() - points.back()).norm() < kKernelTolerance;
  if (!closed) {
    const Curve line = lineThrough(points.front(), points.back());
    const bool straight = std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
      return (p - line.start).cross(line.axis).norm() < kKernelTolerance;
    });
    if (straight) return line;
  }
  if (const auto circle = circleThrough(points, closed, kKernelTolerance)) return *circle;
  return splineOf(exact, breaksOf(curve, from, to), kCurveError);
}

Curve curveOf(const BRepAdaptor_Curve& curve) {
  const double from = curve.FirstParameter(), to = curve.LastParameter();
  if (curve.GetType() == GeomAbs_Line)
    return lineThrough(pointOf(curve.Value(from)), pointOf(curve.Value(to)));
  if (curve.GetType() == GeomAbs_Circle) {
    const gp_Circ circle = curve.Circle();
    Curve result;
    result.kind = CurveKind::Circle;
    result.start = pointOf(circle.Location());
    result.axis = vectorOf(circle.Axis().Direction());
    result.radius = circle.Radius();
    result.xdir = (pointOf(curve.Value(from)) - result.start).normalized();
    result.last = std::min(to - from, 2 * M_PI);
    return result;
  }
  return generalCurve(curve, from, to);
}

}  // namespace

BodyShape shapeOf(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces) {
  BodyShape body;
  body.faces.resize(faces.Extent());
  for (int i = 1; i <= faces.Extent(); ++i)
    body.faces[i - 1].surface = carrierOf(BRepAdaptor_Surface(TopoDS::Face(faces(i))));
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    std::vector<std::int32_t> beside;
    for (const TopoDS_Shape& face : edges(i)) beside.push_back(faces.FindIndex(face) - 1);
    const bool isSeam = beside.size() == 2 && beside[0] == beside[1];
    sortUnique(beside);
    if (isSeam || beside.empty() || beside.front() < 0) continue;
    BodyEdge made;
    try {
      made.curve = curveOf(BRepAdaptor_Curve(edge));
    } catch (const Standard_Failure&) {
      continue;  // an edge without a curve in space
    }
    for (std::size_t k = 0; k < std::min<std::size_t>(2, beside.size()); ++k)
      made.faces[k] = beside[k];
    made.tolerance = BRep_Tool::Tolerance(edge);
    for (const std::int32_t face : beside)
      body.faces[face].edges.push_back(static_cast<std::int32_t>(body.edges.size()));
    body.edges.push_back(std::move(made));
  }
  return body;
}

}  // namespace swept::step
