// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/pipe_contacts.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "solid/assemble/regular_times.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Complex = std::complex<double>;

constexpr int kJointsOfOne = 4;  // of one window: at both ends, of both curves

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
  if (surface.isCylinder() || surface.radius > 0 || !hasOneDirection(surface, path, within))
    return surface;
  surface.axis = Moment(path, within.at(0.5)).velocityAt(surface.origin).normalized();
  surface.x = surface.axis.unitOrthogonal();
  surface.y = surface.axis.cross(surface.x);
  return surface;
}

}  // namespace

std::vector<Range> PipeContacts::timesOf(const BodySurface& surface, const StepPath& path) {
  constexpr double kShortestRange = 1.0 / 16;
  std::vector<Range> times{{0, 1}};
  for (std::size_t i = 0; i < times.size();) {
    const Range s = times[i];
    if (surface.isCylinder() || surface.radius > 0 || s.length() <= kShortestRange ||
        hasOneDirection(surface, path, s)) {
      ++i;
      continue;
    }
    times[i] = {s.from, s.at(0.5)};
    times.insert(times.begin() + static_cast<std::ptrdiff_t>(i) + 1, {s.at(0.5), s.to});
  }
  return times;
}

PipeContacts::PipeContacts(const BodyGeometry& body, int index, const StepPath& path, Range within)
    : pipe_(turnedToVelocity(body.surfaces[index], path, within)), path_(path), within_(within) {
  constexpr double kAround = 0.3;  // units beside the faces where circles matter
  const std::array<std::optional<Range>, 2> on{positionsOnFaces(body, index, 1),
                                               positionsOnFaces(body, index, -1)};
  if (!on[0] && !on[1]) return;
  const Range both = on[0] && on[1] ? joined(*on[0], *on[1]) : on[0].value_or(*on[1]);
  if (pipe_.isCylinder()) unit_ = both.length() / M_PI;
  if (!pipe_.isSphere()) {
    const Range wide{both.from - kAround * unit_, both.to + kAround * unit_};
    criticals_ = CriticalCircle::find(pipe_, path_, wide, within_, isAllAround(both));
  }
  if (pipe_.isCylinder() && criticals_.empty()) return;
  std::vector<double> ends{within.from, within.to};
  for (const CriticalCircle& critical : criticals_) {
    for (const double s : {critical.times().from, critical.times().to}) {
      if (s > within.from && s < within.to) ends.push_back(s);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Range s{ends[i], ends[i + 1]};
    if (!windowsAt(s.at(0.5)).empty()) {
      appendParts(both, s);
      continue;
    }
    for (const int k : {0, 1}) {
      if (on[k]) appendWhole(k == 0 ? 1 : -1, *on[k], s);
    }
  }
}

Range PipeContacts::joined(Range a, Range b) const {
  if (isAllAround(a)) return a;
  if (isAllAround(b)) return b;
  // The same angles may be given with a whole turn between.
  const double turn = pipe_.isCylinder() ? 0 : angleNear(a.at(0.5), b.at(0.5)) - b.at(0.5);
  const Range both = a.with(b.from + turn).with(b.to + turn);
  return isAllAround(both) ? Range{0, 2 * M_PI} : both;
}

std::vector<int> PipeContacts::windowsAt(double s) const {
  std::vector<int> windows;
  for (std::size_t k = 0; k < criticals_.size(); ++k) {
    const Range times = criticals_[k].times();
    if (times.from < s && times.to > s) windows.push_back(static_cast<int>(k));
  }
  return windows;
}

bool PipeContacts::isAllAround(Range on) const {
  return !pipe_.isCylinder() && on.length() >= 2 * M_PI;
}

Vector3d PipeContacts::onPipe(double sign, double x, double s) const {
  const Vector2d speeds = pipe_.speeds(x, Moment(path_, s));
  const Vector2d direction = sign * Vector2d(speeds.y(), -speeds.x()).normalized();
  // Of a sphere, a point behind the axis belongs to the opposite angle.
  if (pipe_.isSphere() && direction.x() < 0) return Vector3d::Constant(NAN);
  return pipe_.at(x, direction);
}

std::optional<Range> PipeContacts::positionsOnFaces(const BodyGeometry& body, int index,
                                                    double sign) const {
  constexpr int kAngles = 96, kTimes = 16;
  constexpr double kLarger = 1.05;  // times the face
  if (pipe_.isCylinder()) {
    const BodySurface& surface = body.surfaces[index];
    return body.extentOf(index, surface.footOfOrigin(), surface.axis).grown((kLarger - 1) / 2);
  }
  struct Extent {
    const BodySurface* surface;
    Eigen::AlignedBox2d range;
  };
  std::vector<Extent> extents;
  for (const BodyFace& face : body.faces) {
    if (face.surface == index) extents.push_back({&face.own, face.range});
  }
  const auto isOnFace = [&](double angle) {
    for (int i = 0; i <= kTimes; ++i) {
      const Vector3d p = onPipe(sign, angle, within_.at(static_cast<double>(i) / kTimes));
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

std::array<PipeContacts::Bend, 2> PipeContacts::bendsAt(double middle, double s) const {
  const double farthest = 20 * unit_;
  const Moment moment(path_, s);
  const Complex i(0, 1);
  std::array<Complex, 2> zeros{Complex(NAN, NAN), Complex(NAN, NAN)};
  const Vector2d first = pipe_.speeds(0, moment);
  if (pipe_.isCylinder()) {
    const Vector2d change = pipe_.speedChanges(0, moment);
    zeros[0] = -(first.x() + i * first.y()) / (change.x() + i * change.y());
  } else {
    // At the angle a, the speeds are x.cos(a) + y.sin(a), and along + the same with other x and y.
    const Vector2d second = pipe_.speeds(M_PI / 2, moment), third = pipe_.speeds(M_PI, moment);
    const double along = (first.y() + third.y()) / 2;
    // With z = e^(i a), the zeros are those of minus z^2 + 2 along z + plus.
    const Complex x(first.y() - along, first.x()), y(second.y() - along, second.x());
    const Complex minus = x - i * y, plus = x + i * y;
    Complex root = std::sqrt(along * along - minus * plus);
    if (root.real() * along < 0) root = -root;
    const Complex larger = -(along + root);
    for (const int k : {0, 1}) {
      const Complex z = k == 0 ? larger / minus : plus / larger;
      zeros[k] = Complex(angleNear(middle, std::arg(z)), std::log(std::abs(z)));
    }
  }
  std::array<Bend, 2> bends;
  for (const int k : {0, 1}) {
    const double at = zeros[k].real(), width = std::abs(zeros[k].imag());
    bends[k] = {std::isfinite(at) ? at : middle,
                std::isfinite(width) ? std::min(width, farthest) : farthest};
  }
  return bends;
}

std::vector<PipeContacts::Bend> PipeContacts::bendsBeside(const Curve& curve, double s) const {
  std::vector<Bend> beside;
  const std::vector<int> windows = windowsAt(curve.s.at(0.5));
  for (const Bend& bend : bendsAt(curve.on(s).at(0.5), s)) {
    const bool isInside = std::any_of(windows.begin(), windows.end(), [&](int k) {
      return std::abs(criticals_[k].offsetOf(bend.at, s)) <= 1;
    });
    if (!isInside) beside.push_back(bend);
  }
  return beside;
}

double PipeContacts::beyond(Range on, const Bend& bend) const {
  const double smooth = 0.05 * unit_;
  const double off = std::max(on.from - bend.at, bend.at - on.to);
  return (off + std::hypot(off, smooth)) / 2;
}

// Positions on a curve at one time, in units of x. They grow with x, the more where the curve
// bends.
class PipeContacts::Measure {
 public:
  Measure(const PipeContacts& of, const Curve& curve, double s)
      : on_(curve.on(s)), unit_(of.unit_) {
    const bool isBeside = curve.critical == kNone && curve.isPart;
    const bool isHalf = isBeside && !curve.from.isMoving() && !curve.to.isMoving();
    const double middle = on_.at(0.5);
    const auto add = [&](Bend bend, double near) {
      // The farther a bend is beyond the ends, the less quickly the curve changes there. (Beyond
      // the end of a half, the other half goes on.)
      if (!isHalf) bend.width = std::hypot(bend.width, of.beyond(on_, bend));
      const double wide = std::sinh(bend.width / unit_);
      terms_.push_back(
          {bend, 2 * unit_ * near * near * near / (1 + wide * wide * wide * wide * wide * wide)});
    };
    // Smooth where a bend jumps: if it leaves the range of angles within pi of the middle, it
    // returns at the other end; and a very wide one has no certain angle.
    const auto nearness = [&](const Bend& bend) {
      return of.pipe_.isCylinder() ? 1 : (1 + std::cos(bend.at - middle)) / 2;
    };
    if (isBeside) {
      for (const Bend& bend : of.bendsBeside(curve, s)) add(bend, nearness(bend));
    } else {
      for (const Bend& bend : of.bendsAt(middle, s)) add(bend, nearness(bend));
    }
    if (isBeside) {
      // What bends in the window of a critical circle.
      for (const End* end : {&curve.from, &curve.to}) {
        if (!end->isMoving()) continue;
        const double width = of.criticals_[end->joint / kJointsOfOne].positions(s).length() / 2;
        add({end->at(s) + (end == &curve.from ? -width : width), width}, 1);
      }
    }
    // The ends always have the same positions.
    offset_ = positionAt(on_.from);
    scale_ = curve.on(curve.s.at(0.5)).length() / positionAt(on_.to);
  }

  double positionAt(double x) const {
    double sum = x;
    for (const auto& [bend, weight] : terms_)
      sum += weight * std::asinh((x - bend.at) / bend.width);
    return scale_ * (sum - offset_);
  }
  double xAt(double position) const {
    // Newton's method, and halving where that is slow.
    constexpr int kRounds = 100;
    constexpr double kSame = 1e-14;  // units; rounding prevents smaller steps
    Range range{on_.from - M_PI * unit_, on_.to + M_PI * unit_};
    double x = on_.at(0.5), before = HUGE_VAL;
    for (int round = 0; round < kRounds; ++round) {
      const double off = (positionAt(x) - position) / scale_;
      (off > 0 ? range.to : range.from) = x;
      double slope = 1;
      for (const auto& [bend, weight] : terms_)
        slope += weight / std::hypot(x - bend.at, bend.width);
      double next = x - off / slope;
      if (std::abs(next - x) <= kSame * (unit_ + std::abs(x))) return next;
      const bool isSlow = std::abs(off) > before / 2;
      if (isSlow || !(next > range.from && next < range.to)) next = range.at(0.5);
      before = isSlow ? HUGE_VAL : std::abs(off);
      x = next;
    }
    return x;
  }

 private:
  struct Term {
    Bend bend;
    double weight;
  };
  Range on_;
  double unit_, offset_ = 0, scale_ = 1;
  std::vector<Term> terms_;
};

Range PipeContacts::extent(int curve) const {
  const Curve& of = curves_[curve];
  return {0, pipe_.scale() * of.on(of.s.at(0.5)).length()};
}

bool PipeContacts::doesContinue(int curve, int next) const {
  const Curve &of = curves_[curve], &other = curves_[next];
  return of.to.joint != kNone && of.to.joint == other.from.joint && of.s.from < other.s.to &&
         other.s.from < of.s.to;
}

double PipeContacts::offsetFromEnd(int curve, bool isEnd, const Vector3d& p, double s) const {
  const double end = endOf(curve, isEnd).at(s);
  return pipe_.parametersOf(p, end).x() - end;
}

CriticalCircle::Quarter PipeContacts::quarterOf(int curve) const {
  const Curve& of = curves_[curve];
  return CriticalCircle::quarterOf(of.sign, of.s.at(0.5) > criticals_[of.critical].time());
}

Vector3d PipeContacts::at(int curve, double w, double s) const {
  const Curve& of = curves_[curve];
  return onPipe(of.sign, Measure(*this, of, s).xAt(w / pipe_.scale()), s);
}

double PipeContacts::positionAt(int curve, const Vector3d& p, double s) const {
  const Curve& of = curves_[curve];
  const double x = pipe_.parametersOf(p, of.on(s).at(0.5)).x();
  return pipe_.scale() * Measure(*this, of, s).positionAt(x);
}

Vector3d PipeContacts::atPositionOf(int curve, const Vector3d& p, double s) const {
  const Curve& of = curves_[curve];
  const Range on = of.on(s);
  const double x = pipe_.parametersOf(p, on.at(0.5)).x();
  if (of.isPart && (x < on.from || x > on.to)) return Vector3d::Constant(NAN);
  return onPipe(of.sign, x, s);
}

void PipeContacts::appendWhole(double sign, Range on, Range within) {
  if (!isAllAround(on)) {
    appendRegular({sign, within, {on.from}, {on.to}}, within);
    return;
  }
  const std::size_t first = curves_.size();
  appendRegular({sign, within, {on.from}, {on.to}}, within);
  std::vector<Curve> halves;
  for (std::size_t i = first; i < curves_.size(); ++i) {
    const End start{on.from, 0, 0, joints_}, middle{on.at(0.5), 0, 0, joints_ + 1},
        end{on.to, 0, 0, joints_};
    joints_ += 2;
    halves.push_back({sign, curves_[i].s, start, middle, kNone, true});
    halves.push_back({sign, curves_[i].s, middle, end, kNone, true});
  }
  curves_.resize(first);
  curves_.insert(curves_.end(), halves.begin(), halves.end());
}

PipeContacts::End PipeContacts::endAt(const Window& window, bool isEnd, double sign) const {
  const CriticalCircle& critical = criticals_[window.critical];
  const double time = critical.time();
  const Range now = critical.positions(time), later = critical.positions(time + 1);
  const double x = (isEnd ? now.to : now.from) + window.turn;
  return {x, later.from - now.from, time,
          kJointsOfOne * window.critical + (isEnd ? 2 : 0) + (sign > 0 ? 1 : 0)};
}

std::vector<PipeContacts::Window> PipeContacts::windowsIn(Range on, double s) const {
  std::vector<Window> windows;
  for (const int k : windowsAt(s)) {
    const double at = criticals_[k].positions(s).at(0.5);
    const double turn = pipe_.isCylinder() ? 0 : angleNear(on.at(0.5), at) - at;
    windows.push_back({k, turn, at + turn});
  }
  std::sort(windows.begin(), windows.end(),
            [](const Window& a, const Window& b) { return a.at < b.at; });
  return windows;
}

void PipeContacts::appendInside(const Window& window, double sign, Range within) {
  const double time = criticals_[window.critical].time();
  Curve inside{sign, within, endAt(window, false, sign), endAt(window, true, sign), window.critical,
               true};
  if (time > within.from && time < within.to) {
    inside.s.to = time;
    curves_.push_back(inside);
    inside.s = {time, within.to};
  }
  curves_.push_back(inside);
}

void PipeContacts::appendParts(Range on, Range within) {
  constexpr double kShortest = 0.1;  // units
  const std::vector<Window> windows = windowsIn(on, within.at(0.5));
  for (const double sign : {1.0, -1.0}) {
    const auto appendBeside = [&](const End& from, const End& to) {
      const Curve part{sign, within, from, to, kNone, true};
      const double shortest = std::min(part.on(within.from).length(), part.on(within.to).length());
      if (shortest > 0) appendRegular(part, within);
    };
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const End start = endAt(windows[i], false, sign), end = endAt(windows[i], true, sign);
      const Range starts = start.during(within), ends = end.during(within);
      // The first and the last part end where the faces do, or at a distance from the window.
      if (i == 0 && !isAllAround(on) && starts.to > on.from)
        appendBeside({std::min(on.from, starts.from - kShortest * unit_)}, start);
      appendInside(windows[i], sign, within);
      if (i + 1 < windows.size()) {
        appendBeside(end, endAt(windows[i + 1], false, sign));
      } else if (isAllAround(on)) {
        Window first = windows.front();
        first.turn += 2 * M_PI;
        appendBeside(end, endAt(first, false, sign));
      } else if (ends.from < on.to) {
        appendBeside(end, {std::max(on.to, ends.to + kShortest * unit_)});
      }
    }
  }
}

bool PipeContacts::isRegular(const Curve& curve, double s) const {
  constexpr double kNear = 0.004;      // units: narrower bends would need too many poles
  constexpr double kAroundFace = 0.3;  // units: how far the surfaces may extend beyond the range
  const Range on = curve.on(s);
  const auto bends = bendsBeside(curve, s);
  return std::none_of(bends.begin(), bends.end(), [&](const Bend& bend) {
    return bend.width < kNear * unit_ && bend.at > on.from - kAroundFace * unit_ &&
           bend.at < on.to + kAroundFace * unit_;
  });
}

void PipeContacts::appendRegular(const Curve& curve, Range within) {
  for (const Range& s : regularTimes([&](double time) { return isRegular(curve, time); },
                                     [&](Range r) { return quickestChange(curve, r); }, within)) {
    curves_.push_back(curve);
    curves_.back().s = s;
  }
}

double PipeContacts::quickestChange(const Curve& curve, Range s) const {
  constexpr int kTimes = 64;
  constexpr double kStep = 1e-4;
  constexpr double kFar = 1.5;  // units
  double quickest = HUGE_VAL;
  for (int i = 0; i <= kTimes; ++i) {
    const double t = s.at(static_cast<double>(i) / kTimes);
    const Range on = curve.on(t);
    const double middle = on.at(0.5);
    const auto bends = bendsBeside(curve, t);
    const auto after = bendsAt(middle, t + kStep);
    for (const Bend& bend : bends) {
      const double outside = std::max({0.0, on.from - bend.at, bend.at - on.to});
      if (std::hypot(bend.width, outside) > kFar * unit_) continue;
      // Of the two bends after the time step, the one that this one has become.
      const auto movedTo = [&](const Bend& other) {
        const double off = other.at - bend.at;
        return Vector2d(pipe_.isCylinder() ? off : std::remainder(off, 2 * M_PI),
                        other.width - bend.width)
            .cwiseAbs()
            .eval();
      };
      const Vector2d first = movedTo(after[0]), second = movedTo(after[1]);
      const Vector2d moved = (first.norm() < second.norm() ? first : second) / kStep;
      if (!isAllAround(on)) {
        const double width = std::hypot(bend.width, beyond(on, bend));
        quickest = std::min(quickest, width / moved.norm());
        continue;
      }
      quickest = std::min({quickest, bend.width / moved.y(), unit_ / moved.x()});
      // The ends of parts have fixed positions.
      for (const double end : {on.from, middle}) {
        const double distance = std::hypot(std::remainder(bend.at - end, 2 * M_PI), bend.width);
        quickest = std::min(quickest, distance / moved.x());
      }
    }
  }
  return quickest;
}

}  // namespace swept::step
