// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/lines_on_faces.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <algorithm>

namespace swept::step {

Handle(Geom2d_Curve) lineOn(const gp_Pnt2d& from, const gp_Pnt2d& to, double first, double last) {
  TColgp_Array1OfPnt2d poles(1, 2);
  TColStd_Array1OfReal knots(1, 2);
  TColStd_Array1OfInteger twice(1, 2);
  poles(1) = from;
  poles(2) = to;
  knots(1) = first;
  knots(2) = last;
  twice.Init(2);
  return new Geom2d_BSplineCurve(poles, knots, twice, 1);
}

TopoDS_Edge degeneratedEdge(const TopoDS_Vertex& vertex, const gp_Pnt2d& from, const gp_Pnt2d& to,
                            const TopoDS_Face& face) {
  const BRep_Builder builder;
  TopoDS_Edge point;
  builder.MakeEdge(point);
  builder.Degenerated(point, Standard_True);
  builder.Add(point, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(point, vertex.Oriented(TopAbs_REVERSED));
  const double length = from.Distance(to);
  builder.UpdateEdge(point, lineOn(from, to, 0, length), face, Precision::Confusion());
  builder.Range(point, 0, length);
  return point;
}

void coverCurve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kPoints = 23;  // as a reader of the file does
  constexpr double kCover = 1.05;
  double first, last;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(surface);
  Handle(Geom2d_Curve) on;
  if (plane.IsNull()) on = BRep_Tool::CurveOnSurface(edge, face, first, last);
  double off = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double t = first + (last - first) * i / (kPoints - 1);
    const gp_Pnt p = curve->Value(t);
    if (on.IsNull()) {
      off = std::max(off, plane->Pln().Distance(p));
      continue;
    }
    const gp_Pnt2d at = on->Value(t);
    off = std::max(off, surface->Value(at.X(), at.Y()).Distance(p));
  }
  if (kCover * off < BRep_Tool::Tolerance(edge)) return;
  const BRep_Builder builder;
  builder.UpdateEdge(edge, kCover * off);
  for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
    builder.UpdateVertex(vertex, kCover * off);
}

}  // namespace swept::step
