// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/refine_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.h"
#include "motion/step_path.h"

namespace swept {
namespace {

constexpr std::size_t kMaxPlacements = 4'000'000;

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
    for (const Pose& pose : poses) {
      motion.poses.push_back(static_cast<std::uint32_t>(motion.placements.size()));
      motion.placements.push_back(asPlacement(pose));
    }
    return motion;
  }
  motion.placements.push_back(asPlacement(poses.front()));
  motion.poses.push_back(0);
  const double longest = longestEdge(body);
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    run.checkpoint(Phase::Motion, i, poses.size());
    const StepPath path(poses[i], poses[i + 1], trajectory.interpolation);
    const double radius = path.radius(sphere);
    const double wanted = piecesOf(radius, path.angle(), longest, chord);
    if (!(wanted < static_cast<double>(kMaxPlacements - motion.placements.size()))) {
      throw Error(Status::ResourceLimit, "ResourceLimit",
                  textOf(4, "between poses ", i + 1, " and ", i + 2, " (counted from 1, at ",
                         poses[i].timeSeconds, " s and ", poses[i + 1].timeSeconds,
                         " s), the part turns by ", path.angle() * 180 / std::numbers::pi,
                         " degrees about an axis up to ", radius,
                         " mm away, which would need more than ", kMaxPlacements,
                         " sampled placements; use a larger cell, or a pivot closer to the part"));
    }
    const int pieces = std::max(1, static_cast<int>(std::ceil(wanted)));
    motion.chordError =
        std::max(motion.chordError, radius * (1 - std::cos(path.angle() / (2 * pieces))) +
                                        warpOf(path.angle() / pieces, longest));
    for (int piece = 0; piece < pieces; ++piece) {
      motion.midpoints.push_back(path.at((piece + 0.5) / pieces));
      motion.placements.push_back(piece + 1 == pieces ? asPlacement(poses[i + 1])
                                                      : path.at((piece + 1.0) / pieces));
    }
    motion.poses.push_back(static_cast<std::uint32_t>(motion.placements.size() - 1));
  }
  return motion;
}

}  // namespace swept
