// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "solid/sweep/borders.h"
#include "solid/sweep/contact.h"
#include "solid/sweep/exact_kinds.h"
#include "solid/sweep/interpolate.h"
#include "solid/sweep/rails.h"
#include "solid/sweep/regular.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Radians: the smallest gap between contacts on a closed rail at which the rail can be cut open.
constexpr double kMinRailGap = 0.35;

SweptSurface none(Degeneracy why, const Vector2d& where = Vector2d::Zero()) {
  SweptSurface result;
  result.why = why;
  result.where = where;
  return result;
}

// Shifts periodic values by whole periods so that they lie together: the period is cut at their
// largest gap. Returns whether this gap is large enough.
bool unwrap(std::vector<double>& values, double period) {
  if (period == 0) return true;
  std::vector<double> sorted;
  for (double& x : values) {
    x -= period * std::floor(x / period);
    sorted.push_back(x);
  }
  std::sort(sorted.begin(), sorted.end());
  double gap = sorted.front() + period - sorted.back(), cut = sorted.front();
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] - sorted[i - 1] <= gap) continue;
    gap = sorted[i] - sorted[i - 1];
    cut = sorted[i];
  }
  for (double& x : values) {
    if (x < cut) x += period;
  }
  return gap >= kMinRailGap;
}

Range rangeOf(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

// Returns the index of the contact nearest to the middle of the ranges of w and s.
std::size_t middleOf(const std::vector<double>& w, Range rangeW, const std::vector<double>& s,
                     Range rangeS) {
  std::size_t best = 0;
  double smallest = 1e300;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double a = (w[i] - rangeW.at(0.5)) / std::max(1e-300, rangeW.length());
    const double b = (s[i] - rangeS.at(0.5)) / std::max(1e-300, rangeS.length());
    if (a * a + b * b >= smallest) continue;
    smallest = a * a + b * b;
    best = i;
  }
  return best;
}

// Makes the carrier of an exact surface, and tests it. `outward`: outward normal of the face at (w,
// s).
SweptSurface carrierOf(const ExactSurface& exact, const ExactSurface& outward, Range w, Range s,
                       Range innerW, Range innerS, bool isRuled, const StepPath& path,
                       double bound) {
  const Vector2d middle(innerW.at(0.5), innerS.at(0.5));
  SweptSurface result;
  const Knots straight(1, {w.from, w.to});
  const auto fitted = fitSheet(exact, w, s, isRuled ? &straight : nullptr, bound);
  if (!fitted) return none(Degeneracy::TooComplex, middle);
  if (const auto singular = findSingular(*fitted->sheet, innerW, innerS, outward))
    return none(Degeneracy::Singular, *singular);
  result.error = fitted->error;
  result.carrier = exactKind(exact, w, s, path, bound);
  if (!result.carrier) {
    result.carrier.emplace();
    result.carrier->kind = CarrierKind::Sheet;
    result.carrier->sheet = fitted->sheet;
  }
  faceOutwards(*result.carrier, exact(middle.x(), middle.y()), outward(middle.x(), middle.y()));
  return result;
}

// A sphere touches the envelope along the great circle perpendicular to the velocity of its centre.
class SphereContact {
 public:
  SphereContact(const Carrier& face, const StepPath& path) : face_(face), path_(path) {
    // Angles start in the direction that is most nearly perpendicular to the velocity.
    double least = 1e300;
    for (const Vector3d& k : {Vector3d(path.axis()), Vector3d::UnitX().eval(),
                              Vector3d::UnitY().eval(), Vector3d::UnitZ().eval()}) {
      double most = 0;
      for (int i = 0; i <= 16; ++i)
        most = std::max(most, std::abs(k.dot(velocityAt(i / 16.0).normalized())));
      if (most >= least - 0.1) continue;
      least = most;
      from_ = k;
    }
  }
  Vector3d centreAt(double s) const { return path_.at(s).apply(face_.point); }
  Vector3d velocityAt(double s) const {
    const Moment moment(path_, s);
    return moment.placement.rotation * moment.velocityAt(face_.point);
  }
  Vector3d outwardAt(double w, double s) const {
    const Vector3d direction = velocityAt(s).normalized();
    const Vector3d x = (from_ - from_.dot(direction) * direction).normalized();
    return std::cos(w) * x + std::sin(w) * direction.cross(x);
  }
  double angleOf(const Vector3d& p, double s) const {
    const Vector3d d = p - centreAt(s), x = outwardAt(0, s), y = outwardAt(M_PI / 2, s);
    return std::atan2(d.dot(y), d.dot(x));
  }

 private:
  const Carrier& face_;
  const StepPath& path_;
  Vector3d from_ = Vector3d::UnitX();
};

