// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/interpolate_curve.h"

#include <Geom2dAPI_Interpolate.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfBoolean.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfVec.hxx>
#include <TColgp_Array1OfVec2d.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <type_traits>
#include <utility>

namespace swept::step {
namespace {

// Returns the spline through the points, or null. `nearest`: smallest distance of two points.
template <class Maker, class Places, class Tangents, class Points>
auto throughPoints(const Points& points, const std::vector<double>& lengths, double nearest) {
  const int n = static_cast<int>(points.size());
  const Handle(Places) places = new Places(1, n);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n);
  Tangents tangents(1, n);
  const Handle(TColStd_HArray1OfBoolean) given = new TColStd_HArray1OfBoolean(1, n, Standard_True);
  for (int i = 0; i < n; ++i) {
    places->SetValue(i + 1, points[i].at);
    parameters->SetValue(i + 1, lengths[i]);
    tangents(i + 1) = points[i].tangent;
  }
  using Curve = std::decay_t<decltype(std::declval<const Maker&>().Curve())>;
  try {
    Maker maker(places, parameters, Standard_False, nearest);
    maker.Load(tangents, given, Standard_False);
    maker.Perform();
    return maker.IsDone() ? maker.Curve() : Curve();
  } catch (const Standard_Failure&) {
    return Curve();  // two points are too near to each other
  }
}

}  // namespace

gp_Vec2d parametersAlong(const gp_Vec& step, const gp_Vec& alongU, const gp_Vec& alongV) {
  const double uu = alongU.SquareMagnitude(), uv = alongU.Dot(alongV),
               vv = alongV.SquareMagnitude(), determinant = uu * vv - uv * uv;
  const double u = step.Dot(alongU), v = step.Dot(alongV);
  return {(vv * u - uv * v) / determinant, (uu * v - uv * u) / determinant};
}

Handle(Geom_BSplineCurve)
    interpolated(const std::vector<CurvePoint>& points, std::vector<double>& lengths) {
  lengths.assign(1, 0);
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(lengths.back() + points[i].at.Distance(points[i - 1].at));
  return throughPoints<GeomAPI_Interpolate, TColgp_HArray1OfPnt, TColgp_Array1OfVec>(
      points, lengths, Precision::Confusion());
}

Handle(Geom2d_BSplineCurve)
    interpolated(const std::vector<CurvePoint2d>& points, const std::vector<double>& lengths) {
  return throughPoints<Geom2dAPI_Interpolate, TColgp_HArray1OfPnt2d, TColgp_Array1OfVec2d>(
      points, lengths, Precision::PConfusion());
}

}  // namespace swept::step
