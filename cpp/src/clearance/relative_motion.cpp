// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/relative_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

// Steps between successive joined times. Each step lies within one step of the body and one step of
// the frame.
class RelativeSteps : public MotionSteps {
 public:
  RelativeSteps(const TimedMotion& body, const TimedMotion& frame, const std::vector<double>& times)
      : body_(body), frame_(frame) {
    steps_.reserve(times.size() - 1);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      Step step{times[i], times[i + 1], body.slice(times[i], times[i + 1]),
                frame.slice(times[i], times[i + 1])};
      measure(step);
      steps_.push_back(step);
    }
  }

  Pose poseAt(std::int64_t i, double s) const override {
    const Step& step = steps_[i];
    Pose pose = seenFrom(body_.path(step.body).poseAt(step.body.at(s)),
                         frame_.path(step.frame).poseAt(step.frame.at(s)));
    pose.timeSeconds = step.from + s * (step.to - step.from);
    return pose;
  }

  Flow flowAt(std::int64_t i, double s) const override {
    const Step& step = steps_[i];
    const StepPath& a = body_.path(step.body);
    const StepPath& b = frame_.path(step.frame);
    const Pose own = a.poseAt(step.body.at(s));
    const Pose other = b.poseAt(step.frame.at(s));
    const double rateA = step.body.to - step.body.from;
    const double rateB = step.frame.to - step.frame.from;
    const Twist first = a.twistAt(own);
    const Twist second = b.twistAt(other);
    const Vector3d angular = rateA * first.angular - rateB * second.angular;
    const Vector3d linear = rateA * first.linear - rateB * second.linear;
    const Eigen::Quaterniond back = other.rotation.conjugate();
    Flow flow{seenFrom(own, other), {}, step.fastest};
    flow.twist = {back * Vector3d(linear + angular.cross(other.translation)), back * angular};
    return flow;
  }

  double bulge(std::int64_t i) const override { return steps_[i].bulge; }

 private:
  struct Step {
    double from, to;  // in seconds
    TimedMotion::Slice body, frame;
    double fastest = 0;
    double bulge = 0;
  };

  // Sets bounds that hold for the whole step. Speeds are in mm or rad per step.
  void measure(Step& step) const {
    const StepPath& a = body_.path(step.body);
    const StepPath& b = frame_.path(step.frame);
    const double rateA = step.body.to - step.body.from;
    const double rateB = step.frame.to - step.frame.from;
    const double own = rateA * a.fastest(body_.radius(step.body));
    const double drift = rateB * b.drift();
    // The rotation of the frame does not change the distance of a point from the frame's axis. So
    // only the motion of the body and the drift along the axis can increase this distance.
    const Pose middle = seenFrom(a.poseAt(step.body.at(0.5)), b.poseAt(step.frame.at(0.5)));
    double reach = 0;
    forCorners(body_.centre(), body_.half(), [&](const Vector3d& c) {
      reach = std::max(reach, b.radius(middle.rotation * c + middle.translation));
    });
    reach += 0.5 * (own + drift);
    const double turnA = rateA * a.angle();
    const double turnB = rateB * b.angle();
    step.fastest = own + drift + turnB * reach;
    step.bulge = (turnA * turnA * body_.radius(step.body) + turnB * turnB * reach +
                  2 * turnB * step.fastest) /
                 8;
  }

  const TimedMotion& body_;
  const TimedMotion& frame_;
  std::vector<Step> steps_;
};

}  // namespace

TimedMotion::TimedMotion(const Trajectory& trajectory, const Vector3d& centre, const Vector3d& half)
    : centre_(centre), half_(half) {
  const auto& poses = trajectory.poses;
  for (const Pose& pose : poses) times_.push_back(pose.timeSeconds);
  const std::size_t steps = std::max<std::size_t>(poses.size(), 2) - 1;
  for (std::size_t i = 0; i < steps; ++i) {
    paths_.emplace_back(poses[i], poses[std::min(i + 1, poses.size() - 1)],
                        trajectory.interpolation);
    radii_.push_back(largestRadius(paths_.back(), centre, half));
  }
}

TimeInterval TimedMotion::span() const {
  if (moves()) return {times_.front(), times_.back()};
  constexpr double kAlways = std::numeric_limits<double>::infinity();
  return {-kAlways, kAlways};
}

std::int32_t TimedMotion::stepAt(double time) const {
  if (!moves()) return 0;
  const auto after = std::upper_bound(times_.begin(), times_.end(), time);
  return static_cast<std::int32_t>(
      std::clamp<std::ptrdiff_t>(after - times_.begin() - 1, 0, std::ssize(paths_) - 1));
}

TimedMotion::Slice TimedMotion::slice(double from, double to) const {
  if (!moves()) return {};
  const std::int32_t step = stepAt(from + 0.5 * (to - from));
  const double start = times_[step];
  const double length = times_[step + 1] - start;
  return {step, std::clamp((from - start) / length, 0.0, 1.0),
          std::clamp((to - start) / length, 0.0, 1.0)};
}

Pose TimedMotion::poseAt(double time) const {
  Pose pose;
  if (moves()) {
    const Slice at = slice(time, time);
    pose = path(at).poseAt(at.from);
  } else {
    pose = paths_.front().poseAt(0);
  }
  pose.timeSeconds = time;
  return pose;
}

double TimedMotion::bulge(const Slice& slice) const {
  const double turn = (slice.to - slice.from) * path(slice).angle();
  return turn * turn * radius(slice) / 8;
}

std::vector<double> joinedTimes(const TimedMotion& a, const TimedMotion& b,
                                const TimeInterval& span) {
  std::vector<double> times{span.from, span.to};
  for (const TimedMotion* motion : {&a, &b}) {
    if (!motion->moves()) continue;
    for (const double time : motion->times())
      if (time > span.from && time < span.to) times.push_back(time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Pose seenFrom(const Pose& a, const Pose& b) {
  const Eigen::Quaterniond back = b.rotation.conjugate();
  return {a.timeSeconds, (back * a.rotation).normalized(),
          back * Vector3d(a.translation - b.translation)};
}

MotionTree relativeMotion(const TimedMotion& body, const TimedMotion& frame,
                          const std::vector<double>& times) {
  auto steps = std::make_unique<RelativeSteps>(body, frame, times);
  std::vector<Pose> poses;
  poses.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    poses.push_back(i + 1 < times.size() ? steps->poseAt(std::int64_t(i), 0)
                                         : steps->poseAt(std::int64_t(i) - 1, 1));
  return MotionTree(std::move(poses), std::move(steps), body.centre(), body.half());
}

double relativeTravel(const TimedMotion& body, const TimedMotion& frame,
                      const std::vector<double>& times) {
  double travel = 0;
  const Pose first = seenFrom(body.poseAt(times.front()), frame.poseAt(times.front()));
  for (const double time : times) {
    const Pose pose = seenFrom(body.poseAt(time), frame.poseAt(time));
    forCorners(body.centre(), body.half(), [&](const Vector3d& c) {
      const Vector3d moved =
          (pose.rotation * c + pose.translation) - (first.rotation * c + first.translation);
      travel = std::max(travel, moved.norm());
    });
  }
  return travel;
}

}  // namespace swept::clearance
