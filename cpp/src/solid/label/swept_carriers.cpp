// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/label/swept_carriers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sort_unique.h"
#include "solid/label/contact_curves.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Sine of the angle below which two directions count as parallel.
constexpr double kParallel = 1e-9;
/// mm: surfaces that differ by less are treated as one.
constexpr double kSame = 1e-6;
/// mm: accuracy of a profile.
constexpr double kProfileError = 1e-8;

bool areParallel(const Vector3d& a, const Vector3d& b) { return a.cross(b).norm() < 1e-8; }

bool isSameExtrusion(const Carrier& a, const Carrier& b) {
  if (std::abs(a.profile->length() - b.profile->length()) > kSame) return false;
  const Vector3d y = a.axis.cross(a.xdir);
  return std::all_of(a.profile->nodes().begin(), a.profile->nodes().end(),
                     [&](const Profile::Node& node) {
                       const Vector3d p = a.point + node.at.x() * a.xdir + node.at.y() * y;
                       return std::abs(b.distance(p)) < kSame;
                     });
}

bool isSame(const Carrier& a, const Carrier& b) {
  if (a.kind != b.kind) return false;
  const Vector3d d = b.point - a.point;
  const double across = d.cross(a.axis).norm();
  switch (a.kind) {
    case CarrierKind::Plane:
      return areParallel(a.axis, b.axis) && std::abs(d.dot(a.axis)) < kSame;
    case CarrierKind::Cylinder:
      return areParallel(a.axis, b.axis) && across < kSame && std::abs(a.radius - b.radius) < kSame;
    case CarrierKind::Sphere:
      return d.norm() < kSame && std::abs(a.radius - b.radius) < kSame;
    case CarrierKind::Torus:
      return areParallel(a.axis, b.axis) && d.norm() < kSame &&
             std::abs(a.radius - b.radius) < kSame && std::abs(a.minor - b.minor) < kSame;
    case CarrierKind::Cone: {
      if (!areParallel(a.axis, b.axis) || across > kSame) return false;
      const double turn = a.axis.dot(b.axis) > 0 ? 1 : -1;
      const double radius = a.radius + d.dot(a.axis) * std::tan(a.halfAngle);
      return std::abs(a.halfAngle - turn * b.halfAngle) < 1e-8 &&
             std::abs(radius - b.radius) < kSame;
    }
    case CarrierKind::Extrusion:
      return areParallel(a.axis, b.axis) && isSameExtrusion(a, b) && isSameExtrusion(b, a);
    default:
      return false;
  }
}

Carrier placed(Carrier carrier, const Eigen::Matrix3d& rotation, const Vector3d& shift) {
  carrier.point = rotation * carrier.point + shift;
  carrier.axis = rotation * carrier.axis;
  carrier.xdir = rotation * carrier.xdir;
  return carrier;
}

Carrier planeThrough(const Vector3d& point, const Vector3d& normal) {
  Carrier plane;
  plane.kind = CarrierKind::Plane;
  plane.point = point;
  plane.axis = normal.normalized();
  return plane;
}

// Returns the plane, parallel to the axis, that contains the curve; none if there is no such plane.
std::optional<Carrier> planeAlong(const Curve& spline, const Vector3d& axis) {
  constexpr double kFlat = 1e-7;
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i + 1 < spline.knots.size(); ++i) {
    for (const double w : {0.0, 0.25, 0.5, 0.75})
      points.push_back(spline.at(spline.knots[i] + w * (spline.knots[i + 1] - spline.knots[i])));
  }
  points.push_back(spline.at(1));
  Vector3d farthest = Vector3d::Zero();
  for (const Vector3d& p : points) {
    const Vector3d across = (p - points.front()).cross(axis);
    if (across.norm() > farthest.norm()) farthest = across;
  }
  if (farthest.norm() < kFlat) return std::nullopt;
  const Carrier plane = planeThrough(points.front(), farthest);
  const bool flat = std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
    return std::abs(plane.distance(p)) < kFlat;
  });
  return flat ? std::optional<Carrier>(plane) : std::nullopt;
}

