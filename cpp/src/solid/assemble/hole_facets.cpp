// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/hole_facets.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/lines_on_faces.h"
#include "solid/assemble/solid_of_faces.h"
#include "solid/carrier/fit_spline.h"
#include "solid/mesh/flip_needles.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr double kOffPlane = 2e-6;   // mm: a curve nearer to the plane of a facet is in it
constexpr double kConeBound = 1e-8;  // mm: how far a cone may be off its curve
constexpr double kMinSags = 1.5;     // height of a facet, in sags of its curved side

Range rangeOf(const BRepAdaptor_Curve& curve) {
  return {curve.FirstParameter(), curve.LastParameter()};
}

}  // namespace

HoleFacets::HoleFacets(const std::vector<TopoDS_Face>& faces, const HoleTriangles& triangles)
    : faces_(faces), points_(triangles.points()) {
  for (std::size_t e = 0; e < triangles.open().size(); ++e) cutEdge(e, triangles);
  for (const TopoDS_Face& face : faces) cut_.push_back(withCutEdges(face));
  for (const std::int32_t t : triangles.inHoles()) {
    triangle_ = t;
    const Corners& corners = triangles.triangle(t);
    int curved = 0;
    for (int k = 0; k < 3; ++k)
      curved += isCurved({corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]});
    if (curved < 2) {
      appendFacet(corners);
      continue;
    }
    const auto centre = static_cast<std::int32_t>(points_.size());
    points_.push_back((points_[corners[0]] + points_[corners[1]] + points_[corners[2]]) / 3);
    for (int k = 0; k < 3; ++k) appendFacet({corners[k], corners[(k + 1) % 3], centre});
  }
}

std::vector<TopoDS_Face> HoleFacets::all() const {
  std::vector<TopoDS_Face> result = cut_;
  result.insert(result.end(), facets_.begin(), facets_.end());
  return result;
}

std::vector<TopoDS_Face> HoleFacets::joinedAll() const {
  std::vector<TopoDS_Face> result = cut_;
  const std::vector<TopoDS_Face> facets = facesIn(joined(compoundOf(facets_), false));
  result.insert(result.end(), facets.begin(), facets.end());
  return result;
}

void HoleFacets::cutEdge(std::size_t edge, const HoleTriangles& triangles) {
  const OpenEdge& open = triangles.open()[edge];
  const EdgePath& path = triangles.paths()[edge];
  const BRep_Builder builder;
  if (!BRep_Tool::SameRange(open.edge) || !BRep_Tool::SameParameter(open.edge))
    BRepLib::SameParameter(open.edge, Precision::Confusion());
  vertices_[path.vertices.front()] = TopExp::FirstVertex(open.edge);
  vertices_[path.vertices.back()] = TopExp::LastVertex(open.edge);
  const bool isPlane =
      BRepAdaptor_Surface(faces_[open.face], Standard_False).GetType() == GeomAbs_Plane;
  TopTools_ListOfShape parts;
  for (std::size_t i = 0; i + 1 < path.vertices.size(); ++i) {
    const std::int32_t from = path.vertices[i], to = path.vertices[i + 1];
    TopoDS_Edge part = open.edge;
    if (isPlane) {
      part = BRepBuilderAPI_MakeEdge(vertexOf(from), vertexOf(to)).Edge();
    } else if (path.vertices.size() > 2) {
      part = TopoDS::Edge(open.edge.EmptyCopied());
      builder.Add(part, vertexOf(from).Oriented(TopAbs_FORWARD));
      builder.Add(part, vertexOf(to).Oriented(TopAbs_REVERSED));
      builder.Range(part, path.params[i], path.params[i + 1]);
    }
    borders_[std::minmax(from, to)] = {part, from, {edge, path.params[i], path.params[i + 1]}};
    parts.Append(part);
  }
  parts_.Bind(open.edge, parts);
}

TopoDS_Face HoleFacets::withCutEdges(const TopoDS_Face& face) const {
  // A face without open edges keeps the triangles that are stored in it.
  bool isCut = false;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    isCut = isCut || parts_.IsBound(it.Current());
  if (!isCut) return face;
  const BRep_Builder builder;
  TopoDS_Face result = TopoDS::Face(face.EmptyCopied().Oriented(TopAbs_FORWARD));
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
    TopoDS_Wire cut;
    builder.MakeWire(cut);
    for (TopoDS_Iterator it(wire.Value().Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
      if (!parts_.IsBound(it.Value())) {
        builder.Add(cut, it.Value());
        continue;
      }
      for (const TopoDS_Shape& part : parts_(it.Value()))
        builder.Add(cut, part.Oriented(it.Value().Orientation()));
    }
    cut.Closed(Standard_True);
    builder.Add(result, cut.Oriented(wire.Value().Orientation()));
  }
  return TopoDS::Face(result.Oriented(face.Orientation()));
}

TopoDS_Vertex HoleFacets::vertexOf(std::int32_t v) {
  TopoDS_Vertex& vertex = vertices_[v];
  if (vertex.IsNull()) vertex = BRepBuilderAPI_MakeVertex(pointOf(points_[v])).Vertex();
  return vertex;
}

