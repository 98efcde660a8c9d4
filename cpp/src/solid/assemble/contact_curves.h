// The points in which a surface of a moving body touches its envelope. At each time of a motion
// step they form one curve on a plane, and two on a cylinder, a sphere, a torus and mostly on a
// cone.
// Units:   mm; s is the fraction of the step.
// Cost:    O(1) for a point.
// Method:  A point p of the body has the velocity v = linear + angular x p, in coordinates of the
//          body. A surface with the normal n touches the envelope where n.v = 0. On a plane this is
//          a line, which keeps its direction in the plane. On a surface of revolution with the axis
//          a, let r be the direction from the axis to p, at the height h and the distance d from
//          the axis, and n = c r + e a. Then n.v = r.m + e a.linear, where m = c linear + (d e -
//          h c) (a x angular). On a circle of a cylinder or a cone, m, c and e are the same
//          everywhere, so r has a known angle to m. On a torus, d e - h c = e R, where R is the
//          radius from the axis to the tube. So at each angle around the axis, c / e is
//          known (pipe_contacts.h). Here linear is the velocity of the point of the axis at which
//          h is 0. Circles of a cone for which |m| < |e a.linear| do not touch the envelope. They
//          form one gap, as |m|^2 is a quadratic function of h. Where it begins and where it ends,
//          the two curves meet. So there is one curve on each side of the gap, which turns round
//          there. Which curves there are changes at some times of the step (Curve::s). The curves
//          of tori and spheres, and of cylinders of which a whole circle touches the envelope at
//          some moment, are those of pipe_contacts.h.
// Source:  Abdel-Malek, Blackmore and Joy 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "solid/assemble/body_geometry.h"
#include "solid/assemble/pipe_contacts.h"
#include "solid/sweep/contact.h"

namespace swept::step {

class ContactCurves {
 public:
  /// `index`: of the surface.
  ContactCurves(const BodyGeometry& body, int index, const StepPath& path);

  static constexpr int kNoCurve = -1;

  /// Returns how many curves there are. A plane that keeps its direction has none. None are known
  /// on other surfaces.
  int count() const { return static_cast<int>(curves_.size()); }
  /// Returns the times between which there is a curve.
  const Range& times(int curve) const { return curves_[curve].s; }
  /// Returns all ends of such times, and 0 and 1, in order.
  const std::vector<double>& changes() const { return changes_; }
  /// Those of a cylinder are parallel to its axis if the body turns about a parallel one.
  bool areStraight() const {
    return surface_.isPlane() || (surface_.isCylinder() && size_ <= kNoSpeed);
  }
  /// Returns a point of a curve in coordinates of the body; not finite where there is none. `w`:
  /// mm, position along the line of a plane or a cone, along the axis of a cylinder, around the
  /// axis of a torus. On a curve that turns round it is 0 there, and grows to both sides.
  Eigen::Vector3d at(int curve, double w, double s) const;
  double positionAt(int curve, const Eigen::Vector3d& p, double s) const;
  /// Returns the curve to which a point of contact belongs, or kNoCurve.
  int curveOf(const Eigen::Vector3d& p, double s) const;
  /// Returns the positions between which the faces of the surface lie.
  Range extent(int curve) const;
  /// Returns whether the curve is one of several parts of a longer one.
  bool isPart(int curve) const;
  /// Returns whether a curve ends where another one begins.
  bool doesContinue(int curve, int next) const;
  /// Returns whether the curve begins, or ends, at the window of a critical circle.
  bool isAtWindow(int curve, bool isEnd) const;
  /// Of a part: returns how far a point is beyond the start (or the end) of the curve, along the
  /// centre line of the pipe. Angles are within pi of the end.
  double offsetFromEnd(int curve, bool isEnd, const Eigen::Vector3d& p, double s) const;
  /// Returns whether a position belongs to the curve: not to another part.
  bool doesOwn(int curve, double w) const {
    if (!isPart(curve)) return true;
    const Range own = extent(curve);
    return w >= own.from && w <= own.to;
  }

