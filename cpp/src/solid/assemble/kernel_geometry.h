// Curves and sheets of this project as geometry of the kernel. Parameters stay the same.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "solid/carrier/curve.h"
#include "solid/carrier/sheet.h"
#include "swept/types.h"

namespace swept::step {

inline gp_Pnt pointOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
inline gp_Vec vecOf(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline gp_Dir dirOf(const Eigen::Vector3d& d) { return {d.x(), d.y(), d.z()}; }
inline Eigen::Vector3d vectorOf(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

gp_Trsf transformOf(const Pose& pose);

Handle(Geom_Curve) kernelCurve(const Curve& curve);
/// Returns the curve in the parameters of a surface. The x and y of its poles are these parameters
/// times `scale` (mm per unit of the parameters).
Handle(Geom2d_Curve) kernelCurveOn(const Curve& curve, const Eigen::Vector2d& scale);
Handle(Geom_Surface) kernelSheet(const Sheet& sheet);

}  // namespace swept::step
