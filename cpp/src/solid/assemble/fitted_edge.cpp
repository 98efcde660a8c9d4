// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fitted_edge.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BSplCLib.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <gp.hxx>

#include "solid/assemble/interpolate_curve.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/carrier/fit_spline.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Along these curves, faces are often tangent, and the kernel's check for intersections is
// sensitive to errors there. So a smaller bound than that of other curves is tried first.
std::optional<Curve> fitClosely(const ExactCurve& exact, Range range) {
  constexpr double kCloseBound = 1e-8;  // mm
  const auto fitted = fitSpline(exact, range, kCloseBound);
  return fitted ? fitted : fitSpline(exact, range, kCurveBound);
}

// Returns a curve in the parameters of a face as one in the plane z = 0, in mm.
ExactCurve inMillimetres(const std::function<Vector2d(double)>& on, const Vector2d& scale) {
  return [&on, scale](double t) {
    const Vector2d p = on(t).cwiseProduct(scale);
    return Vector3d(p.x(), p.y(), 0);
  };
}

}  // namespace

TopoDS_Edge fittedEdge(const std::function<Vector3d(double)>& exact, Range range) {
  TopoDS_Edge edge;
  const auto fitted = fitClosely(exact, range);
  if (!fitted) return edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge, kernelCurve(*fitted), Precision::Confusion());
  builder.Range(edge, 0, fitted->last);
  return edge;
}

bool addCurveOn(const TopoDS_Face& face, const TopoDS_Edge& edge,
                const std::function<Vector2d(double)>& on, const Vector2d& scale, Range range) {
  const auto fitted = fitClosely(inMillimetres(on, scale), range);
  if (!fitted) return false;
  BRep_Builder().UpdateEdge(edge, kernelCurveOn(*fitted, scale), face, Precision::Confusion());
  return true;
}

bool addCurveOfTwin(const TopoDS_Face& face, const TopoDS_Edge& edge, const TopoDS_Edge& twin,
                    double far) {
  constexpr int kSamples = 64, kTests = 16;
  Range range, of;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  const Handle(Geom2d_Curve) known = BRep_Tool::CurveOnSurface(twin, face, of.from, of.to);
  if (known.IsNull() || BRep_Tool::IsClosed(twin, face)) return false;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const GeomAdaptor_Curve along(BRep_Tool::Curve(twin, of.from, of.to), of.from, of.to);
  std::vector<std::pair<double, gp_Pnt>> samples;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = of.at(static_cast<double>(i) / kSamples);
    samples.emplace_back(t, along.Value(t));
  }
  const std::function<Vector2d(double)> on = [&](double t) {
    const gp_Pnt p = curve->Value(t);
    const auto isNearer = [&](const auto& a, const auto& b) {
      return a.second.SquareDistance(p) < b.second.SquareDistance(p);
    };
    const double start = std::min_element(samples.begin(), samples.end(), isNearer)->first;
    gp_Pnt foot;
    double found = start;
    ShapeAnalysis_Curve().NextProject(start, along, p, Precision::Confusion(), foot, found);
    const gp_Pnt2d q = known->Value(std::clamp(found, of.from, of.to));
    return Vector2d(q.X(), q.Y());
  };
  const Vector2d middle = on(range.at(0.5));
  gp_Pnt p;
  gp_Vec u, v;
  surface->D1(middle.x(), middle.y(), p, u, v);
  const Vector2d scale(u.Magnitude(), v.Magnitude());
  if (scale.minCoeff() < gp::Resolution()) return false;
  const auto fitted = fitSpline(inMillimetres(on, scale), range, std::max(kCurveBound, far / 10));
  if (!fitted) return false;
  const auto result = Handle(Geom2d_BSplineCurve)::DownCast(kernelCurveOn(*fitted, scale));
  TColStd_Array1OfReal knots(1, result->NbKnots());
  result->Knots(knots);
  BSplCLib::Reparametrize(range.from, range.to, knots);
  result->SetKnots(knots);
  for (int i = 0; i <= kTests; ++i) {
    const double t = range.at(static_cast<double>(i) / kTests);
    const gp_Pnt2d q = result->Value(t);
    if (surface->Value(q.X(), q.Y()).Distance(curve->Value(t)) > far) return false;
  }
  BRep_Builder().UpdateEdge(edge, result, face, Precision::Confusion());
  return true;
}

}  // namespace swept::step