  /// What curves sweep near a critical circle: a quarter of a surface (critical_circle.h).
  struct Fan {
    int pipe, critical;
    CriticalCircle::Quarter quarter;
    bool isBeside(const Fan& other) const {
      return pipe == other.pipe && critical == other.critical;
    }
    bool operator==(const Fan& other) const { return isBeside(other) && quarter == other.quarter; }
  };
  /// Returns the fan that contains what a curve sweeps, if there is one.
  std::optional<Fan> fanOf(int curve) const;
  const CriticalCircle& criticalOf(const Fan& fan) const;
  const Pipe& pipeOf(const Fan& fan) const { return pipes_[fan.pipe].pipe(); }
  struct Touch {
    Eigen::Vector3d p;  // in coordinates of the body; not finite where there is none
    double s;
  };
  /// The parameters of a fan are the position on the circle (mm), and a position across it that
  /// is similar to s.
  Touch at(const Fan& fan, const Eigen::Vector2d& on) const;
  Eigen::Vector2d parametersOf(const Fan& fan, const Eigen::Vector3d& p, double s) const;
  Eigen::AlignedBox2d extent(const Fan& fan) const;
  /// Returns whether a point of contact lies in the window of a fan. `slack`: how far it may lie
  /// beyond, as a fraction of the window.
  bool doesOwn(const Fan& fan, const Touch& touch, double slack = 1e-9) const;

  /// Unit vector along the line or the axis, in coordinates of the body.
  const Eigen::Vector3d& along() const { return along_; }

 private:
  // Of a cylinder or a cone: the curve crosses all circles, or turns round above or below a gap.
  enum class Course { Whole, Above, Below };
  struct Curve {
    Course course = Course::Whole;
    double sign = 1;  // of two curves that cross all circles
    Range s;
    // Whether positions are spread where the curve bends.
    bool isSpread = false;
    std::size_t pipe = 0;  // index of the pipe, if there are pipes
    int own = 0;           // index of the curve there
  };
  // Of a cylinder or a cone at one time.
  struct Circles {
    double speedAlong;           // a.linear
    Eigen::Vector3d first;       // m at w = 0
    Range gap;                   // positions without contact
    double distance = HUGE_VAL;  // if there is no gap, from gap.from to a complex zero of |m|
  };

  Circles circlesAt(double s) const;
  // Returns m on the circle at a position.
  Eigen::Vector3d onCircle(const Circles& circles, double w) const {
    return circles.first - w * across_;
  }
  // Where a curve turns round, in positions along the line: the end of the gap at which it does,
  // the other end of the gap, and the signed length from the first to where the curve is left off.
  struct Turn {
    double at, other, length;
  };
  Turn turnOf(Course course, const Circles& circles) const;
  // Near a complex zero of |m|, the curve bends quickly, as the function atan does. There,
  // asinh((position - zero) / distance) is a better measure. Returns its range on the extent.
  Range spreadOf(const Circles& circles) const;
  // Returns how far that zero is from the extent, if there is no gap.
  double distanceToZero(const Circles& circles) const;
  bool needsSpread(Range s) const;
  // Returns the extent with a margin, in which the curves must be regular.
  Range wideExtent() const;
  // Returns whether there are curves with this course at this time, and whether they are regular.
  bool isRegular(Course course, double s) const;
  void findCurves();
  // Lists the ends of the times of all curves.
  void findChanges();
  // Returns the shortest time in which curves change much.
  double quickestChange(Course course, Range s) const;
  Eigen::Vector3d onCircles(const Curve& curve, double w, double s) const;
  // Returns the position of a point on a curve that turns round.
  double positionOnTurn(Course course, const Eigen::Vector3d& p, double s) const;

  const BodySurface& surface_;
  const StepPath& path_;
  Eigen::Vector3d origin_;  // of the positions
  Eigen::Vector3d along_, across_;
  double size_ = 0;  // of axis x angular
  void appendPipe(PipeContacts contacts);
  // Returns the pipe of a curve, and the index of the curve there.
  std::pair<const PipeContacts&, int> pipeOf(int curve) const {
    return {pipes_[curves_[curve].pipe], curves_[curve].own};
  }
  // mm: converts the parameters of a fan.
  Eigen::Vector2d scaleOf(const Fan& fan) const;

  std::vector<PipeContacts> pipes_;  // within ranges of times
  std::vector<Curve> curves_;
  std::vector<double> changes_{0, 1};
  Range extent_;
};

}  // namespace swept::step
