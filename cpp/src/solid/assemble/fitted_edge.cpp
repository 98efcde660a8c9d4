// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fitted_edge.h"

#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>

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
  const auto fitted = fitClosely(
      [&](double t) {
        const Vector2d p = on(t).cwiseProduct(scale);
        return Vector3d(p.x(), p.y(), 0);
      },
      range);
  if (!fitted) return false;
  BRep_Builder().UpdateEdge(edge, kernelCurveOn(*fitted, scale), face, Precision::Confusion());
  return true;
}

}  // namespace swept::step
