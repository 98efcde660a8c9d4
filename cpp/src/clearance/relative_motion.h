// Computes the motion of a moving body as seen from another moving body.
// In:      timed motions that are interpolated between their poses, and the boxes of the bodies.
// Out:     a tree over the relative motion (motion_tree.h). With this tree, each search for one
//        moving body also works for two moving bodies: the frame of reference moves with the second
//        body.
// Units:   mm, s.
// Cost:    O(n) for the n joined times of both motions, O(log n) for the pose at one time.
// Why:     The bounds hold for every point. Between two joined times each body follows one step at
// constant angular speed. In the moving frame, the velocity of a point is the difference of both
// velocity fields. Its acceleration is at most w1^2 r1 + w2^2 r2 + 2 w2 v: two centripetal terms
// and the Coriolis term (w: angular speeds, v: speed in the moving frame). r1 and r2 are the
// largest distances of the first body from its own rotation axis and from that of the second body.
// The acceleration limits how far the point deviates from its tangent and from its chord.
// Source:  B. Mirtich, Impulse-based dynamic simulation (1996), 2.3; X. Zhang, S. Redon, M. Lee, Y.
//          J. Kim, Continuous collision detection for articulated models (2007), section 4.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "clearance/motion_tree.h"
#include "swept/clearance.h"

namespace swept::clearance {

/// Motion of a body over time. A body that stands still has only one pose.
class TimedMotion {
 public:
  /// The times of the poses must be strictly ascending. Two or more poses are interpolated.
  /// `centre` and `half` describe the box of the body in its own frame.
  TimedMotion(const Trajectory& trajectory, const Eigen::Vector3d& centre,
              const Eigen::Vector3d& half);

  bool moves() const { return times_.size() > 1; }
  /// Returns the time from the first to the last pose. For a body that stands still: all times.
  TimeInterval span() const;
  /// Returns the pose at a time, which is clamped to span().
  Pose poseAt(double time) const;
  const Eigen::Vector3d& centre() const { return centre_; }
  const Eigen::Vector3d& half() const { return half_; }
  /// Times of the poses.
  const std::vector<double>& times() const { return times_; }

  /// An interval of one step. `from` and `to` are fractions of the step, in [0, 1].
  struct Slice {
    std::int32_t step = 0;
    double from = 0, to = 0;
    double at(double s) const { return from + s * (to - from); }
  };
  /// Returns [from, to] as a slice of the step that contains its middle. No pose may lie inside
  /// [from, to].
  Slice slice(double from, double to) const;
  const StepPath& path(const Slice& slice) const { return paths_[slice.step]; }
  /// Returns the largest distance (mm) of the body's box from the rotation axis of the slice's
  /// step.
  double radius(const Slice& slice) const { return radii_[slice.step]; }
  /// Returns an upper bound (mm) of how far any point of the body deviates from the chord of its
  /// path in the slice.
  double bulge(const Slice& slice) const;

 private:
  std::int32_t stepAt(double time) const;

  Eigen::Vector3d centre_, half_;
  std::vector<double> times_;
  std::vector<StepPath> paths_;  ///< a body that stands still has one path, which does not move
  std::vector<double> radii_;
};

/// Returns all times of both motions that lie within the span, and both ends of the span.
std::vector<double> joinedTimes(const TimedMotion& a, const TimedMotion& b,
                                const TimeInterval& span);

/// Returns the placement of `a` in the frame of `b`.
Pose seenFrom(const Pose& a, const Pose& b);

/// Builds the tree over the motion of `body` relative to `frame`. `times` contains at least two
/// joined times. Both motions must outlive the tree.
MotionTree relativeMotion(const TimedMotion& body, const TimedMotion& frame,
                          const std::vector<double>& times);

/// Consider the corners of the body's box, as seen from `frame`. Returns the largest distance (mm)
/// between the positions of a corner at the first and at any other of the given times.
double relativeTravel(const TimedMotion& body, const TimedMotion& frame,
                      const std::vector<double>& times);

}  // namespace swept::clearance
