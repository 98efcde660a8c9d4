// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/interpolate_curve.h"

#include <Geom2dAPI_Interpolate.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Precision.hxx>
#include <TColStd_HArray1OfBoolean.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfVec.hxx>
#include <TColgp_Array1OfVec2d.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>

namespace swept::step {

Handle(Geom_BSplineCurve)
    interpolated(const std::vector<CurvePoint>& points, std::vector<double>& lengths) {
  const int n = static_cast<int>(points.size());
  const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, n);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n);
  TColgp_Array1OfVec tangents(1, n);
  const Handle(TColStd_HArray1OfBoolean) given = new TColStd_HArray1OfBoolean(1, n, Standard_True);
  lengths.assign(1, 0);
  for (int i = 0; i < n; ++i) {
    if (i > 0) lengths.push_back(lengths.back() + points[i].at.Distance(points[i - 1].at));
    places->SetValue(i + 1, points[i].at);
    parameters->SetValue(i + 1, lengths[i]);
    tangents(i + 1) = points[i].tangent;
  }
  GeomAPI_Interpolate maker(places, parameters, Standard_False, Precision::Confusion());
  maker.Load(tangents, given, Standard_False);
  maker.Perform();
  return maker.IsDone() ? maker.Curve() : Handle(Geom_BSplineCurve)();
}

Handle(Geom2d_BSplineCurve)
    interpolated(const std::vector<CurvePoint2d>& points, const std::vector<double>& lengths) {
  const int n = static_cast<int>(points.size());
  const Handle(TColgp_HArray1OfPnt2d) places = new TColgp_HArray1OfPnt2d(1, n);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n);
  TColgp_Array1OfVec2d slopes(1, n);
  const Handle(TColStd_HArray1OfBoolean) given = new TColStd_HArray1OfBoolean(1, n, Standard_True);
  for (int i = 0; i < n; ++i) {
    places->SetValue(i + 1, points[i].at);
    parameters->SetValue(i + 1, lengths[i]);
    slopes(i + 1) = points[i].slope;
  }
  Geom2dAPI_Interpolate maker(places, parameters, Standard_False, Precision::PConfusion());
  maker.Load(slopes, given, Standard_False);
  maker.Perform();
  return maker.IsDone() ? maker.Curve() : Handle(Geom2d_BSplineCurve)();
}

}  // namespace swept::step
