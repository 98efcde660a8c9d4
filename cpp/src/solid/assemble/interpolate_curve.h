// Splines through points with given tangents.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>
#include <vector>

namespace swept::step {

/// mm: how far computed curves may lie off the exact ones.
constexpr double kCurveBound = 5e-8;

/// A point of a curve and its unit tangent.
struct CurvePoint {
  gp_Pnt at;
  gp_Vec tangent;
};

/// The same in the parameters of a surface. `tangent`: change of the parameters along the curve.
struct CurvePoint2d {
  gp_Pnt2d at;
  gp_Vec2d tangent;
};

/// Returns the change of the parameters of a surface along the part of `step` that is tangent to
/// it. alongU, alongV: derivatives of the surface.
gp_Vec2d parametersAlong(const gp_Vec& step, const gp_Vec& alongU, const gp_Vec& alongV);

/// Returns a spline of cubics through the points. Its parameters at the points are `lengths`: the
/// lengths of the chords up to them. Null if the kernel fails.
Handle(Geom_BSplineCurve)
    interpolated(const std::vector<CurvePoint>& points, std::vector<double>& lengths);

/// Does the same in the parameters of a surface. `lengths` is given.
Handle(Geom2d_BSplineCurve)
    interpolated(const std::vector<CurvePoint2d>& points, const std::vector<double>& lengths);

}  // namespace swept::step
