// The points in which a surface of a moving body touches its envelope. At each time of a motion
// step they form one curve on a plane, two on a cylinder, a cone, a sphere or a torus.
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
//          known. Here linear is the velocity of the point of the axis at which h is 0.
// Source:  Abdel-Malek, Blackmore and Joy 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "solid/assemble/body_geometry.h"
#include "solid/sweep/contact.h"

namespace swept::step {

class ContactCurves {
 public:
  /// `index`: of the surface.
  ContactCurves(const BodyGeometry& body, int index, const StepPath& path);

  /// Returns how many curves there are. A plane that keeps its direction has none. None are known
  /// on other surfaces.
  int count() const { return count_; }
  /// Those of a cylinder are parallel to its axis if the body turns about a parallel one.
  bool areStraight() const {
    return surface_.isPlane() || (surface_.isCylinder() && size_ <= kNoSpeed);
  }
  /// Returns a point of a curve in coordinates of the body; not finite where there is none. `w`:
  /// mm, position along the line of a plane or a cone, along the axis of a cylinder, around the
  /// axis of a torus.
  Eigen::Vector3d at(int curve, double w, double s) const;
  double positionAt(int curve, const Eigen::Vector3d& p) const;
  /// Returns the curve to which a point of contact belongs.
  int curveOf(const Eigen::Vector3d& p, double s) const;
  /// Returns the positions between which the faces of the surface lie.
  const Range& extent() const { return extent_; }
  /// Unit vector along the line or the axis, in coordinates of the body.
  const Eigen::Vector3d& along() const { return along_; }

 private:
  Range extentOf(const BodyGeometry& body, int index) const;
  // Returns the point of a torus at an angle around the axis.
  Eigen::Vector3d onTorus(int curve, double angle, double s) const;
  // Returns the angle opposite to angles at which the curve is never on a face. NaN if it always
  // is.
  double middleOf(const BodyGeometry& body, int index, int curve) const;

  const BodySurface& surface_;
  const StepPath& path_;
  Eigen::Vector3d origin_;  // of the positions
  Eigen::Vector3d along_, across_;
  double size_ = 0;                 // of axis x angular
  double scale_ = 1;                // of a torus: mm per rad
  std::array<double, 2> middle_{};  // of a torus, by curve: the angle at position 0
  int count_ = 0;
  Range extent_;
};

}  // namespace swept::step
