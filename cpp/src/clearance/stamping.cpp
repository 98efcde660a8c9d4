// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/stamping.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "clearance/motion_tree.h"
#include "motion/pivot.h"
#include "swept/clearance.h"

namespace swept::clearance {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> modelOf(const TriMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<Model>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transformOf(const Pose& pose) {
  fcl::Transform3d place = fcl::Transform3d::Identity();
  place.linear() = pose.rotation.toRotationMatrix();
  place.translation() = pose.translation;
  return place;
}

}  // namespace

StampedMinimum stampEveryPose(const TriMesh& body, const std::vector<Pose>& poses,
                              const TriMesh& neighbour, RunContext& run) {
  return stampEveryPose(body, poses, neighbour, std::vector<Pose>(poses.size()), run);
}

StampedMinimum stampEveryPose(const TriMesh& body, const std::vector<Pose>& poses,
                              const TriMesh& neighbour, const std::vector<Pose>& neighbourPoses,
                              RunContext& run) {
  const std::shared_ptr<Model> moving = modelOf(body);
  const std::shared_ptr<Model> still = modelOf(neighbour);
  const auto nearer = [](const StampedMinimum& a, const StampedMinimum& b) {
    if (a.pose < 0 || b.pose < 0) return a.pose < 0 ? b : a;
    if (a.distance != b.distance) return a.distance < b.distance ? a : b;
    return a.pose < b.pose ? a : b;
  };
  return tbb::parallel_reduce(
      tbb::blocked_range<std::int64_t>(0, std::ssize(poses), 64), StampedMinimum{},
      [&](const tbb::blocked_range<std::int64_t>& range, StampedMinimum best) {
        run.checkpoint(Phase::Check);
        for (std::int64_t i = range.begin(); i < range.end(); ++i) {
          fcl::DistanceRequestd request;
          fcl::DistanceResultd result;
          fcl::distance<double>(moving.get(), transformOf(poses[i]), still.get(),
                                transformOf(neighbourPoses[i]), request, result);
          best = nearer(best, {std::max(0.0, result.min_distance), i});
        }
        return best;
      },
      nearer);
}

std::vector<Pose> densePoses(const Trajectory& trajectory, int between) {
  if (between <= 0 || trajectory.poses.size() < 2) return trajectory.poses;
  const MotionTree motion(trajectory, Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  std::vector<Pose> poses;
  const std::int64_t steps = std::ssize(trajectory.poses) - 1;
  for (std::int64_t i = 0; i < steps; ++i)
    for (int k = 0; k <= between; ++k)
      poses.push_back(motion.poseAt(double(i) + double(k) / (between + 1)));
  poses.push_back(trajectory.poses.back());
  return poses;
}

}  // namespace swept::clearance

namespace swept {

StampedClearance stampedClearance(const TriMesh& body, const Trajectory& trajectory,
                                  const TriMesh& neighbour, int between, RunContext& run) {
  const Eigen::Vector3d pivot = pivotOf(trajectory);
  std::vector<Pose> poses = clearance::densePoses(carriedByPivot(trajectory, pivot), between);
  for (Pose& pose : poses) pose = backFromPivot(pose, pivot);
  const clearance::StampedMinimum least = clearance::stampEveryPose(body, poses, neighbour, run);
  return {least.distance, poses[least.pose].timeSeconds, std::ssize(poses)};
}

}  // namespace swept
