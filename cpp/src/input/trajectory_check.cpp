// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/trajectory_check.h"

#include <cmath>
#include <string>

#include "base/limits.h"
#include "base/number_text.h"

namespace swept {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kReportedDeviation = 1e-9;  // smaller deviations are corrected without a finding
constexpr double kAmbiguousDegrees = 1.0;

// Messages count poses from 1, like the rows of a table.
std::string poseName(std::size_t index) { return "pose " + std::to_string(index + 1); }
constexpr const char* kCounted = " (poses are counted from 1)";

void checkFinite(const Pose& pose, std::size_t index) {
  const char* what = nullptr;
  if (!std::isfinite(pose.timeSeconds)) what = "the time";
  if (!pose.translation.allFinite()) what = "the translation";
  if (!pose.rotation.coeffs().allFinite()) what = "the rotation";
  if (what != nullptr) {
    throw Error(Status::InvalidInput, "BadPose",
                poseName(index) + ": " + what +
                    " is not a finite number; correct or remove this pose" + kCounted);
  }
  if (pose.translation.cwiseAbs().maxCoeff() > kMaxLength) {
    throw Error(
        Status::InvalidInput, "BadPose",
        poseName(index) + ": translation of " + numberText(pose.translation.cwiseAbs().maxCoeff()) +
            " mm is above the limit of 1e9 mm; check the unit of length of the motion" + kCounted);
  }
}

/// Returns | |q| - 1 |. Throws if rounding cannot explain the deviation.
double checkNorm(const Pose& pose, std::size_t index) {
  const double norm = pose.rotation.norm();
  if (norm < 1e-12) {
    throw Error(Status::InvalidInput, "NotRigid",
                poseName(index) +
                    ": the rotation quaternion is zero; for no rotation, use "
                    "(qx, qy, qz, qw) = (0, 0, 0, 1)" +
                    kCounted);
  }
  const double deviation = std::abs(norm - 1);
  if (deviation > kRigidLimit) {
    throw Error(Status::InvalidInput, "NotRigid",
                poseName(index) + ": the rotation quaternion has length " + numberText(norm) +
                    " instead of 1 (allowed error: 1e-4), so the pose scales the part by " +
                    numberText(norm * norm) + "; export the poses without scale" + kCounted);
  }
  return deviation;
}

void checkTurn(const Pose& before, const Pose& after, std::size_t index) {
  const Eigen::Quaterniond turn = before.rotation.conjugate() * after.rotation;
  const double degrees =
      2 * std::atan2(turn.vec().norm(), std::abs(turn.w())) * 180 / kPi;  // 0 to 180
  if (degrees > 180 - kAmbiguousDegrees) {
    throw Error(Status::InvalidInput, "AmbiguousTurn",
                "between " + poseName(index - 1) + " and " + poseName(index) +
                    " the part turns by " + numberText(degrees) +
                    " degrees (limit: " + numberText(180 - kAmbiguousDegrees) +
                    "), so the direction of the turn is ambiguous; insert a pose between them, or "
                    "choose interpolation none" +
                    kCounted);
  }
}

void addFirst(Finding& finding, std::size_t index) {
  ++finding.count;
  if (finding.first.size() < 8) finding.first.push_back(static_cast<std::int64_t>(index));
}

bool samePlacement(const Pose& a, const Pose& b) {
  if (a.translation != b.translation) return false;
  const auto& p = a.rotation.coeffs();
  const auto& q = b.rotation.coeffs();
  return p == q || p == -q;
}

}  // namespace

CheckedTrajectory checkTrajectory(const Trajectory& trajectory, RepeatedPoses repeats) {
  if (trajectory.poses.empty()) {
    throw Error(Status::InvalidInput, "EmptyTrajectory",
                "the motion has no poses; give at least one (with a single pose, the envelope is "
                "the part itself)");
  }
  CheckedTrajectory result;
  result.trajectory.interpolation = trajectory.interpolation;
  auto& poses = result.trajectory.poses;
  poses.reserve(trajectory.poses.size());
  Finding mended{"RotationMended", 0, {}, ""};
  Finding repeated{"RepeatedPoses", 0, {}, ""};
  Finding equal{"EqualTimes", 0, {}, ""};
  double largest = 0;
  const bool continuous = trajectory.interpolation != Interpolation::None;
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    Pose pose = trajectory.poses[i];
    checkFinite(pose, i);
    const double deviation = checkNorm(pose, i);
    largest = std::max(largest, deviation);
    if (deviation > kReportedDeviation) addFirst(mended, i);
    if (i > 0 && pose.timeSeconds == trajectory.poses[i - 1].timeSeconds) addFirst(equal, i);
    if (i > 0 && pose.timeSeconds < trajectory.poses[i - 1].timeSeconds) {
      throw Error(Status::InvalidInput, "BadPose",
                  poseName(i) + ": time " + numberText(pose.timeSeconds, kTellingDigits) +
                      " s is earlier than " +
                      numberText(trajectory.poses[i - 1].timeSeconds, kTellingDigits) +
                      " s, the time of the pose before; times must not decrease" + kCounted);
    }
    pose.rotation.normalize();
    if (!poses.empty()) {
      // Adjacent quaternions get the same sign, so that interpolation takes the shorter rotation.
      if (poses.back().rotation.dot(pose.rotation) < 0) pose.rotation.coeffs() *= -1;
      const bool later = pose.timeSeconds > poses.back().timeSeconds;
      if (samePlacement(poses.back(), pose) && !(repeats == RepeatedPoses::Keep && later)) {
        addFirst(repeated, i);
        continue;
      }
      if (continuous) checkTurn(poses.back(), pose, i);
    }
    poses.push_back(pose);
    result.given.push_back(static_cast<std::int32_t>(i));
  }
  if (mended.count > 0) {
    mended.text = counted(mended.count, "pose had a quaternion", "poses had quaternions") +
                  " whose length deviated from 1 by up to " + numberText(largest, 3) +
                  "; the length was corrected to 1";
    result.findings.push_back(mended);
  }
  if (repeated.count > 0) {
    repeated.text = counted(repeated.count, "pose has", "poses have") +
                    " the same placement as the pose before and " +
                    (repeated.count == 1 ? "was" : "were") + " left out";
    result.findings.push_back(repeated);
  }
  if (equal.count > 0) {
    equal.text = counted(equal.count, "pose has", "poses have") +
                 " the same time as the pose before; the given order was kept";
    result.findings.push_back(equal);
  }
  return result;
}

}  // namespace swept
