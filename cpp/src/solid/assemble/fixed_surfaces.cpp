// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fixed_surfaces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <utility>

#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kSamePlace = 1e-7;  // mm

}  // namespace

FixedSurfaces::FixedSurfaces(const BodyGeometry& body, const std::vector<Pose>& poses,
                             const std::vector<BodyMotion>& motions, double reach) {
  const auto faceCount = static_cast<int>(body.faces.size());
  std::vector<char> isOfUse;
  std::vector<std::size_t> firstPose;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    std::vector<int>& surfaces = surfaceOf_.emplace_back(faceCount, -1);
    for (int f = 0; f < faceCount; ++f) {
      Fixed copy{body.surfaceOf(f)};
      BodySurface& carrier = copy.carrier;
      if (!carrier.isPlane() && !carrier.isCylinder()) continue;
      if (carrier.isCylinder()) {
        const Range angles = body.anglesOf(f);
        copy.halfWidth = angles.length() / 2;
        const double middle = angles.at(0.5);
        carrier.x = std::cos(middle) * carrier.x + std::sin(middle) * carrier.y;
      }
      carrier.origin = poses[k].rotation * carrier.origin + poses[k].translation;
      for (Vector3d* direction : {&carrier.x, &carrier.axis})
        *direction = poses[k].rotation * *direction;
      const int surface = surfaces[f] = indexOf(copy);
      isOfUse.resize(fixed_.size());
      firstPose.resize(fixed_.size(), k);
      const bool doesSlide =
          (k > 0 && motions[k - 1].slides(f)) || (k + 1 < poses.size() && motions[k].slides(f));
      if (doesSlide || firstPose[surface] != k) isOfUse[surface] = 1;
    }
  }
  for (const BodyMotion& motion : motions) {
    std::vector<int>& planes = planeOf_.emplace_back(body.edges.size(), -1);
    for (std::size_t e = 0; e < body.edges.size(); ++e) {
      const BodyEdge& edge = body.edges[e];
      const auto normal = motion.planeOf(edge);
      if (!normal || !body.isConvex(edge) || !motion.isOutline(edge)) continue;
      BodySurface plane;
      plane.origin = motion.at(edge.at(edge.range.from), 0);
      plane.axis = *normal;
      plane.x = plane.axis.unitOrthogonal();
      planes[e] = indexOf({plane});
      isOfUse.resize(fixed_.size());
      isOfUse[planes[e]] = 1;
    }
  }
  std::vector<Fixed> kept;
  std::vector<int> numbers(fixed_.size(), -1);
  for (std::size_t i = 0; i < fixed_.size(); ++i) {
    if (!isOfUse[i]) continue;
    numbers[i] = static_cast<int>(kept.size());
    kept.push_back(fixed_[i]);
    kept.back().face = faceOf(fixed_[i], reach);
  }
  fixed_ = std::move(kept);
  for (std::vector<std::vector<int>>* indices : {&surfaceOf_, &planeOf_}) {
    for (std::vector<int>& of : *indices) {
      for (int& surface : of) surface = surface < 0 ? -1 : numbers[surface];
    }
  }
}

bool FixedSurfaces::areSame(const Fixed& a, const Fixed& b) {
  constexpr double kSameAngle = 1e-9;  // rad
  if (!a.carrier.isAtPlaceOf(b.carrier, kSamePlace)) return false;
  return a.carrier.isPlane() || ((a.carrier.x - b.carrier.x).norm() < kSameAngle &&
                                 std::abs(a.halfWidth - b.halfWidth) < kSameAngle);
}

int FixedSurfaces::indexOf(const Fixed& fixed) {
  const auto same = std::find_if(fixed_.begin(), fixed_.end(),
                                 [&](const Fixed& other) { return areSame(fixed, other); });
  const auto index = static_cast<int>(same - fixed_.begin());
  if (same == fixed_.end()) {
    Fixed& added = fixed_.emplace_back(fixed);
    added.carrier.origin = fixed.carrier.footOfOrigin();
    added.carrier.y = added.carrier.axis.cross(added.carrier.x);
  }
  return index;
}

void FixedSurfaces::add(int surface, const TopoDS_Edge& edge) {
  std::vector<TopoDS_Edge>& edges = fixed_[surface].edges;
  const bool isKnown = std::any_of(edges.begin(), edges.end(),
                                   [&](const TopoDS_Edge& known) { return known.IsSame(edge); });
  if (isKnown) return;
  edges.push_back(edge);
  if (fixed_[surface].carrier.isPlane()) return;  // the kernel computes the curve itself
  BRep_Builder().UpdateEdge(edge, curveOn(surface, edge), fixed_[surface].face,
                            Precision::Confusion());
}

Vector2d FixedSurfaces::parametersOf(int surface, const Vector3d& p) const {
  return fixed_[surface].carrier.parametersOf(p, Vector2d::Zero());
}

// Returns the curve of a line along the axis, or of an arc, in the parameters of a cylinder.
Handle(Geom2d_Curve) FixedSurfaces::curveOn(int surface, const TopoDS_Edge& edge) const {
  double from, to;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
  const auto on = [&](const gp_Pnt& p) {
    const Vector2d q = parametersOf(surface, vectorOf(p.XYZ()));
    return gp_Pnt2d(q.x(), q.y());
  };
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  const gp_Pnt2d start = on(curve->Value(from));
  if (spline.IsNull()) {
    const gp_Dir2d along(gp_Vec2d(start, on(curve->Value(to))));
    return new Geom2d_Line(start.Translated(gp_Vec2d(along) * -from), along);
  }
  TColgp_Array1OfPnt2d poles(1, spline->NbPoles());
  for (int i = 1; i <= spline->NbPoles(); ++i) poles(i) = {start.X(), on(spline->Pole(i)).Y()};
  return new Geom2d_BSplineCurve(poles, spline->Knots(), spline->Multiplicities(),
                                 spline->Degree());
}

// Returns a face so large that its borders coincide with nothing else.
TopoDS_Face FixedSurfaces::faceOf(const Fixed& fixed, double reach) {
  constexpr double kLarger = 1.0371;
  const BodySurface& carrier = fixed.carrier;
  const double size = kLarger * reach;
  const gp_Ax3 axes(pointOf(carrier.origin), dirOf(carrier.axis), dirOf(carrier.x));
  if (carrier.isPlane()) return BRepBuilderAPI_MakeFace(gp_Pln(axes), -size, size, -size, size);
  return BRepBuilderAPI_MakeFace(gp_Cylinder(axes, carrier.radius), -fixed.halfWidth,
                                 fixed.halfWidth, -size, size);
}

bool FixedSurfaces::doesContain(const std::vector<Vector3d>& points) const {
  return std::any_of(fixed_.begin(), fixed_.end(), [&](const Fixed& fixed) {
    return std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
      return std::abs(fixed.carrier.distanceTo(p)) < kSamePlace;
    });
  });
}

bool FixedSurfaces::doOverlap() const {
  constexpr double kTouching = 1e-6;  // rad; an arc cosine is not more exact
  for (std::size_t i = 0; i < fixed_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Fixed &a = fixed_[i], &b = fixed_[j];
      if (a.carrier.isPlane() || !a.carrier.isAtPlaceOf(b.carrier, kSamePlace)) continue;
      const double angle = std::acos(std::clamp(a.carrier.x.dot(b.carrier.x), -1.0, 1.0));
      if (angle <= a.halfWidth + b.halfWidth - kTouching) return true;
    }
  }
  return false;
}

}  // namespace swept::step
