// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/shorten_curves.h"

#include <BRep_GCurve.hxx>
#include <BRep_TEdge.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace swept::step {
namespace {

// Returns the part of a spline; null if the curve is no spline, or has no more than this part.
template <class Spline, class Curve>
Handle(Spline) partOf(const Handle(Curve) & curve, double from, double to) {
  const auto spline = Handle(Spline)::DownCast(curve);
  if (spline.IsNull() || spline->IsPeriodic()) return {};
  const double first = spline->FirstParameter(), last = spline->LastParameter();
  constexpr double kMinSaved = 1e-3;  // of the parameters
  const bool isPart = from > first - Precision::PConfusion() && to < last + Precision::PConfusion();
  if (!isPart || to - from > (1 - kMinSaved) * (last - first)) return {};
  const auto part = Handle(Spline)::DownCast(spline->Copy());
  part->Segment(from, to);
  return part;
}

}  // namespace

void shortenCurves(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int e = 1; e <= edges.Extent(); ++e) {
    const auto edge = Handle(BRep_TEdge)::DownCast(edges(e).TShape());
    for (const Handle(BRep_CurveRepresentation) & any : edge->Curves()) {
      const auto curve = Handle(BRep_GCurve)::DownCast(any);
      if (curve.IsNull() || curve->IsCurveOnClosedSurface()) continue;
      double from, to;
      curve->Range(from, to);
      if (curve->IsCurve3D()) {
        const auto part = partOf<Geom_BSplineCurve>(curve->Curve3D(), from, to);
        if (!part.IsNull()) curve->Curve3D(part);
      } else if (curve->IsCurveOnSurface()) {
        const auto part = partOf<Geom2d_BSplineCurve>(curve->PCurve(), from, to);
        if (!part.IsNull()) curve->PCurve(part);
      }
    }
  }
}

}  // namespace swept::step
