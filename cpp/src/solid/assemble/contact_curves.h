// The points in which a surface of a moving body touches its envelope. At each time of a motion
// step they form one curve on a plane, two on a cylinder.
// Units:   mm; s is the fraction of the step.
// Cost:    O(1) for a point.
// Method:  A point p of the body has the velocity v = linear + angular x p, in coordinates of the
//          body. A surface with the normal n touches the envelope where n.v = 0. On a plane this is
//          a line, which keeps its direction in the plane. At each point of the axis of a cylinder,
//          it is two points of the circle around: n is orthogonal to the axis and to the velocity
//          of the point of the axis, as angular x r n is orthogonal to n.
// Source:  Abdel-Malek, Blackmore and Joy 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include "solid/assemble/elementary_body.h"
#include "solid/sweep/contact.h"

namespace swept::step {

class ContactCurves {
 public:
  ContactCurves(const BodySurface& surface, const StepPath& path);

  /// Returns how many curves there are. A plane that keeps its direction has none.
  int count() const { return surface_.isPlane ? (size_ > kNoSpeed ? 1 : 0) : 2; }
  /// Those of a cylinder are parallel to its axis if the body turns about a parallel one.
  bool areStraight() const { return surface_.isPlane || size_ <= kNoSpeed; }
  /// Returns a point of a curve in coordinates of the body. `w`: mm, position along the line or the
  /// axis.
  Eigen::Vector3d at(int curve, double w, double s) const;
  double positionAt(const Eigen::Vector3d& p) const { return p.dot(along_); }
  /// Returns the curve to which a point of contact belongs.
  int curveOf(const Eigen::Vector3d& p, double s) const;
  /// Returns the positions between which the faces of the surface lie.
  Range extent(const ElementaryBody& body, int surface) const;
  /// Unit vector along the line or the axis, in coordinates of the body.
  const Eigen::Vector3d& along() const { return along_; }

 private:
  const BodySurface& surface_;
  const StepPath& path_;
  Eigen::Vector3d origin_;  // foot of the perpendicular from the origin onto the plane or axis
  Eigen::Vector3d along_, across_;
  double size_ = 0;  // of axis x angular
};

}  // namespace swept::step