// Cuts a spline where it runs parallel to the axis. There its projection along the axis has a cusp.
std::vector<Curve> withoutCusps(const Curve& spline, const Vector3d& axis) {
  constexpr double kCusp = 0.02, kMargin = 1e-3;
  const auto speed = [&](double t) {
    const Vector3d slope = slopeAt(spline, t);
    return slope.cross(axis).norm() / std::max(1e-300, slope.norm());
  };
  std::vector<double> cuts{0};
  const std::size_t count = 16 * (spline.knots.size() - 1);
  for (std::size_t i = 1; i < count; ++i) {
    const double h = 1.0 / static_cast<double>(count), t = h * static_cast<double>(i);
    if (speed(t) > speed(t - h) || speed(t) > speed(t + h)) continue;
    double low = t - h, high = t + h;
    for (int round = 0; round < 50; ++round) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (speed(a) < speed(b) ? high : low) = speed(a) < speed(b) ? b : a;
    }
    if (speed(low) < kCusp && low - cuts.back() > 4 * kMargin) cuts.push_back(low);
  }
  if (cuts.size() == 1) return {spline};
  cuts.push_back(1);
  std::vector<Curve> pieces;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double from = cuts[i] + (i > 0 ? kMargin : 0);
    const double to = cuts[i + 1] - (i + 2 < cuts.size() ? kMargin : 0);
    if (to > from) pieces.push_back(pieceOf(spline, from, to));
  }
  return pieces;
}

Carrier extrusionOf(const Curve& spline, const Vector3d& axis, double extension) {
  Carrier carrier;
  carrier.kind = CarrierKind::Extrusion;
  carrier.point = spline.at(0);
  carrier.axis = axis;
  carrier.xdir = anyOrthogonal(axis);
  double length = 0;
  for (std::size_t i = 0; i + 1 < spline.knots.size(); ++i)
    length += (spline.at(spline.knots[i + 1]) - spline.at(spline.knots[i])).norm();
  std::vector<Profile::Node> nodes;
  for (const double knot : spline.knots) {
    const Vector3d slope = slopeAt(spline, knot) / length;
    nodes.push_back({carrier.inProfile(spline.at(knot)),
                     Eigen::Vector2d(slope.dot(carrier.xdir), slope.dot(axis.cross(carrier.xdir))),
                     length * knot});
  }
  const Eigen::Vector2d first = nodes.front().slope.normalized(),
                        last = nodes.back().slope.normalized();
  const bool closed = (nodes.front().at - nodes.back().at).norm() < kKernelTolerance &&
                      (first - last).norm() < 1e-3;
  if (closed) nodes.back() = {nodes.front().at, nodes.front().slope, nodes.back().knot};
  carrier.profile = std::make_shared<const Profile>(std::move(nodes), closed, extension);
  return carrier;
}

}  // namespace

SweptCarriers::SweptCarriers(const BodyShape& body, const Trajectory& trajectory, double extension)
    : body_(body), trajectory_(trajectory), extension_(extension) {}

SweptCarriers::Placement SweptCarriers::placementAt(std::int32_t pose) const {
  const Pose& at = trajectory_.poses[static_cast<std::size_t>(pose)];
  return {at.rotation.toRotationMatrix(), at.translation};
}

bool SweptCarriers::isStraight(std::int32_t step) const {
  if (step < 0 || step + 1 >= std::ssize(trajectory_.poses) ||
      trajectory_.interpolation == Interpolation::None)
    return false;
  const Placement from = placementAt(step), to = placementAt(step + 1);
  return (from.rotation - to.rotation).norm() < 1e-12 && (from.shift - to.shift).norm() > kSame;
}

Vector3d SweptCarriers::directionInBody(std::int32_t step) const {
  const Placement from = placementAt(step);
  return from.rotation.transpose() * (placementAt(step + 1).shift - from.shift);
}

