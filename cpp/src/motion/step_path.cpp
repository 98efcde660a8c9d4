// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/step_path.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh_parts.h"

namespace swept {
namespace {

// A step that turns by less than this angle (rad) is treated as straight. A screw of length d and
// angle a turns about a point up to d / a away, so rounding (eps) displaces its points by eps d /
// a. A straight line instead of the screw deviates by d a / 8. Both errors are equal, about 5e-9 d,
// at a = sqrt(8 eps).
constexpr double kMinScrewAngle = 4e-8;

}  // namespace

Sphere boundingSphere(const TriMesh& body) {
  const Eigen::Vector3d centre = boxOf(body).center();
  double radius2 = 0;
  for (const auto& v : body.vertices) radius2 = std::max(radius2, (v - centre).squaredNorm());
  return {centre, std::sqrt(radius2)};
}

StepPath::StepPath(const Pose& from, const Pose& to, Interpolation interpolation)
    : from_(from), toTranslation_(to.translation), toTime_(to.timeSeconds) {
  Eigen::Quaterniond end = to.rotation;
  if (from.rotation.dot(end) < 0) end.coeffs() *= -1;
  const Eigen::AngleAxisd turn(from.rotation.conjugate() * end);
  angle_ = std::abs(turn.angle());
  axis_ = turn.angle() < 0 ? Eigen::Vector3d(-turn.axis()) : turn.axis();
  screw_ = interpolation == Interpolation::Screw && angle_ > kMinScrewAngle;
  if (!screw_) return;
  // In the frame of the first pose, the step is x -> R x + d. The component of d along the axis of
  // R is the pitch of the screw; `across` is the rest. A point c of the screw axis moves only along
  // this axis: R c + across = c. This gives c = (across + cot(angle/2) axis x across) / 2.
  const Eigen::Vector3d d = from.rotation.conjugate() * (to.translation - from.translation);
  pitch_ = axis_.dot(d);
  const Eigen::Vector3d across = d - axis_ * pitch_;
  axisPoint_ = 0.5 * (across + axis_.cross(across) / std::tan(angle_ / 2));
}

double StepPath::radius(const Eigen::Vector3d& point) const {
  return axis_.cross(point - axisPoint_).norm();
}

double StepPath::radius(const Sphere& body) const {
  if (!screw_) return body.centre.norm() + body.radius;
  const Eigen::Vector3d r = body.centre - axisPoint_;
  return (r - axis_ * axis_.dot(r)).norm() + body.radius;
}

Twist StepPath::twistAt(const Pose& pose) const {
  const Eigen::Vector3d angular = angle_ * axis();
  if (screw_) return {pitch_ * axis() - angular.cross(axisPoint()), angular};
  return {shift() - angular.cross(pose.translation), angular};
}

Pose StepPath::poseAt(double s) const {
  Pose pose;
  pose.timeSeconds = from_.timeSeconds + s * (toTime_ - from_.timeSeconds);
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(angle_ * s, axis_));
  pose.rotation = (from_.rotation * turned).normalized();
  if (screw_) {
    // In the frame of the first pose: x -> c + R(s)(x - c) + s * pitch * axis.
    const Eigen::Vector3d local = axisPoint_ - turned * axisPoint_ + axis_ * (s * pitch_);
    pose.translation = from_.rotation * local + from_.translation;
  } else {
    pose.translation = (1 - s) * from_.translation + s * toTranslation_;
  }
  return pose;
}

Placement StepPath::at(double s) const {
  const Pose pose = poseAt(s);
  return {pose.rotation.toRotationMatrix(), pose.translation, pose.timeSeconds};
}

double longestEdge(const TriMesh& body) {
  double longest = 0;
  for (const auto& t : body.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d edge = body.vertices[t[k]] - body.vertices[t[(k + 1) % 3]];
      longest = std::max(longest, edge.squaredNorm());
    }
  }
  return std::sqrt(longest);
}

double arcOf(const Motion& motion, std::size_t step, const Eigen::AlignedBox3d& box) {
  const Placement &p = motion.placements[step], &q = motion.placements[step + 1],
                  &m = motion.midpoints[step];
  double most = 0;
  for (int c = 0; c < 8; ++c) {
    const Eigen::Vector3d x = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(c));
    most = std::max(most, (m.apply(x) - (p.apply(x) + q.apply(x)) / 2).norm());
  }
  return 1.02 * most;
}

double piecesOf(double radius, double angle, double longest, double chord) {
  const double warp = warpOf(angle, longest);
  return (warp + std::sqrt(warp * warp + radius * angle * angle * chord / 2)) / (2 * chord);
}

}  // namespace swept
