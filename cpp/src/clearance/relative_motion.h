// Two bodies that both move: the motion of one as seen from the other, and where one is when.
// In:    timed motions that are interpolated between their poses; boxes of the bodies. Units: mm,
// s. Out:   a hierarchy over the relative motion (motion_tree.h), so that every search for one
// moving
//        body serves two: the frame is that of the second body, and moves with it.
// Cost:  O(n) for the n joined times of both motions, O(log n) for a moment.
// Why it is certain: between two joined times both bodies follow one step each, with constant
// turning speeds. In the moving frame a point's velocity is the difference of both velocity fields,
// and its acceleration at most w1^2 r1 + w2^2 r2 + 2 w2 v (centripetal of each, Coriolis), with r2
// the largest distance of the first body from the second one's turning line. That bounds how far
// the point leaves its tangent and its chord. Source: B. Mirtich, Impulse-based dynamic simulation
// (1996), 2.3; X. Zhang, S. Redon, M. Lee, Y. J. Kim, Continuous collision detection for
// articulated models (2007), section 4.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "clearance/motion_tree.h"
#include "swept/clearance.h"

namespace swept::clearance {

/// A body's way over time. A body that stands still has one pose.
class TimedMotion {
 public:
  /// Poses with ascending times, none twice; interpolated unless there is one only. centre, half:
  /// box of the body in its own frame.
  TimedMotion(const Trajectory& trajectory, const Eigen::Vector3d& centre,
              const Eigen::Vector3d& half);

  bool moves() const { return times_.size() > 1; }
  /// Of the given poses; of a body that stands still, all times.
  TimeInterval span() const;
  /// Clamped to the ends of the span.
  Pose poseAt(double time) const;
  const Eigen::Vector3d& centre() const { return centre_; }
  const Eigen::Vector3d& half() const { return half_; }
  /// Of the poses.
  const std::vector<double>& times() const { return times_; }

  /// A part of one step.
  struct Slice {
    std::int32_t step = 0;
    double from = 0, to = 0;
    double at(double s) const { return from + s * (to - from); }
  };
  /// The step that holds the middle of [from, to], which lies between two successive times.
  Slice slice(double from, double to) const;
  const StepPath& path(const Slice& slice) const { return paths_[slice.step]; }
  /// Of the body's box about the line of the slice's step.
  double radius(const Slice& slice) const { return radii_[slice.step]; }
  /// mm: in the slice no point of the body leaves the chord of its ends by more.
  double bulge(const Slice& slice) const;

 private:
  std::int32_t stepAt(double time) const;

  Eigen::Vector3d centre_, half_;
  std::vector<double> times_;
  std::vector<StepPath> paths_;  ///< one that stays where it is for a body that stands still
  std::vector<double> radii_;
};

/// All times of both motions within the span, with its ends.
std::vector<double> joinedTimes(const TimedMotion& a, const TimedMotion& b,
                                const TimeInterval& span);

/// The placement of a as seen from b.
Pose seenFrom(const Pose& a, const Pose& b);

/// Hierarchy over the motion of `body` as seen from `frame`, at the given times (two or more) and
/// between them. Both must outlive it.
MotionTree relativeMotion(const TimedMotion& body, const TimedMotion& frame,
                          const std::vector<double>& times);

/// mm, how far a corner of the body's box comes from where it is first, as seen from `frame`, at
/// the given times.
double relativeTravel(const TimedMotion& body, const TimedMotion& frame,
                      const std::vector<double>& times);

}  // namespace swept::clearance
