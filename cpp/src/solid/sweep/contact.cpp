// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/contact.h"

namespace swept::step {

Moment::Moment(const StepPath& path, double s) : placement(path.at(s)) {
  const Twist twist = path.twistAt(path.poseAt(s));
  const Eigen::Matrix3d back = placement.rotation.transpose();
  linear = back * (twist.linear + twist.angular.cross(placement.translation));
  angular = back * twist.angular;
}

}  // namespace swept::step
