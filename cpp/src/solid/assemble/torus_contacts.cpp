// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/torus_contacts.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "solid/assemble/regular_times.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Complex = std::complex<double>;

bool isAllAround(Range angles) { return angles.length() >= 2 * M_PI; }

// Returns whether the direction of the velocity of a sphere's centre changes little.
bool hasOneDirection(const BodySurface& sphere, const StepPath& path, Range within) {
  constexpr int kTimes = 16;
  // If the direction turns by 68 degrees, the grazing surface needs too many poles.
  constexpr double kMinCosine = 0.7;
  const auto direction = [&](double s) {
    return Moment(path, s).velocityAt(sphere.origin).normalized();
  };
  const Vector3d axis = direction(within.at(0.5));
  for (int i = 0; i <= kTimes; ++i) {
    const double s = within.at(static_cast<double>(i) / kTimes);
    if (!(direction(s).dot(axis) > kMinCosine)) return false;
  }
  return true;
}

// Returns a sphere with another axis: the direction of the velocity of its centre, if this changes
// little.
BodySurface turnedToVelocity(BodySurface surface, const StepPath& path, Range within) {
  if (!hasOneDirection(surface, path, within)) return surface;
  surface.axis = Moment(path, within.at(0.5)).velocityAt(surface.origin).normalized();
  surface.x = surface.axis.unitOrthogonal();
  surface.y = surface.axis.cross(surface.x);
  return surface;
}

}  // namespace

std::vector<Range> TorusContacts::timesOf(const BodySurface& surface, const StepPath& path) {
  constexpr double kShortestRange = 1.0 / 16;
  std::vector<Range> times{{0, 1}};
  for (std::size_t i = 0; i < times.size();) {
    const Range s = times[i];
    if (surface.radius > 0 || s.length() <= kShortestRange || hasOneDirection(surface, path, s)) {
      ++i;
      continue;
    }
    times[i] = {s.from, s.at(0.5)};
    times.insert(times.begin() + static_cast<std::ptrdiff_t>(i) + 1, {s.at(0.5), s.to});
  }
  return times;
}

TorusContacts::TorusContacts(const BodyGeometry& body, int index, const StepPath& path,
                             Range within)
    : surface_(body.surfaces[index]), path_(path), within_(within) {
  if (surface_.radius == 0) surface_ = turnedToVelocity(surface_, path, within);
  across_ = surface_.axis.cross(Moment(path, 0).angular);
  scale_ = surface_.radius + surface_.tube;
  for (const double sign : {1.0, -1.0}) {
    if (const auto on = anglesOnFaces(body, index, sign)) findCurves(sign, *on);
  }
}

Vector3d TorusContacts::onTube(double sign, double angle, double s) const {
  const Vector3d velocity = Moment(path_, s).velocityAt(surface_.origin);
  const Vector3d away = std::cos(angle) * surface_.x + std::sin(angle) * surface_.y;
  const Vector2d direction =
      sign * Vector2d(velocity.dot(surface_.axis) + surface_.radius * away.dot(across_),
                      -away.dot(velocity))
                 .normalized();
  // Of a sphere, a point behind the axis belongs to the opposite angle.
  const double distance = surface_.radius + surface_.tube * direction.x();
  if (surface_.radius == 0 && distance < 0) return Vector3d::Constant(NAN);
  return surface_.origin + distance * away + surface_.tube * direction.y() * surface_.axis;
}

std::optional<Range> TorusContacts::anglesOnFaces(const BodyGeometry& body, int index,
                                                  double sign) const {
  constexpr int kAngles = 96, kTimes = 16;
  constexpr double kLarger = 1.05;  // times the face
  struct Extent {
    const BodySurface* surface;
    Eigen::AlignedBox2d range;
  };
  std::vector<Extent> extents;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    if (body.faces[f].surface == index)
      extents.push_back({&body.faces[f].own, body.faces[f].range});
  }
  const auto isOnFace = [&](double angle) {
    for (int i = 0; i <= kTimes; ++i) {
      const Vector3d p = onTube(sign, angle, within_.at(static_cast<double>(i) / kTimes));
      if (!p.allFinite()) continue;
      for (const Extent& extent : extents) {
        const Vector2d middle = extent.range.center(),
                       off = extent.surface->parametersOf(p, middle) - middle;
        if ((2 * off.cwiseAbs().array() <= kLarger * extent.range.sizes().array()).all())
          return true;
      }
    }
    return false;
  };
  int longest = 0, run = 0, end = 0;
  for (int i = 0; i < 2 * kAngles; ++i) {
    run = isOnFace(2 * M_PI * i / kAngles) ? 0 : run + 1;
    if (run <= longest) continue;
    longest = run;
    end = i;
  }
  if (longest == 0) return Range{0, 2 * M_PI};
  if (longest >= kAngles) return std::nullopt;
  return Range{2 * M_PI * end / kAngles, 2 * M_PI * (end - longest + 1 + kAngles) / kAngles};
}