const std::vector<std::int32_t>& SweptCarriers::carriersOf(const SurfaceSource& source) {
  const Label label{static_cast<int>(source.kind), source.faces[0], source.faces[1], source.step};
  const auto [it, isNew] = known_.try_emplace(label);
  if (!isNew) return it->second;
  std::vector<std::int32_t> found;
  const auto take = [&](const std::vector<std::int32_t>& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  const auto count = static_cast<std::int32_t>(body_.faces.size());
  const auto exists = [&](std::int32_t face) { return face >= 0 && face < count; };
  if (source.kind == SourceKind::Cap) {
    if (exists(source.faces[0]) && source.step >= 0 && source.step < std::ssize(trajectory_.poses))
      take(made(Made::Cap, source.faces[0], source.step));
  } else if (isStraight(source.step)) {
    for (const std::int32_t face : source.faces) {
      if (source.kind == SourceKind::Graze && exists(face))
        take(made(Made::Graze, face, source.step));
    }
    if (exists(source.faces[0])) {
      for (const std::int32_t e : body_.faces[source.faces[0]].edges) {
        const bool between = body_.edges[e].faces == source.faces;
        if (between) take(made(Made::Edge, e, source.step));
      }
    }
  }
  sortUnique(found);
  return known_[label] = std::move(found);
}

const std::vector<std::int32_t>& SweptCarriers::made(Made what, std::int32_t element,
                                                     std::int32_t step) {
  const auto [it, isNew] = made_.try_emplace({static_cast<int>(what), element, step});
  if (!isNew) return it->second;
  std::vector<std::int32_t>& to = it->second;
  if (what == Made::Cap) addCap(element, step, to);
  if (what == Made::Edge) addSwept(element, step, to);
  if (what == Made::Graze) addGraze(element, step, to);
  return to;
}

void SweptCarriers::addCap(std::int32_t face, std::int32_t pose, std::vector<std::int32_t>& to) {
  const Carrier& surface = body_.faces[face].surface;
  if (surface.kind == CarrierKind::Facet) return;
  const Placement placement = placementAt(pose);
  Traces traces;
  for (const std::int32_t e : body_.faces[face].edges) traceEdge(body_.edges[e], placement, traces);
  for (const std::int32_t step : {pose - 1, pose}) {
    if (!isStraight(step)) continue;
    const Vector3d direction = directionInBody(step).normalized();
    for (const Curve& curve : contactCurves(body_, face, direction))
      traces.curves.push_back(moved(curve, placement.rotation, placement.shift));
    for (const std::int32_t e : body_.faces[face].edges) {
      for (const Vector3d& p : contactsOn(e, face, direction))
        traces.points.push_back(placement(p));
    }
  }
  to.push_back(add(placed(surface, placement.rotation, placement.shift), traces));
}

void SweptCarriers::traceEdge(const BodyEdge& edge, const Placement& placement,
                              Traces& traces) const {
  traces.curves.push_back(moved(edge.curve, placement.rotation, placement.shift));
  if (isClosed(edge.curve)) return;
  for (const double t : {0.0, edge.curve.last})
    traces.points.push_back(placement(edge.curve.at(t)));
}

void SweptCarriers::tracePoints(const std::vector<Vector3d>& points, std::int32_t step,
                                Traces& traces) const {
  for (const Vector3d& p : points) {
    const Vector3d from = placementAt(step)(p), to = placementAt(step + 1)(p);
    traces.points.push_back(from);
    traces.points.push_back(to);
    traces.curves.push_back(lineThrough(from, to));
  }
}

std::vector<Vector3d> SweptCarriers::contactsOn(std::int32_t edge, std::int32_t face,
                                                const Vector3d& direction) const {
  return contactPoints(body_.edges[edge].curve, body_.faces[face].surface, direction);
}

void SweptCarriers::addSwept(std::int32_t edge, std::int32_t step, std::vector<std::int32_t>& to) {
  const BodyEdge& made = body_.edges[edge];
  const Vector3d direction = directionInBody(step).normalized();
  Traces traces;
  traceEdge(made, placementAt(step), traces);
  traceEdge(made, placementAt(step + 1), traces);
  std::vector<Vector3d> points;
  if (!isClosed(made.curve)) points = {made.curve.at(0), made.curve.at(made.curve.last)};
  for (const std::int32_t face : made.faces) {
    if (face < 0) continue;
    for (const Vector3d& p : contactsOn(edge, face, direction)) points.push_back(p);
  }
  tracePoints(points, step, traces);
  sweepCurve(made.curve, step, to, traces);
}

void SweptCarriers::addGraze(std::int32_t face, std::int32_t step, std::vector<std::int32_t>& to) {
  const Carrier& surface = body_.faces[face].surface;
  const Vector3d direction = directionInBody(step).normalized();
  if (slidesAlong(surface, direction)) {
    for (const std::int32_t pose : {step, step + 1}) {
      for (const std::int32_t carrier : made(Made::Cap, face, pose)) to.push_back(carrier);
    }
    Traces paths;
    for (const std::int32_t e : body_.faces[face].edges) {
      const Curve& curve = body_.edges[e].curve;
      if (!isClosed(curve)) tracePoints({curve.at(0), curve.at(curve.last)}, step, paths);
    }
    const Placement placement = placementAt(step);
    if (!to.empty()) add(placed(surface, placement.rotation, placement.shift), paths);
    sortUnique(to);
    return;
  }
  std::vector<Vector3d> points;
  for (const std::int32_t e : body_.faces[face].edges) {
    for (const Vector3d& p : contactsOn(e, face, direction)) points.push_back(p);
  }
  for (const Curve& curve : contactCurves(body_, face, direction)) {
    Traces traces;
    for (const std::int32_t pose : {step, step + 1}) {
      const Placement placement = placementAt(pose);
      traces.curves.push_back(moved(curve, placement.rotation, placement.shift));
    }
    tracePoints(points, step, traces);
    sweepCurve(curve, step, to, traces);
  }
}

void SweptCarriers::sweepCurve(const Curve& curve, std::int32_t step, std::vector<std::int32_t>& to,
                               const Traces& traces) {
  const Placement placement = placementAt(step);
  const Vector3d direction = directionInBody(step).normalized();
  const auto take = [&](const Carrier& carrier) {
    to.push_back(add(placed(carrier, placement.rotation, placement.shift), traces));
  };
  if (curve.kind == CurveKind::Line) {
    const Vector3d normal = curve.axis.cross(direction);
    if (normal.norm() > kParallel) take(planeThrough(curve.start, normal));
    return;
  }
  if (curve.kind == CurveKind::Circle && areParallel(curve.axis, direction)) {
    Carrier cylinder;
    cylinder.kind = CarrierKind::Cylinder;
    cylinder.point = curve.start;
    cylinder.axis = direction;
    cylinder.radius = curve.radius;
    take(cylinder);
    return;
  }
  const Curve spline = asSpline(curve, kProfileError);
  if (const auto plane = planeAlong(spline, direction)) {
    take(*plane);
    return;
  }
  for (const Curve& piece : withoutCusps(spline, direction))
    take(extrusionOf(piece, direction, extension_));
}

std::int32_t SweptCarriers::add(const Carrier& carrier, const Traces& traces) {
  std::size_t n = 0;
  while (n < carriers_.size() && !isSame(carriers_[n], carrier)) ++n;
  if (n == carriers_.size()) {
    carriers_.push_back(carrier);
    traces_.emplace_back();
  }
  Traces& all = traces_[n];
  all.curves.insert(all.curves.end(), traces.curves.begin(), traces.curves.end());
  all.points.insert(all.points.end(), traces.points.begin(), traces.points.end());
  return static_cast<std::int32_t>(n);
}

void SweptCarriers::finish() {
  for (std::size_t n = 0; n < carriers_.size(); ++n)
    carriers_[n].traces = std::make_shared<const Traces>(traces_[n]);
}

}  // namespace swept::step
