// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/unblocked_path.h"

#include <algorithm>
#include <limits>

#include "geometry/mesh_parts.h"
#include "path/found_path.h"

namespace swept::path {
namespace {

Trajectory straight(const PathTask& task, Interpolation interpolation, double far) {
  Pose start = task.start.value_or(task.goal);
  if (task.extraction) {
    const auto& direction = task.extraction->direction;
    start.translation += direction ? Eigen::Vector3d(far * direction->normalized())
                                   : Eigen::Vector3d(0, 0, task.extraction->radius);
  }
  Trajectory motion{{start}, interpolation};
  motion.poses.insert(motion.poses.end(), task.via.begin(), task.via.end());
  motion.poses.push_back(task.goal);
  return motion;
}

}  // namespace

PathReport unblockedPath(const SequencePart& part, const PathOptions& options, double far) {
  PathReport report;
  report.verdict = PathVerdict::Found;
  report.method = part.motion ? "given" : "nothing in the way";
  report.path = part.motion ? *part.motion : straight(part.task, options.interpolation, far);
  report.clearance = std::numeric_limits<double>::infinity();
  const Eigen::AlignedBox3d box = boxOf(part.mesh);
  const double radius = 0.5 * box.diagonal().norm();
  std::vector<State> keys;
  for (Pose& pose : report.path.poses) {
    keys.push_back({pose, pose.rotation * box.center() + pose.translation});
    if (part.motion || keys.size() < 2) continue;
    const State& last = keys[keys.size() - 2];
    const double length = (keys.back().middle - last.middle).norm() +
                          radius * pose.rotation.angularDistance(last.pose.rotation);
    pose.timeSeconds = last.pose.timeSeconds + std::max(1e-6, length / kPathSpeed);
    keys.back().pose = pose;
  }
  if (!part.motion) report.path.poses.front().timeSeconds = 0;
  addLength(keys, report);
  report.summary = "nothing in the way";
  return report;
}

}  // namespace swept::path