std::array<TorusContacts::Bend, 2> TorusContacts::bendsAt(Range on, double s) const {
  constexpr double kFarthest = 20;  // rad
  const Vector3d velocity = Moment(path_, s).velocityAt(surface_.origin);
  // With z = e^(i angle), the zeros of p + i q are those of first z^2 + 2 along z + last.
  const double along = velocity.dot(surface_.axis);
  const Complex i(0, 1);
  const Complex x(surface_.radius * surface_.x.dot(across_), surface_.x.dot(velocity)),
      y(surface_.radius * surface_.y.dot(across_), surface_.y.dot(velocity));
  const Complex first = x - i * y, last = x + i * y;
  Complex root = std::sqrt(along * along - first * last);
  if (root.real() * along < 0) root = -root;
  const Complex larger = -(along + root);
  std::array<Bend, 2> bends;
  for (const int k : {0, 1}) {
    const Complex z = k == 0 ? larger / first : last / larger;
    const double width = std::abs(std::log(std::abs(z)));
    bends[k] = {angleNear(on.at(0.5), std::arg(z)),
                std::isfinite(width) ? std::min(width, kFarthest) : kFarthest};
    if (!std::isfinite(bends[k].at)) bends[k].at = on.at(0.5);
  }
  return bends;
}

// Positions on a curve at one time, in rad. They grow with the angle, the more where the curve
// bends.
class TorusContacts::Measure {
 public:
  Measure(const Curve& curve, const std::array<Bend, 2>& bends) : on_(curve.on), bends_(bends) {
    for (const int k : {0, 1}) {
      // Smooth where a bend jumps: if it leaves the range of angles within pi of the middle, it
      // returns at the other end; and a very wide one has no certain angle.
      const double near = (1 + std::cos(bends[k].at - on_.at(0.5))) / 2;
      const double wide = std::sinh(bends[k].width);
      weights_[k] = 2 * near * near * near / (1 + wide * wide * wide * wide * wide * wide);
    }
    if (curve.otherHalf == kNone) return;
    // The ends of halves always have the same positions.
    offset_ = positionAt(on_.from);
    scale_ = on_.length() / positionAt(on_.to);
  }

  double positionAt(double angle) const {
    double sum = angle;
    for (const int k : {0, 1})
      sum += weights_[k] * std::asinh((angle - bends_[k].at) / bends_[k].width);
    return scale_ * (sum - offset_);
  }
  double angleAt(double position) const {
    // Newton's method, and halving where that is slow.
    constexpr int kRounds = 100;
    constexpr double kSame = 1e-14;  // rad; rounding prevents smaller steps
    Range range{on_.from - M_PI, on_.to + M_PI};
    double angle = on_.at(0.5), before = HUGE_VAL;
    for (int round = 0; round < kRounds; ++round) {
      const double off = (positionAt(angle) - position) / scale_;
      (off > 0 ? range.to : range.from) = angle;
      double slope = 1;
      for (const int k : {0, 1})
        slope += weights_[k] / std::hypot(angle - bends_[k].at, bends_[k].width);
      double next = angle - off / slope;
      if (std::abs(next - angle) <= kSame * (1 + std::abs(angle))) return next;
      const bool isSlow = std::abs(off) > before / 2;
      if (isSlow || !(next > range.from && next < range.to)) next = range.at(0.5);
      before = isSlow ? HUGE_VAL : std::abs(off);
      angle = next;
    }
    return angle;
  }

