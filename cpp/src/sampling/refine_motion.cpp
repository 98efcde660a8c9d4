// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/refine_motion.h"

#include <algorithm>
#include <cmath>

namespace swept {
namespace {

constexpr std::size_t kMaxPlacements = 4'000'000;
constexpr double kSmallAngle = 1e-9;
// Triangles times placements that may be spent on flattening side patches.
constexpr double kMostFaceCopies = 4e6;

struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

Sphere boundingSphere(const TriMesh& body) {
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  const Eigen::Vector3d centre = box.center();
  double radius2 = 0;
  for (const auto& v : body.vertices) radius2 = std::max(radius2, (v - centre).squaredNorm());
  return {centre, std::sqrt(radius2)};
}

/// The way from one pose to the next, at any s in [0, 1].
class StepPath {
 public:
  StepPath(const Pose& from, const Pose& to, Interpolation interpolation)
      : from_(from), to_(to), screw_(interpolation == Interpolation::Screw) {
    if (from.rotation.dot(to.rotation) < 0) to_.rotation.coeffs() *= -1;
    const Eigen::AngleAxisd turn(from_.rotation.conjugate() * to_.rotation);
    angle_ = std::abs(turn.angle());
    axis_ = turn.angle() < 0 ? Eigen::Vector3d(-turn.axis()) : turn.axis();
    if (screw_) findScrewAxis();
  }

  double angle() const { return angle_; }

  /// Largest distance of a point of the sphere (body frame) from the centre line of rotation.
  double radius(const Sphere& body) const {
    if (screw_ && angle_ > kSmallAngle) {
      const Eigen::Vector3d r = body.centre - axisPoint_;
      return (r - axis_ * axis_.dot(r)).norm() + body.radius;
    }
    return body.centre.norm() + body.radius;
  }

  Placement at(double s) const {
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

 private:
  void findScrewAxis() {
    if (angle_ <= kSmallAngle) return;
    // Relative motion x -> R x + d in the first pose's frame: pitch along the axis, the rest of d
    // fixes a point c on it, d = (I - R) c  =>  c = (d + cot(angle/2) axis x d) / 2.
    const Eigen::Vector3d d = from_.rotation.conjugate() * (to_.translation - from_.translation);
    pitch_ = axis_.dot(d);
    const Eigen::Vector3d across = d - axis_ * pitch_;
    axisPoint_ = 0.5 * (across + axis_.cross(across) / std::tan(angle_ / 2));
  }

  Pose from_, to_;
  bool screw_;
  double angle_ = 0, pitch_ = 0;
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ(), axisPoint_ = Eigen::Vector3d::Zero();
};

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

/// Pieces of each step that keep side patches flat. The patch of an edge of length L over a turn by
/// a is warped: its two triangles leave the ruled surface by up to L a / 4, which bounds on the
/// chords of points do not see. Many small triangles are flat enough by themselves and too many to
/// be copied often, so the pieces are limited by what they cost.
double flatPieces(double longest, double angle, double chord, double mostPieces) {
  return std::min(longest * angle / (4 * chord), mostPieces);
}

Placement asPlacement(const Pose& pose) {
  return {pose.rotation.normalized().toRotationMatrix(), pose.translation, pose.timeSeconds};
}

}  // namespace

Motion refineMotion(const TriMesh& body, const Trajectory& trajectory, double chord,
                    RunContext& run) {
  const auto& poses = trajectory.poses;
  Motion motion;
  motion.continuous = trajectory.interpolation != Interpolation::None && poses.size() > 1;
  const Sphere sphere = boundingSphere(body);
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Eigen::Vector3d moved = poses[i + 1].rotation * sphere.centre + poses[i + 1].translation -
                                  poses[i].rotation * sphere.centre - poses[i].translation;
    const double turn = poses[i].rotation.angularDistance(poses[i + 1].rotation);
    motion.largestStepTravel =
        std::max(motion.largestStepTravel, moved.norm() + 2 * std::sin(turn / 2) * sphere.radius);
  }
  if (!motion.continuous) {
    motion.placements.reserve(poses.size());
    for (const Pose& pose : poses) motion.placements.push_back(asPlacement(pose));
    return motion;
  }
  motion.placements.push_back(asPlacement(poses.front()));
  const double longest = longestEdge(body);
  const double mostPieces = kMostFaceCopies / static_cast<double>(body.triangles.size()) /
                            static_cast<double>(poses.size() - 1);
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    run.checkpoint(Phase::Motion, i, poses.size());
    const StepPath path(poses[i], poses[i + 1], trajectory.interpolation);
    const double radius = path.radius(sphere);
    // radius * angle^2 / (8 n^2) <= chord; the exact sagitta is a little smaller
    const double wanted = std::max(std::sqrt(radius * path.angle() * path.angle() / (8 * chord)),
                                   flatPieces(longest, path.angle(), chord, mostPieces));
    if (!(wanted < static_cast<double>(kMaxPlacements - motion.placements.size()))) {
      throw Error(Status::ResourceLimit, "ResourceLimit",
                  "the motion between poses " + std::to_string(i) + " and " +
                      std::to_string(i + 1) + " would need more than " +
                      std::to_string(kMaxPlacements) +
                      " placements to follow its turn; use a larger cell or put the body's origin "
                      "closer to the body");
    }
    const int pieces = std::max(1, static_cast<int>(std::ceil(wanted)));
    motion.chordError =
        std::max(motion.chordError, radius * (1 - std::cos(path.angle() / (2 * pieces))) +
                                        longest * path.angle() / (4 * pieces));
    for (int piece = 0; piece < pieces; ++piece) {
      motion.midpoints.push_back(path.at((piece + 0.5) / pieces));
      motion.placements.push_back(piece + 1 == pieces ? asPlacement(poses[i + 1])
                                                      : path.at((piece + 1.0) / pieces));
    }
  }
  return motion;
}

}  // namespace swept