TopoDS_Edge HoleFacets::sideOf(std::int32_t a, std::int32_t b) {
  const Ends ends = std::minmax(a, b);
  const auto border = borders_.find(ends);
  if (border != borders_.end()) {
    const bool isForward = border->second.from == a;
    return TopoDS::Edge(border->second.edge.Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
  }
  TopoDS_Edge& edge = inner_[ends];
  if (edge.IsNull())
    edge = BRepBuilderAPI_MakeEdge(vertexOf(ends.first), vertexOf(ends.second)).Edge();
  return TopoDS::Edge(edge.Oriented(ends.first == a ? TopAbs_FORWARD : TopAbs_REVERSED));
}

bool HoleFacets::isCurved(const Corners& corners) const {
  constexpr int kParts = 8;
  const auto border = borders_.find(std::minmax(corners[0], corners[1]));
  if (border == borders_.end()) return false;
  const BRepAdaptor_Curve curve(border->second.edge);
  if (curve.GetType() == GeomAbs_Line) return false;
  const Range range = rangeOf(curve);
  const auto at = [&](int i) {
    return vectorOf(curve.Value(range.at(static_cast<double>(i) / kParts)).XYZ());
  };
  // The plane through the ends of the curve: the vertices may be less exact.
  const Vector3d p = at(0);
  const Vector3d normal = (at(kParts) - p).cross(points_[corners[2]] - p).normalized();
  for (int i = 1; i < kParts; ++i) {
    if (std::abs((at(i) - p).dot(normal)) > kOffPlane) return true;
  }
  return false;
}

void HoleFacets::appendFacet(Corners corners) {
  const BRep_Builder builder;
  for (int k = 0; k < 3 && !isCurved(corners); ++k)
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  std::array<TopoDS_Edge, 3> sides;
  for (int k = 0; k < 3; ++k) sides[k] = sideOf(corners[k], corners[(k + 1) % 3]);
  const Vector3d &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]];
  TopoDS_Face face;
  if (isCurved(corners)) {
    const Handle(Geom_Surface) cone = coneOver(sides[0], c);
    if (cone.IsNull()) {
      failed_.insert(borders_.at(std::minmax(corners[0], corners[1])).side);
      return;
    }
    face = coneFace(cone, sides, vertexOf(corners[2]));
  } else {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Edge& side : sides) builder.Add(wire, side);
    wire.Closed(Standard_True);
    const gp_Pln plane(pointOf(a), dirOf((b - a).cross(c - a)));
    builder.MakeFace(face, new Geom_Plane(plane), Precision::Confusion());
    builder.Add(face, wire);
  }
  for (const TopoDS_Edge& side : sides) coverCurve(side, face);
  facets_.push_back(face);
  triangleOf_.push_back(triangle_);
}

Handle(Geom_Surface) HoleFacets::coneOver(const TopoDS_Edge& edge, const Vector3d& apex) const {
  const BRepAdaptor_Curve curve(edge);
  const Range range = rangeOf(curve);
  const auto at = [&](double t) { return vectorOf(curve.Value(t).XYZ()); };
  const Vector3d from = at(range.from), to = at(range.to);
  const Vector3d chord = (to - from).normalized(), middle = at(range.at(0.5)) - from;
  const double sag = (middle - middle.dot(chord) * chord).norm();
  if (heightOf(from, to, apex) < kMinSags * sag) return {};
  const auto base = fitSpline(at, range, kConeBound);
  if (!base) return {};
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(kernelCurve(*base));
  TColgp_Array2OfPnt poles(1, spline->NbPoles(), 1, 2);
  for (int i = 1; i <= spline->NbPoles(); ++i) {
    poles(i, 1) = spline->Pole(i);
    poles(i, 2) = pointOf(apex);
  }
  TColStd_Array1OfReal ends(1, 2);
  TColStd_Array1OfInteger twice(1, 2);
  ends(1) = 0;
  ends(2) = 1;
  twice.Init(2);
  return new Geom_BSplineSurface(poles, spline->Knots(), ends, spline->Multiplicities(), twice,
                                 spline->Degree(), 1);
}

TopoDS_Face HoleFacets::coneFace(const Handle(Geom_Surface) & cone,
                                 const std::array<TopoDS_Edge, 3>& sides,
                                 const TopoDS_Vertex& apex) const {
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, cone, Precision::Confusion());
  const auto setLine = [&](const TopoDS_Edge& edge, const gp_Pnt2d& from, const gp_Pnt2d& to) {
    double first, last;
    BRep_Tool::Range(edge, first, last);
    builder.UpdateEdge(edge, lineOn(from, to, first, last), face, Precision::Confusion());
  };
  double u0, u1, v0, v1;
  cone->Bounds(u0, u1, v0, v1);
  const bool isForward = sides[0].Orientation() == TopAbs_FORWARD;
  setLine(sides[0], {u0, 0}, {u1, 0});
  // The second side runs to the apex, the third one back, unless their edges are reversed.
  const double second = isForward ? u1 : u0, third = isForward ? u0 : u1;
  const bool isUp = sides[1].Orientation() == TopAbs_FORWARD;
  setLine(sides[1], {second, isUp ? 0.0 : 1.0}, {second, isUp ? 1.0 : 0.0});
  const bool isDown = sides[2].Orientation() == TopAbs_FORWARD;
  setLine(sides[2], {third, isDown ? 1.0 : 0.0}, {third, isDown ? 0.0 : 1.0});
  const TopoDS_Edge point = degeneratedEdge(apex, {u0, 1}, {u1, 1}, face);
  // The normal of the surface points inward if the curved side is reversed.
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const auto add = [&](const TopoDS_Edge& edge) {
    builder.Add(wire, isForward ? edge : TopoDS::Edge(edge.Reversed()));
  };
  add(sides[0]);
  add(isForward ? sides[1] : sides[2]);
  builder.Add(wire, point.Oriented(TopAbs_REVERSED));
  add(isForward ? sides[2] : sides[1]);
  wire.Closed(Standard_True);
  builder.Add(face, wire);
  return TopoDS::Face(face.Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
}

}  // namespace swept::step
