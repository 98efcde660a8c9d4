// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/step_path.h"

#include <algorithm>
#include <cmath>

namespace swept {
namespace {

constexpr double kSmallAngle = 1e-9;
// Triangles times placements that may be spent on flattening side patches.
constexpr double kMaxFaceCopies = 4e6;

}  // namespace

Sphere boundingSphere(const TriMesh& body) {
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  const Eigen::Vector3d centre = box.center();
  double radius2 = 0;
  for (const auto& v : body.vertices) radius2 = std::max(radius2, (v - centre).squaredNorm());
  return {centre, std::sqrt(radius2)};
}

StepPath::StepPath(const Pose& from, const Pose& to, Interpolation interpolation)
    : from_(from), to_(to), screw_(interpolation == Interpolation::Screw) {
  if (from.rotation.dot(to.rotation) < 0) to_.rotation.coeffs() *= -1;
  const Eigen::AngleAxisd turn(from_.rotation.conjugate() * to_.rotation);
  angle_ = std::abs(turn.angle());
  axis_ = turn.angle() < 0 ? Eigen::Vector3d(-turn.axis()) : turn.axis();
  if (screw_) findScrewAxis();
}

double StepPath::radius(const Sphere& body) const {
  if (screw_ && angle_ > kSmallAngle) {
    const Eigen::Vector3d r = body.centre - axisPoint_;
    return (r - axis_ * axis_.dot(r)).norm() + body.radius;
  }
  return body.centre.norm() + body.radius;
}

Placement StepPath::at(double s) const {
  Placement p;
  p.timeSeconds = from_.timeSeconds + s * (to_.timeSeconds - from_.timeSeconds);
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(angle_ * s, axis_));
  p.rotation = (from_.rotation * turned).normalized().toRotationMatrix();
  if (screw_ && angle_ > kSmallAngle) {
    // x -> c + R(s)(x - c) + s * pitch * axis, in the body frame of the first pose
    const Eigen::Vector3d local = axisPoint_ - turned * axisPoint_ + axis_ * (s * pitch_);
    p.translation = from_.rotation * local + from_.translation;
  } else {
    p.translation = (1 - s) * from_.translation + s * to_.translation;
  }
  return p;
}

void StepPath::findScrewAxis() {
  if (angle_ <= kSmallAngle) return;
  // Relative motion x -> R x + d in the first pose's frame: pitch along the axis, the rest of d
  // fixes a point c on it, d = (I - R) c  =>  c = (d + cot(angle/2) axis x d) / 2.
  const Eigen::Vector3d d = from_.rotation.conjugate() * (to_.translation - from_.translation);
  pitch_ = axis_.dot(d);
  const Eigen::Vector3d across = d - axis_ * pitch_;
  axisPoint_ = 0.5 * (across + axis_.cross(across) / std::tan(angle_ / 2));
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

double piecesOf(double radius, double angle, double longest, double chord, double mostPieces) {
  // radius * angle^2 / (8 n^2) <= chord; the exact sagitta is a little smaller
  return std::max(std::sqrt(radius * angle * angle / (8 * chord)),
                  std::min(warpOf(angle, longest) / chord, mostPieces));
}

double mostPiecesOf(double triangles, std::size_t steps) {
  return kMaxFaceCopies / triangles / static_cast<double>(steps);
}

}  // namespace swept
