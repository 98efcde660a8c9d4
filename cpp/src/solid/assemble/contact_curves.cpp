// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/contact_curves.h"

#include <algorithm>
#include <cmath>

#include "solid/assemble/regular_times.h"

namespace swept::step {

using Eigen::Vector3d;
using Kind = BodySurface::Kind;

ContactCurves::ContactCurves(const BodyGeometry& body, int index, const StepPath& path)
    : surface_(body.surfaces[index]),
      path_(path),
      origin_(surface_.origin),
      along_(surface_.axis),
      // The angular velocity is constant in coordinates of the body.
      across_(surface_.axis.cross(Moment(path, 0).angular)),
      size_(across_.norm()) {
  switch (surface_.kind) {
    case Kind::Plane:
      origin_ = surface_.footOfOrigin();
      if (size_ <= kNoSpeed) return;
      curves_.resize(1);
      across_ /= size_;
      along_ = across_.cross(surface_.axis);
      break;
    case Kind::Cylinder:
      origin_ = surface_.footOfOrigin();
      break;
    case Kind::Cone:
      break;
    case Kind::Torus:
      for (const Range& s : TorusContacts::timesOf(surface_, path)) {
        tori_.push_back({count(), TorusContacts(body, index, path, s)});
        const TorusContacts& torus = tori_.back().contacts;
        for (std::size_t i = 0; i < torus.count(); ++i)
          curves_.push_back({Course::Whole, 1, torus.times(static_cast<int>(i))});
      }
      findChanges();
      return;
    case Kind::Other:
      return;
  }
  extent_ = extentOf(body, index);
  if (!surface_.isPlane()) findCurves();
}

ContactCurves::Circles ContactCurves::circlesAt(double s) const {
  const Vector3d velocity = Moment(path_, s).velocityAt(origin_);
  const double along = velocity.dot(surface_.axis), sine = std::sin(surface_.slope);
  Circles circles{along,
                  std::cos(surface_.slope) * (velocity - along * surface_.axis) -
                      surface_.radius * sine * across_,
                  {0, 0}};
  if (size_ <= kNoSpeed) {  // all circles are alike
    const bool doTouch = circles.first.norm() > std::abs(along * sine);
    circles.gap = {-HUGE_VAL, doTouch ? -HUGE_VAL : HUGE_VAL};
    return circles;
  }
  // |m|^2 - (e a.linear)^2 = size_^2 ((w - middle)^2 - square)
  const double middle = circles.first.dot(across_) / (size_ * size_);
  const double square =
      (along * along * sine * sine - onCircle(circles, middle).squaredNorm()) / (size_ * size_);
  const double half = std::sqrt(std::max(0.0, square));
  circles.gap = {middle - half, middle + half};
  if (square <= 0) circles.distance = std::sqrt(-square);
  return circles;
}

Range ContactCurves::wideExtent() const {
  constexpr double kWide = 0.1;  // mm, and fraction of the extent
  const double margin = kWide * (1 + extent_.length());
  return {extent_.from - margin, extent_.to + margin};
}

ContactCurves::Turn ContactCurves::turnOf(Course course, const Circles& circles) const {
  constexpr double kWider = 0.1;  // of the extent with its margin
  const Range left = wideExtent().grown(kWider);
  if (course == Course::Above) return {circles.gap.to, circles.gap.from, left.to - circles.gap.to};
  return {circles.gap.from, circles.gap.to, left.from - circles.gap.from};
}

Range ContactCurves::spreadOf(const Circles& circles) const {
  return {std::asinh((extent_.from - circles.gap.from) / circles.distance),
          std::asinh((extent_.to - circles.gap.from) / circles.distance)};
}

double ContactCurves::distanceToZero(const Circles& circles) const {
  const double w = circles.gap.from;
  return std::hypot(circles.distance, std::max({0.0, extent_.from - w, w - extent_.to}));
}

bool ContactCurves::needsSpread(Range s) const {
  constexpr int kTimes = 64;
  constexpr double kFar = 0.5;  // of the extent
  double nearest = HUGE_VAL;
  for (int i = 0; i <= kTimes; ++i) {
    const Circles circles = circlesAt(s.at(static_cast<double>(i) / kTimes));
    if (circles.distance == HUGE_VAL) return false;
    nearest = std::min(nearest, distanceToZero(circles));
  }
  return nearest < kFar * extent_.length();
}

bool ContactCurves::isRegular(Course course, double s) const {
  // Of the extent: nearer to a place where four curves meet, they would need too many poles.
  constexpr double kNear = 0.002;
  const Circles circles = circlesAt(s);
  const Range& gap = circles.gap;
  const Range wide = wideExtent();
  const double near = kNear * wide.length();
  const auto isWithin = [&](double w) { return w > wide.from && w < wide.to; };
  switch (course) {
    case Course::Whole:
      if (circles.distance < HUGE_VAL) return !isWithin(gap.from) || circles.distance > near;
      return gap.to <= wide.from || gap.from >= wide.to;
    case Course::Above:
      return gap.length() > near && isWithin(gap.to);
    case Course::Below:
      return gap.length() > near && isWithin(gap.from);
  }
  return false;
}

void ContactCurves::findCurves() {
  for (const Course course : {Course::Whole, Course::Above, Course::Below}) {
    const auto times = regularTimes([&](double s) { return isRegular(course, s); },
                                    [&](Range s) { return quickestChange(course, s); });
    for (const Range& s : times) {
      const bool isSpread = course == Course::Whole && needsSpread(s);
      curves_.push_back({course, 1, s, isSpread});
      if (course == Course::Whole) curves_.push_back({course, -1, s, isSpread});
    }
  }
  findChanges();
}

void ContactCurves::findChanges() {
  for (const Curve& curve : curves_) changes_.insert(changes_.end(), {curve.s.from, curve.s.to});
  std::sort(changes_.begin(), changes_.end());
  changes_.erase(std::unique(changes_.begin(), changes_.end()), changes_.end());
}

double ContactCurves::quickestChange(Course course, Range s) const {
  constexpr int kTimes = 64;
  constexpr double kStep = 1e-4;
  double least = HUGE_VAL;
  if (course != Course::Whole) return least;
  for (int i = 0; i <= kTimes && size_ > kNoSpeed; ++i) {
    const double t = s.at(static_cast<double>(i) / kTimes);
    const Circles circles = circlesAt(t), after = circlesAt(t + kStep);
    if (circles.distance == HUGE_VAL) continue;
    const double speed = std::abs(after.gap.from - circles.gap.from) / kStep;
    least = std::min(least, distanceToZero(circles) / speed);
  }
  return least;
}

Vector3d ContactCurves::onCircles(const Curve& curve, double w, double s) const {
  const Circles circles = circlesAt(s);
  const double c = std::cos(surface_.slope), e = -std::sin(surface_.slope);
  double position = w, root;
  if (curve.course == Course::Whole) {
    if (curve.isSpread) {
      const double part = (w - extent_.from) / extent_.length();
      position = circles.gap.from + circles.distance * std::sinh(spreadOf(circles).at(part));
    }
    const double limit = e * circles.speedAlong;
    root = curve.sign * std::sqrt(onCircle(circles, position).squaredNorm() - limit * limit);
  } else {
    const Turn turn = turnOf(curve.course, circles);
    const double part = w / extent_.length();
    position = turn.at + part * part * turn.length;
    root = part * size_ * std::sqrt(turn.length * (position - turn.other));
  }
  const Vector3d m = onCircle(circles, position);
  const Vector3d away =
      (root * surface_.axis.cross(m) - e * circles.speedAlong * m) / m.squaredNorm();
  return origin_ + position * c * surface_.axis + (surface_.radius - position * e) * away;
}

Vector3d ContactCurves::at(int curve, double w, double s) const {
  if (!tori_.empty()) {
    const auto [torus, own] = torusOf(curve);
    return torus.at(own, w, s);
  }
  if (!surface_.isPlane()) return onCircles(curves_[curve], w, s);
  const Moment moment(path_, s);
  return origin_ + w * along_ - surface_.axis.dot(moment.linear) / size_ * across_;
}

double ContactCurves::positionOnTurn(Course course, const Vector3d& p, double s) const {
  const Circles circles = circlesAt(s);
  const Turn turn = turnOf(course, circles);
  const double position = (p - origin_).dot(along_) / std::cos(surface_.slope);
  const double root =
      surface_.awayFromAxis(p).dot(surface_.axis.cross(onCircle(circles, position)));
  return extent_.length() * root / (size_ * std::sqrt(turn.length * (position - turn.other)));
}

double ContactCurves::positionAt(int curve, const Vector3d& p, double s) const {
  if (!tori_.empty()) {
    const auto [torus, own] = torusOf(curve);
    return torus.positionAt(own, p, s);
  }
  const Course course = curves_[curve].course;
  if (course != Course::Whole) return positionOnTurn(course, p, s);
  const double along = (p - origin_).dot(along_) / std::cos(surface_.slope);
  if (!curves_[curve].isSpread) return along;
  const Circles circles = circlesAt(s);
  const Range spread = spreadOf(circles);
  const double place = std::asinh((along - circles.gap.from) / circles.distance);
  return extent_.from + (place - spread.from) / spread.length() * extent_.length();
}

int ContactCurves::curveOf(const Vector3d& p, double s) const {
  if (surface_.isPlane()) return count() - 1;
  const auto distance = [&](int curve) {
    Vector3d there;
    if (tori_.empty()) {
      there = at(curve, positionAt(curve, p, s), s);
    } else {
      const auto [torus, own] = torusOf(curve);
      there = torus.atAngleOf(own, p, s);
    }
    return there.allFinite() ? (there - p).norm() : HUGE_VAL;
  };
  int nearest = kNoCurve;
  double least = HUGE_VAL;
  for (int curve = 0; curve < count(); ++curve) {
    if (s < times(curve).from || s > times(curve).to) continue;
    const double d = distance(curve);
    if (d >= least) continue;
    least = d;
    nearest = curve;
  }
  return nearest;
}

Range ContactCurves::extent(int curve) const {
  if (!tori_.empty()) {
    const auto [torus, own] = torusOf(curve);
    return torus.extent(own);
  }
  if (curves_[curve].course == Course::Whole) return extent_;
  return {-extent_.length(), extent_.length()};
}

int ContactCurves::otherHalf(int curve) const {
  if (tori_.empty()) return kNoCurve;
  const auto [torus, own] = torusOf(curve);
  const int other = torus.otherHalf(own);
  return other == TorusContacts::kNone ? kNoCurve : curve - own + other;
}

std::pair<const TorusContacts&, int> ContactCurves::torusOf(int curve) const {
  std::size_t k = tori_.size() - 1;
  while (tori_[k].first > curve) --k;
  return {tori_[k].contacts, curve - tori_[k].first};
}

Range ContactCurves::extentOf(const BodyGeometry& body, int index) const {
  constexpr int kPoints = 32;
  Range w{HUGE_VAL, -HUGE_VAL};
  for (const BodyFace& face : body.faces) {
    if (face.surface != index) continue;
    for (const int e : face.edges) {
      const BodyEdge& edge = body.edges[e];
      for (int i = 0; i <= kPoints; ++i)
        w = w.with(
            (edge.at(edge.range.at(static_cast<double>(i) / kPoints)) - origin_).dot(along_));
    }
  }
  const double c = std::cos(surface_.slope);
  return {w.from / c, w.to / c};
}

}  // namespace swept::step
