// A circle of a pipe that touches the envelope as a whole at one moment of a motion step: then its
// centre moves along the centre line. Near it, the contact curves of the pipe (pipe_contacts.h)
// change too quickly to be followed over time. But what they sweep there is smooth: each point of
// the circle lies on one smooth curve of points of contact, which passes through the circle at this
// moment. These curves make up the surface.
// Units:   mm, rad; s is the fraction of the step. Positions x: see pipe.h.
// Method:  Let (x, s) near the circle have the coordinates (X, Y), in which both speeds of pipe.h
//          have derivatives that are orthogonal and of equal length: Y is proportional to the time
//          from the critical moment, X to the distance from a position that drifts at a constant
//          speed. To first order, the points of contact in the direction psi are a straight line
//          through the origin of these coordinates, whose direction turns as psi does. So the
//          parameters of the surface are psi and the distance tau along this line, and the way
//          across to the true point of contact is found with the secant method. The surface
//          consists of two halves, of opposite directions, which meet in the contact curves at the
//          critical moment. It may pass through itself there. So each half is cut at the circle,
//          in what touches before this moment and what touches after it.
//          The window is the square in which X and Y are between -1 and 1. It is as large as the
//          speeds are nearly linear.
// Source:  a polar blow-up of a zero of two functions, as in the resolution of singularities.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/pipe.h"

namespace swept::step {

class CriticalCircle {
 public:
  /// Returns those whose windows contain a position in the range at a time within another range.
  /// Windows do not overlap. `isClosed`: the centre line is a circle with pipes all around.
  static std::vector<CriticalCircle> find(const Pipe& pipe, const StepPath& path, Range x,
                                          Range within, bool isClosed);

  double time() const { return time_; }
  /// Returns the times of the window, which may begin or end beyond the step.
  Range times() const { return {time_ - duration_, time_ + duration_}; }
  /// Returns the positions of the window at a time.
  Range positions(double s) const;
  /// Returns X at a position that is near the window, if positions are angles up to whole turns.
  double offsetOf(double x, double s) const;

  /// A quarter of the surface.
  struct Quarter {
    int half;      // 0 or 1
    bool isAfter;  // the critical moment
    bool operator==(const Quarter& other) const {
      return half == other.half && isAfter == other.isAfter;
    }
  };
  /// Returns the quarter to which the points of contact belong whose normal has this sign (of
  /// pipe_contacts.h), before or after the critical moment.
  static Quarter quarterOf(double sign, bool isAfter) {
    return {(sign > 0) == isAfter ? 0 : 1, isAfter};
  }
  /// Returns the ranges of the parameters: psi and tau.
  Range directions(int half) const;
  static Range reach(bool isAfter);
  /// Returns the range of psi on the circle.
  Range onCircle(int half) const;
  struct Place {
    double x, s;
  };
  /// Returns where a point of contact in the direction psi is; not finite if there is none.
  Place at(int half, double psi, double tau) const;
  Eigen::Vector2d parametersOf(int half, double x, double psi, double s) const;
  double position() const { return x_; }
  /// Returns the direction of the point of contact at a position at the critical moment, beyond
  /// the circle, of the curve with the positive sign. Before the circle, it is that of the other
  /// curve.
  Eigen::Vector2d directionAtMoment(double x) const;

 private:
  CriticalCircle(const Pipe& pipe, const StepPath& path, double x, double s);
  bool isValid() const { return duration_ > 0; }
  void setDuration(double duration);
  // Returns how much the speeds differ from linear ones at the border of the window, as a fraction.
  double nonlinearity() const;
  Eigen::Vector2d speedsAt(const Eigen::Vector2d& on) const;
  Place placeOf(const Eigen::Vector2d& on) const;
  // Returns the unit vector in (X, Y) along which tau is measured.
  Eigen::Vector2d lineOf(int half, double psi) const;
  double middleOf(int half) const { return half == 0 ? middle_ : middle_ + M_PI; }

  Pipe pipe_;
  const StepPath* path_;
  double x_, time_;
  double drift_ = 0;     // of x per unit of s
  double slope_ = 0;     // width of the window in x, per unit of its duration
  double duration_ = 0;  // half of it
  Eigen::Vector2d byX_,
      byTime_;         // derivatives of the speeds, by x, and by s at the drifting position
  double middle_ = 0;  // psi in the middle of half 0
};

}  // namespace swept::step