 private:
  Range on_;
  double offset_ = 0, scale_ = 1;
  std::array<Bend, 2> bends_;
  std::array<double, 2> weights_;
};

Range TorusContacts::extent(int curve) const {
  constexpr int kTimes = 64;
  const Curve& of = curves_[curve];
  if (of.otherHalf != kNone) return {0, scale_ * of.on.length()};
  Range positions{HUGE_VAL, -HUGE_VAL};
  for (int i = 0; i <= kTimes; ++i) {
    const Measure measure(of, bendsAt(of.on, of.s.at(static_cast<double>(i) / kTimes)));
    for (const double end : {of.on.from, of.on.to})
      positions = positions.with(scale_ * measure.positionAt(end));
  }
  return positions;
}

Vector3d TorusContacts::at(int curve, double w, double s) const {
  const Curve& of = curves_[curve];
  return onTube(of.sign, Measure(of, bendsAt(of.on, s)).angleAt(w / scale_), s);
}

double TorusContacts::positionAt(int curve, const Vector3d& p, double s) const {
  const Curve& of = curves_[curve];
  const double angle = surface_.parametersOf(p, {of.on.at(0.5), 0}).x();
  return scale_ * Measure(of, bendsAt(of.on, s)).positionAt(angle);
}

Vector3d TorusContacts::atAngleOf(int curve, const Vector3d& p, double s) const {
  const Curve& of = curves_[curve];
  const double angle = surface_.parametersOf(p, {of.on.at(0.5), 0}).x();
  if (of.otherHalf != kNone && (angle < of.on.from || angle > of.on.to))
    return Vector3d::Constant(NAN);
  return onTube(of.sign, angle, s);
}

void TorusContacts::findCurves(double sign, Range on) {
  constexpr double kNear = 0.004;      // rad: narrower bends would need too many poles
  constexpr double kAroundFace = 0.3;  // rad: how far the surfaces may extend beyond the range
  const auto isRegular = [&](double s) {
    const auto bends = bendsAt(on, s);
    return std::none_of(bends.begin(), bends.end(), [&](const Bend& bend) {
      return bend.width < kNear && bend.at > on.from - kAroundFace && bend.at < on.to + kAroundFace;
    });
  };
  for (const Range& s : regularTimes(
           isRegular, [&](Range r) { return quickestChange(on, r); }, within_)) {
    const int next = static_cast<int>(curves_.size());
    if (isAllAround(on)) {
      curves_.push_back({sign, s, {on.from, on.at(0.5)}, next + 1});
      curves_.push_back({sign, s, {on.at(0.5), on.to}, next});
    } else {
      curves_.push_back({sign, s, on});
    }
  }
}

double TorusContacts::quickestChange(Range on, Range s) const {
  constexpr int kTimes = 64;
  constexpr double kStep = 1e-4;
  constexpr double kFar = 1.5;  // rad
  double quickest = HUGE_VAL;
  for (int i = 0; i <= kTimes; ++i) {
    const double t = s.at(static_cast<double>(i) / kTimes);
    const auto bends = bendsAt(on, t), after = bendsAt(on, t + kStep);
    for (const Bend& bend : bends) {
      const double beyond = std::max({0.0, on.from - bend.at, bend.at - on.to});
      if (std::hypot(bend.width, beyond) > kFar) continue;
      // Of the two bends after the time step, the one that this one has become.
      const auto movedTo = [&](const Bend& other) {
        return Vector2d(std::remainder(other.at - bend.at, 2 * M_PI), other.width - bend.width)
            .cwiseAbs()
            .eval();
      };
      const Vector2d first = movedTo(after[0]), second = movedTo(after[1]);
      const Vector2d moved = (first.norm() < second.norm() ? first : second) / kStep;
      quickest = std::min({quickest, bend.width / moved.y(), 1 / moved.x()});
      if (!isAllAround(on)) continue;
      // The ends of the halves have fixed positions.
      for (const double end : {on.from, on.at(0.5)}) {
        const double distance = std::hypot(std::remainder(bend.at - end, 2 * M_PI), bend.width);
        quickest = std::min(quickest, distance / moved.x());
      }
    }
  }
  return quickest;
}

}  // namespace swept::step
