// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/position_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swept {
namespace {

constexpr double kMaxTurn = M_PI / 2;
using Corners = std::array<Eigen::Vector3d, 8>;

Corners cornersAt(const Pose& pose, const Eigen::AlignedBox3d& body) {
  Corners corners;
  for (int c = 0; c < 8; ++c) {
    corners[c] = pose.rotation * body.corner(static_cast<Eigen::AlignedBox3d::CornerType>(c)) +
                 pose.translation;
  }
  return corners;
}

/// Returns the largest distance that a point of the box moves between two placements. `a` and `b`:
/// the corners of the box at these placements. The maximum occurs at a corner, because the distance
/// is a convex function of the point.
double farthest(const Corners& a, const Corners& b) {
  double most = 0;
  for (int c = 0; c < 8; ++c) most = std::max(most, (a[c] - b[c]).norm());
  return most;
}

}  // namespace

FilteredTrajectory filterPositions(const Trajectory& trajectory, const Eigen::AlignedBox3d& body,
                                   double distance) {
  FilteredTrajectory out;
  out.trajectory.interpolation = trajectory.interpolation;
  const bool continuous = trajectory.interpolation != Interpolation::None;
  const auto& poses = trajectory.poses;
  auto& kept = out.trajectory.poses;
  if (poses.empty()) return out;
  Corners last = cornersAt(poses.front(), body);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Corners here = cornersAt(poses[i], body);
    const bool isLast = i + 1 == poses.size();
    bool keep = i == 0 || (continuous && isLast);
    if (!keep) {
      const double moved = farthest(here, last);
      keep =
          moved > distance ||
          (continuous && kept.back().rotation.angularDistance(poses[i + 1].rotation) >= kMaxTurn);
      if (!keep) {
        ++out.dropped;
        out.distance = std::max(out.distance, moved);
      }
    }
    if (!keep) continue;
    Pose pose = poses[i];
    if (i > 0 && kept.back().rotation.dot(pose.rotation) < 0) pose.rotation.coeffs() *= -1;
    kept.push_back(pose);
    out.kept.push_back(static_cast<std::int32_t>(i));
    last = here;
  }
  return out;
}

}  // namespace swept