SweptSurface grazeOfSphere(const Carrier& face, const std::vector<Contact>& contacts,
                           const StepPath& path, double bound) {
  const SphereContact contact(face, path);
  double fastest = 0, slowest = 1e300;
  for (int i = 0; i <= 16; ++i) {
    const double speed = contact.velocityAt(i / 16.0).norm();
    fastest = std::max(fastest, speed);
    slowest = std::min(slowest, speed);
  }
  if (!(fastest > kNoSpeed * face.radius)) return none(Degeneracy::AtRest);
  if (!(slowest > 1e-3 * fastest)) return none(Degeneracy::Singular);
  std::vector<double> angles, times;
  for (const Contact& c : contacts) {
    angles.push_back(contact.angleOf(c.point, c.s));
    times.push_back(c.s);
  }
  if (!unwrap(angles, 2 * M_PI)) return none(Degeneracy::NotKnown);
  const Range innerW = rangeOf(angles), innerS = rangeOf(times);
  const double side = face.reversed ? -1 : 1;
  const ExactSurface outward = [&](double w, double s) {
    return Vector3d(side * contact.outwardAt(w, s));
  };
  const ExactSurface exact = [&](double w, double s) {
    return Vector3d(contact.centreAt(s) + face.radius * contact.outwardAt(w, s));
  };
  const Range w = innerW.grown(kMargin), s = innerS.grown(kMargin);
  const auto along = pathOf(face.point, path, s, 0.1 * bound);
  if (along && along->kind == CurveKind::Circle && face.radius < along->radius) {
    SweptSurface result;
    result.carrier.emplace();
    Carrier& torus = *result.carrier;
    torus.kind = CarrierKind::Torus;
    torus.point = along->start;
    torus.axis = along->axis;
    torus.radius = along->radius;
    torus.minor = face.radius;
    const Vector3d middle = exact(innerW.at(0.5), innerS.at(0.5)), d = middle - torus.point;
    const Vector3d across = d - d.dot(torus.axis) * torus.axis;
    torus.xdir = -across.normalized();
    torus.tubeMid = std::atan2(d.dot(torus.axis), across.norm() - torus.radius);
    faceOutwards(torus, middle, outward(innerW.at(0.5), innerS.at(0.5)));
    return result;
  }
  return carrierOf(exact, outward, w, s, innerW, innerS, false, path, bound);
}

// Contacts on the rails of a face: their parameters, and the ranges of w and s.
struct OnRails {
  std::vector<double> w, v, s;
  Range rangeW, rangeS;
  bool isOpen = true;   // false if the contacts lie all around a closed rail
  double crossing = 0;  // the smallest sine of the angle between rails and contact curves
  // mm per unit of s: largest change of the normal speed over the contacts, and largest speed.
  double largestNormalSpeed = 0, largestSpeed = 0;
};

OnRails locate(const Rails& rails, const std::vector<Contact>& contacts, const StepPath& path,
               double size) {
  OnRails on;
  const ContactMap map(rails, path, size);
  on.crossing = 1;
  for (const Contact& c : contacts) {
    const Moment moment(path, c.s);
    const Vector3d x = moment.placement.applyInverse(c.point);
    const Vector2d at = rails.parametersOf(x);
    on.w.push_back(at.x());
    on.v.push_back(at.y());
    on.s.push_back(c.s);
    const Vector2d slope = map.slopes(at.x(), at.y(), moment);
    on.largestNormalSpeed = std::max(on.largestNormalSpeed, slope.norm() * size);
    on.largestSpeed = std::max(on.largestSpeed, moment.velocityAt(x).norm());
    on.crossing = std::min(on.crossing, std::abs(slope.x()) / std::max(slope.norm(), 1e-300));
  }
  on.isOpen = unwrap(on.w, rails.periods()[0]);
  on.rangeW = rangeOf(on.w);
  on.rangeS = rangeOf(on.s);
  return on;
}

double extentOf(const std::vector<Contact>& contacts) {
  Eigen::AlignedBox3d box;
  for (const Contact& c : contacts) box.extend(c.point);
  return box.diagonal().norm();
}

// Returns the direction of the contact line of a plane: the projection of the rotation axis onto
// the plane. Returns nothing if the plane only moves parallel to itself.
std::optional<Vector3d> lineDirection(const Carrier& face, const std::vector<Contact>& contacts,
                                      const StepPath& path, double size) {
  const Moment moment(path, contacts.front().s);
  const Vector3d along = moment.angular - moment.angular.dot(face.axis) * face.axis;
  if (!(along.norm() * size > kNoSpeed * moment.velocityAt(face.point).norm()) ||
      !(along.norm() > kNoSpeed))
    return std::nullopt;
  return along.normalized();
}

