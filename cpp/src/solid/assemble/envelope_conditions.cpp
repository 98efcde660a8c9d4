// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/envelope_conditions.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/assemble/kernel_geometry.h"
#include "solid/sweep/contact.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

MovingBody::MovingBody(const TopoDS_Shape& shape, const Trajectory& trajectory) : body(shape) {
  const std::vector<Pose>& poses = trajectory.poses;
  paths.reserve(poses.size());
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    paths.emplace_back(poses[k], poses[k + 1], trajectory.interpolation);
    motions.emplace_back(body, paths.back());
  }
}

Condition EnvelopeConditions::ofCap(const TopoDS_Face& posed, int time) const {
  const BRepAdaptor_Surface surface(posed, Standard_False);
  const double sign = (posed.Orientation() == TopAbs_REVERSED) == (time == 1) ? -1 : 1;
  const Moment moment(path(), time);
  return [surface, sign, moment](const Vector2d& on) {
    gp_Pnt p;
    gp_Vec alongU, alongV;
    surface.D1(on.x(), on.y(), p, alongU, alongV);
    const Vector3d seen = moment.placement.applyInverse(vectorOf(p.XYZ()));
    const Vector3d normal = vectorOf(alongU.Crossed(alongV).XYZ()),
                   velocity = moment.placement.rotation * moment.velocityAt(seen);
    const double sizes = normal.norm() * velocity.norm();
    return sizes > 0 ? sign * normal.dot(velocity) / sizes : 0;
  };
}

Condition EnvelopeConditions::ofSheet(std::size_t edge) const {
  return [moving = moving_, step = step_, edge](const Vector2d& on) {
    const BodyEdge& of = moving->body.edges[edge];
    const Moment moment(moving->paths[step], on.y() / moving->motions[step].length());
    const Vector3d velocity = moment.velocityAt(of.at(on.x())).normalized();
    return -moving->body.normalAt(of, of.faces[0], on.x()).dot(velocity) *
           moving->body.normalAt(of, of.faces[1], on.x()).dot(velocity);
  };
}

std::vector<Condition> EnvelopeConditions::ofGraze(int surface, const ContactCurves& curves,
                                                   int curve) const {
  const double length = moving_->motions[step_].length();
  return ofContacts(
      surface,
      [curves, curve, length](const Vector2d& on) -> Touch {
        const double s = on.y() / length;
        return {curves.at(curve, on.x(), s), s};
      },
      [curves, curve](const Vector2d& on, const Touch&) { return curves.doesOwn(curve, on.x()); });
}

std::vector<Condition> EnvelopeConditions::ofFan(int surface, const ContactCurves& curves,
                                                 const ContactCurves::Fan& fan) const {
  const double length = moving_->motions[step_].length();
  return ofContacts(
      surface,
      [curves, fan, length](const Vector2d& on) {
        return curves.at(fan, {on.x(), on.y() / length});
      },
      [curves, fan](const Vector2d&, const Touch& touch) { return curves.doesOwn(fan, touch); });
}

std::vector<Condition> EnvelopeConditions::ofContacts(
    int surface, std::function<Touch(const Vector2d&)> touchAt,
    std::function<bool(const Vector2d&, const Touch&)> doesOwn) const {
  const BodyGeometry& body = moving_->body;
  std::vector<int> faces;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    if (body.faces[f].surface == surface) faces.push_back(static_cast<int>(f));
  }
  const double length = moving_->motions[step_].length();
  const auto isInFace = [moving = moving_, faces, touchAt, doesOwn](const Vector2d& on) {
    const Touch touch = touchAt(on);
    if (!touch.p.allFinite() || !doesOwn(on, touch)) return -1.0;
    // A contact curve may run along a border between two faces.
    const bool isInside = std::any_of(faces.begin(), faces.end(), [&](int f) {
      return moving->body.placeOf(f, touch.p) != TopAbs_OUT;
    });
    return isInside ? 1.0 : -1.0;
  };
  const auto isOutside = [moving = moving_, step = step_, touchAt, surface,
                          length](const Vector2d& on) {
    // Where the path of the point only touches the surface, samples judge better.
    constexpr double kStep = 1e-3, kTouching = 0.02;
    const StepPath& along = moving->paths[step];
    const BodySurface& of = moving->body.surfaces[surface];
    const Touch touch = touchAt(on);
    const Vector3d p = along.at(touch.s).apply(touch.p);
    if (!p.allFinite()) return -1.0;
    double distance = 0;
    for (const double other : {touch.s - kStep, touch.s + kStep})
      distance += of.outward * of.distanceTo(along.at(other).applyInverse(p));
    return distance / (kStep * kStep * length) + kTouching;
  };
  return {isInFace, isOutside};
}

}  // namespace swept::step
