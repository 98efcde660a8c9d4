// The points in which a torus or a sphere of a moving body touches its envelope. At each angle
// around the axis, a circle of the torus (the tube) has two of them. So there are two curves.
// Units:   mm, rad; s is the fraction of the motion step.
// Cost:    O(1) for a point.
// Method:  In the terms of contact_curves.h, the normal at a point of contact is c r + e a, where
//          (c, e) has the direction of (p, -q) or the opposite one, p = a.linear + R r.(a x
//          angular), and q = r.linear. Both are trigonometric functions of the angle. At a complex
//          zero of p + i q, the curve bends: it runs around the tube within a range of angles that
//          is as wide as the zero is far from the real angles. There,
//          asinh((angle - zero) / width) is a better measure than the angle. So positions on the
//          curve are sums of the angle and of such terms. At some moments a zero is real. Then a
//          whole circle of the tube touches the envelope, and the curves meet there. Shortly
//          before and after, no curves are known.
//          Contact curves of a sphere are great circles orthogonal to the velocity of its centre.
//          Angles are measured around this velocity, so that circles do not bend. Where it turns
//          far, the step is divided into ranges of times with different axes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "solid/assemble/body_geometry.h"
#include "solid/sweep/contact.h"

namespace swept::step {

class TorusContacts {
 public:
  /// `index`: of the surface. `within`: one of timesOf().
  TorusContacts(const BodyGeometry& body, int index, const StepPath& path, Range within);

  /// Returns the ranges of times that need different axes, in order: for a torus, the whole step.
  static std::vector<Range> timesOf(const BodySurface& surface, const StepPath& path);

  std::size_t count() const { return curves_.size(); }
  const Range& times(int curve) const { return curves_[curve].s; }
  /// Returns the positions (mm) between which the curve can be on a face.
  Range extent(int curve) const;
  /// A curve that can be on faces all around the axis is given in two halves. Returns the other
  /// half, or kNone. Each begins where the other one ends.
  int otherHalf(int curve) const { return curves_[curve].otherHalf; }
  static constexpr int kNone = -1;
  /// Returns a point in coordinates of the body; not finite where there is none.
  Eigen::Vector3d at(int curve, double w, double s) const;
  double positionAt(int curve, const Eigen::Vector3d& p, double s) const;
  /// Returns the point of a curve at the angle of p around the axis; not finite if it belongs to
  /// the other half.
  Eigen::Vector3d atAngleOf(int curve, const Eigen::Vector3d& p, double s) const;

 private:
  struct Curve {
    double sign;  // of the two curves
    Range s, on;  // `on`: the angles at which it can be on a face
    int otherHalf = kNone;
  };
  struct Bend {
    double at, width;  // rad
  };

  // Returns the point at an angle.
  Eigen::Vector3d onTube(double sign, double angle, double s) const;
  // Returns the angles at which a curve can be on a face, with 2 pi if all around; nothing if it is
  // never on one.
  std::optional<Range> anglesOnFaces(const BodyGeometry& body, int index, double sign) const;
  // Returns the bends of both curves. Their angles are within pi of the middle of the range.
  std::array<Bend, 2> bendsAt(Range on, double s) const;
  class Measure;
  // Appends the curves with this sign.
  void findCurves(double sign, Range on);
  // Returns the shortest time in which positions change much.
  double quickestChange(Range on, Range s) const;

  BodySurface surface_;
  const StepPath& path_;
  Range within_;
  Eigen::Vector3d across_;  // axis x angular velocity, which is constant for the body
  double scale_;            // mm per rad
  std::vector<Curve> curves_;
};

}  // namespace swept::step