SweptSurface followed(const Rails& rails, const OnRails& on, bool isRuled, double size,
                      const StepPath& path, double bound) {
  if (!on.isOpen) return none(Degeneracy::NotKnown, {on.rangeW.from, on.rangeS.from});
  const std::size_t first = middleOf(on.w, on.rangeW, on.s, on.rangeS);
  const Vector3d start(on.w[first], on.v[first], on.s[first]);
  SweptSurface result;
  // If the surface with a margin around the range is too complex, try again without the margin.
  for (const double margin : {kMargin, 0.0}) {
    const Range w = on.rangeW.grown(margin), s = on.rangeS.grown(margin);
    ContactMap map(rails, path, size);
    Vector2d where = Vector2d::Zero();
    const Degeneracy why = map.follow(w, s, on.rangeW, on.rangeS, start, where);
    if (why != Degeneracy::None) return none(why, where);
    const ExactSurface exact = [&](double a, double b) {
      const double v = map.parameterAt(a, b);
      if (!std::isfinite(v)) return Vector3d::Constant(v).eval();
      return path.at(b).apply(rails.at(a, v).at);
    };
    const ExactSurface outward = [&](double a, double b) {
      return Vector3d(path.at(b).rotation * rails.at(a, map.parameterAt(a, b)).normal);
    };
    result = carrierOf(exact, outward, w, s, on.rangeW, on.rangeS, isRuled, path, bound);
    if (result.why != Degeneracy::TooComplex) break;
  }
  return result;
}

}  // namespace

SweptSurface grazeOf(const Carrier& face, const std::vector<Contact>& contacts,
                     const StepPath& path, double bound) {
  if (contacts.empty()) return none(Degeneracy::NoContact);
  if (face.kind == CarrierKind::Sphere) return grazeOfSphere(face, contacts, path, bound);
  const double size = extentOf(contacts);
  if (!(size > 0)) return none(Degeneracy::NoContact);
  if (face.isPlanar()) {
    const auto along = lineDirection(face, contacts, path, size);
    if (!along) {
      const Moment moment(path, contacts.front().s);
      const bool slides = std::abs(face.axis.dot(moment.linear)) <= kNoSpeed * moment.linear.norm();
      return none(slides ? Degeneracy::AlongItself : Degeneracy::NoContact);
    }
    const auto rails = railsOf(face, false, *along);
    return followed(*rails, locate(*rails, contacts, path, size), true, size, path, bound);
  }
  const auto rails = railsOf(face, false, Vector3d::Zero()),
             crossed = railsOf(face, true, Vector3d::Zero());
  const OnRails on = locate(*rails, contacts, path, size),
                onCrossed = locate(*crossed, contacts, path, size);
  if (!(on.largestSpeed > 0)) return none(Degeneracy::AtRest);
  if (!(on.largestNormalSpeed > kNoSpeed * on.largestSpeed)) return none(Degeneracy::AlongItself);
  return on.crossing >= onCrossed.crossing
             ? followed(*rails, on, false, size, path, bound)
             : followed(*crossed, onCrossed, false, size, path, bound);
}

std::optional<Curve> contactAt(const Carrier& face, const std::vector<Vector3d>& along,
                               const StepPath& path, double s, double bound) {
  std::vector<Contact> contacts;
  for (const Vector3d& p : along) contacts.push_back({p, s});
  const double size = contacts.empty() ? 0 : extentOf(contacts);
  if (!(size > 0)) return std::nullopt;
  if (face.kind == CarrierKind::Sphere) {
    const SphereContact contact(face, path);
    std::vector<double> angles;
    for (const Contact& c : contacts) angles.push_back(contact.angleOf(c.point, s));
    if (!unwrap(angles, 2 * M_PI)) return std::nullopt;
    const auto exact = [&](double w) {
      return Vector3d(contact.centreAt(s) + face.radius * contact.outwardAt(w, s));
    };
    return curveOf(exact, {angles.front(), angles.back()}, bound);
  }
  const auto direction = face.isPlanar() ? lineDirection(face, contacts, path, size)
                                         : std::optional<Vector3d>(Vector3d::Zero());
  if (!direction) return std::nullopt;
  auto rails = railsOf(face, false, *direction), crossed = railsOf(face, true, *direction);
  OnRails on = locate(*rails, contacts, path, size), other = locate(*crossed, contacts, path, size);
  if (other.crossing > on.crossing) {
    std::swap(rails, crossed);
    std::swap(on, other);
  }
  // The points need not lie on the curve, but they must be in the order of the rails.
  const double sign = on.w.back() > on.w.front() ? 1 : -1;
  for (std::size_t i = 1; i < on.w.size(); ++i) {
    if (!(sign * (on.w[i] - on.w[i - 1]) > 0)) return std::nullopt;
  }
  if (!on.isOpen || !unwrap(on.v, rails->periods()[1])) return std::nullopt;
  const ContactMap map(*rails, path, size);
  const Moment moment(path, s);
  const auto exact = [&](double x) -> Vector3d {
    std::size_t i = 1;
    while (i + 1 < on.w.size() && sign * (x - on.w[i]) > 0) ++i;
    const double fraction = (x - on.w[i - 1]) / (on.w[i] - on.w[i - 1]);
    const auto v = map.solve(x, on.v[i - 1] + fraction * (on.v[i] - on.v[i - 1]), moment);
    if (!v) return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return moment.placement.apply(rails->at(x, *v).at);
  };
  return curveOf(exact, {on.w.front(), on.w.back()}, bound);
}

}  // namespace swept::step
