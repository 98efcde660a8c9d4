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
      for (const Range& s : PipeContacts::timesOf(surface_, path))
        appendPipe(PipeContacts(body, index, path, s));
      findChanges();
      return;
    case Kind::Other:
      return;
  }
  const double cosine = std::cos(surface_.slope);
  extent_ = body.extentOf(index, origin_, along_);
  extent_ = {extent_.from / cosine, extent_.to / cosine};
  if (surface_.isCylinder() && size_ > kNoSpeed) {
    PipeContacts contacts(body, index, path, {0, 1});
    if (contacts.count() > 0) {
      appendPipe(std::move(contacts));
      findChanges();
      return;
    }
  }
  if (!surface_.isPlane()) findCurves();
}

void ContactCurves::appendPipe(PipeContacts contacts) {
  for (int i = 0; i < static_cast<int>(contacts.count()); ++i)
    curves_.push_back({Course::Whole, 1, contacts.times(i), false, pipes_.size(), i});
  pipes_.push_back(std::move(contacts));
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
  if (!pipes_.empty()) {
    const auto [pipe, own] = pipeOf(curve);
    return pipe.at(own, w, s);
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
  if (!pipes_.empty()) {
    const auto [pipe, own] = pipeOf(curve);
    return pipe.positionAt(own, p, s);
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
    if (pipes_.empty()) {
      there = at(curve, positionAt(curve, p, s), s);
    } else {
      const auto [pipe, own] = pipeOf(curve);
      there = pipe.atPositionOf(own, p, s);
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
  if (!pipes_.empty()) {
    const auto [pipe, own] = pipeOf(curve);
    return pipe.extent(own);
  }
  if (curves_[curve].course == Course::Whole) return extent_;
  return {-extent_.length(), extent_.length()};
}

bool ContactCurves::isPart(int curve) const {
  if (pipes_.empty()) return false;
  const auto [pipe, own] = pipeOf(curve);
  return pipe.isPart(own);
}

bool ContactCurves::doesContinue(int curve, int next) const {
  if (pipes_.empty()) return false;
  const auto [pipe, own] = pipeOf(curve);
  const auto [nextPipe, nextOwn] = pipeOf(next);
  return &pipe == &nextPipe && pipe.doesContinue(own, nextOwn);
}

bool ContactCurves::isAtWindow(int curve, bool isEnd) const {
  if (pipes_.empty()) return false;
  const auto [pipe, own] = pipeOf(curve);
  return pipe.isAtWindow(own, isEnd);
}

double ContactCurves::offsetFromEnd(int curve, bool isEnd, const Vector3d& p, double s) const {
  const auto [pipe, own] = pipeOf(curve);
  return pipe.offsetFromEnd(own, isEnd, p, s);
}

std::optional<ContactCurves::Fan> ContactCurves::fanOf(int curve) const {
  if (pipes_.empty()) return std::nullopt;
  const auto [pipe, own] = pipeOf(curve);
  const int critical = pipe.criticalOf(own);
  if (critical == PipeContacts::kNone) return std::nullopt;
  return Fan{static_cast<int>(curves_[curve].pipe), critical, pipe.quarterOf(own)};
}

const CriticalCircle& ContactCurves::criticalOf(const Fan& fan) const {
  return pipes_[fan.pipe].criticals()[fan.critical];
}

Vector2d ContactCurves::scaleOf(const Fan& fan) const {
  return {pipeOf(fan).radius(), criticalOf(fan).times().length() / 2};
}

ContactCurves::Touch ContactCurves::at(const Fan& fan, const Vector2d& on) const {
  const Vector2d own = on.cwiseQuotient(scaleOf(fan));
  const auto place = criticalOf(fan).at(fan.quarter.half, own.x(), own.y());
  if (!std::isfinite(place.x)) return {Vector3d::Constant(NAN), 0};
  return {pipeOf(fan).at(place.x, Vector2d(std::cos(own.x()), std::sin(own.x()))), place.s};
}

Vector2d ContactCurves::parametersOf(const Fan& fan, const Vector3d& p, double s) const {
  const CriticalCircle& critical = criticalOf(fan);
  const Vector2d on = pipeOf(fan).parametersOf(p, critical.positions(s).at(0.5));
  return critical.parametersOf(fan.quarter.half, on.x(), on.y(), s).cwiseProduct(scaleOf(fan));
}

Eigen::AlignedBox2d ContactCurves::extent(const Fan& fan) const {
  const Range directions = criticalOf(fan).directions(fan.quarter.half),
              reach = CriticalCircle::reach(fan.quarter.isAfter);
  return {Vector2d(directions.from, reach.from).cwiseProduct(scaleOf(fan)),
          Vector2d(directions.to, reach.to).cwiseProduct(scaleOf(fan))};
}

bool ContactCurves::doesOwn(const Fan& fan, const Touch& touch, double slack) const {
  const CriticalCircle& critical = criticalOf(fan);
  const Range times = critical.times();
  const Range own =
      fan.quarter.isAfter ? Range{critical.time(), times.to} : Range{times.from, critical.time()};
  const double later = slack * times.length();
  if (touch.s < std::max(0.0, own.from) - later || touch.s > std::min(1.0, own.to) + later)
    return false;
  const double x = pipeOf(fan).parametersOf(touch.p, critical.positions(touch.s).at(0.5)).x();
  return std::abs(critical.offsetOf(x, touch.s)) <= 1 + slack;
}

}  // namespace swept::step
