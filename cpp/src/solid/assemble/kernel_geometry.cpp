// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/kernel_geometry.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Ax2.hxx>

namespace swept::step {
namespace {

// The knots of a B-spline in the form that the kernel expects.
struct KernelKnots {
  explicit KernelKnots(const Knots& knots)
      : at(1, static_cast<Standard_Integer>(knots.breaks().size())), multiplicities(1, at.Upper()) {
    for (Standard_Integer i = 1; i <= at.Upper(); ++i) {
      at(i) = knots.breaks()[i - 1];
      multiplicities(i) = i == 1 || i == at.Upper() ? knots.degree() + 1 : knots.joints();
    }
  }
  TColStd_Array1OfReal at;
  TColStd_Array1OfInteger multiplicities;
};

}  // namespace

gp_Trsf transformOf(const Pose& pose) {
  const Eigen::Matrix3d r = pose.rotation.normalized().toRotationMatrix();
  const Eigen::Vector3d& t = pose.translation;
  gp_Trsf transform;
  transform.SetValues(r(0, 0), r(0, 1), r(0, 2), t[0], r(1, 0), r(1, 1), r(1, 2), t[1], r(2, 0),
                      r(2, 1), r(2, 2), t[2]);
  return transform;
}

Handle(Geom_Curve) kernelCurve(const Curve& curve) {
  if (curve.kind == CurveKind::Line) return new Geom_Line(pointOf(curve.start), dirOf(curve.axis));
  if (curve.kind == CurveKind::Circle) {
    return new Geom_Circle(gp_Ax2(pointOf(curve.start), dirOf(curve.axis), dirOf(curve.xdir)),
                           curve.radius);
  }
  TColgp_Array1OfPnt poles(1, static_cast<Standard_Integer>(curve.poles.size()));
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    poles(static_cast<Standard_Integer>(i) + 1) = pointOf(curve.poles[i]);
  const KernelKnots knots(Knots(curve.degree, curve.knots, curve.joints));
  return new Geom_BSplineCurve(poles, knots.at, knots.multiplicities, curve.degree);
}

Handle(Geom2d_Curve) kernelCurveOn(const Curve& curve, const Eigen::Vector2d& scale) {
  TColgp_Array1OfPnt2d poles(1, static_cast<Standard_Integer>(curve.poles.size()));
  for (std::size_t i = 0; i < curve.poles.size(); ++i) {
    poles(static_cast<Standard_Integer>(i) + 1) = {curve.poles[i].x() / scale.x(),
                                                   curve.poles[i].y() / scale.y()};
  }
  const KernelKnots knots(Knots(curve.degree, curve.knots, curve.joints));
  return new Geom2d_BSplineCurve(poles, knots.at, knots.multiplicities, curve.degree);
}

Handle(Geom_Surface) kernelSheet(const Sheet& sheet) {
  const auto rows = static_cast<Standard_Integer>(sheet.knotsU().poleCount());
  const auto columns = static_cast<Standard_Integer>(sheet.knotsT().poleCount());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (Standard_Integer i = 1; i <= rows; ++i) {
    for (Standard_Integer j = 1; j <= columns; ++j) poles(i, j) = pointOf(sheet.pole(i - 1, j - 1));
  }
  const KernelKnots u(sheet.knotsU()), t(sheet.knotsT());
  return new Geom_BSplineSurface(poles, u.at, t.at, u.multiplicities, t.multiplicities,
                                 sheet.knotsU().degree(), sheet.knotsT().degree());
}

}  // namespace swept::step
