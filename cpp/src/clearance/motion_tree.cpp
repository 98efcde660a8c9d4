// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/motion_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

// Largest number of members of a cluster that is not divided into child clusters.
constexpr std::int32_t kBucket = 4;

// Steps of one body between its successive poses, in world coordinates.
class PathSteps : public MotionSteps {
 public:
  /// Returns nullptr if the trajectory is not interpolated or has fewer than two poses.
  static std::unique_ptr<const PathSteps> of(const Trajectory& trajectory, const Vector3d& centre,
                                             const Vector3d& half) {
    if (trajectory.interpolation == Interpolation::None || trajectory.poses.size() < 2)
      return nullptr;
    auto steps = std::make_unique<PathSteps>();
    steps->steps_.reserve(trajectory.poses.size() - 1);
    for (std::size_t i = 0; i + 1 < trajectory.poses.size(); ++i) {
      Step step{{trajectory.poses[i], trajectory.poses[i + 1], trajectory.interpolation}};
      step.radius = largestRadius(step.path, centre, half);
      steps->steps_.push_back(step);
    }
    return steps;
  }
  Pose poseAt(std::int64_t step, double s) const override { return steps_[step].path.poseAt(s); }
  Flow flowAt(std::int64_t step, double s) const override {
    const auto& [path, radius] = steps_[step];
    const Pose pose = path.poseAt(s);
    return {pose, path.twistAt(pose), path.fastest(radius)};
  }
  double bulge(std::int64_t step) const override {
    const auto& [path, radius] = steps_[step];
    return path.angle() * path.angle() * radius / 8;
  }

 private:
  struct Step {  // from pose i to pose i + 1
    StepPath path;
    double radius = 0;  ///< largest distance of the body's box from the rotation axis
  };
  std::vector<Step> steps_;
};

}  // namespace

double largestRadius(const StepPath& path, const Vector3d& centre, const Vector3d& half) {
  double radius = 0;
  forCorners(centre, half, [&](const Vector3d& c) { radius = std::max(radius, path.radius(c)); });
  return radius;
}

double MotionBound::advance(const Vector3d& n, const Vector3d& centre, const Vector3d& half) const {
  if (kind_ == Kind::Point) return 0;
  if (kind_ == Kind::Flow) {
    const Vector3d turn = n.cross(angular_);
    const double at = std::abs(n.dot(linear_) + turn.dot(R * centre + t));
    const double spread = (R.transpose() * turn).cwiseAbs().dot(half);
    return std::min(reach, span_ * (at + spread) + rest_);
  }
  double sum = rest_;
  const Vector3d y = centre - bodyCentre_;
  for (int column = 0; column < 4; ++column) {
    double low = 0;
    double high = 0;
    for (int row = 0; row < 3; ++row) {
      const double x = n[row] * (*low_)(row, column);
      const double z = n[row] * (*high_)(row, column);
      low += std::min(x, z);
      high += std::max(x, z);
    }
    if (column == 3) {
      sum += high;
    } else {
      const double a = y[column] - half[column];
      const double b = y[column] + half[column];
      sum += std::max(std::max(low * a, low * b), std::max(high * a, high * b));
    }
  }
  return std::min(reach, sum);
}

MotionTree::MotionTree(const Trajectory& trajectory, const Vector3d& bodyCentre,
                       const Vector3d& bodyHalf)
    : MotionTree(trajectory.poses, PathSteps::of(trajectory, bodyCentre, bodyHalf), bodyCentre,
                 bodyHalf) {}

MotionTree::MotionTree(std::vector<Pose> poses, std::unique_ptr<const MotionSteps> steps,
                       const Vector3d& bodyCentre, const Vector3d& bodyHalf)
    : poses_(std::move(poses)), steps_(std::move(steps)), centre_(bodyCentre), half_(bodyHalf) {
  const std::int64_t count = std::ssize(poses_);
  continuous_ = steps_ != nullptr;
  members_ = continuous_ ? count - 1 : count;
  affine_.reserve(poses_.size());
  for (const Pose& pose : poses_) affine_.push_back(affineOf(pose));
  order_.resize(members_);
  std::iota(order_.begin(), order_.end(), 0);
  if (members_ > 1) {
    clusters_.resize(clusterNodes(static_cast<std::int32_t>(members_)));
    buildCluster(0, 0, static_cast<std::int32_t>(members_));
  }
}

std::int32_t MotionTree::clusterNodes(std::int32_t members) {
  if (members <= kBucket) return 1;
  return 1 + clusterNodes(members / 2) + clusterNodes(members - members / 2);
}

MotionTree::Affine MotionTree::affineOf(const Pose& pose) const {
  Affine a;
  a.leftCols<3>() = pose.rotation.toRotationMatrix();
  a.col(3) = pose.rotation * centre_ + pose.translation;
  return a;
}

Pose MotionTree::poseAt(double parameter) const {
  if (!continuous_)
    return poses_[std::clamp<std::int64_t>(std::llround(parameter), 0, members_ - 1)];
  const auto i = std::clamp<std::int64_t>(static_cast<std::int64_t>(parameter), 0, members_ - 1);
  const double s = std::clamp(parameter - static_cast<double>(i), 0.0, 1.0);
  return steps_->poseAt(i, s);
}

double MotionTree::timeAt(double parameter) const { return poseAt(parameter).timeSeconds; }

void MotionTree::buildCluster(std::int32_t node, std::int32_t first, std::int32_t last) {
  Cluster& c = clusters_[node];
  c.first = first;
  c.last = last;
  Affine low = Affine::Constant(std::numeric_limits<double>::infinity());
  Affine high = -low;
  const auto eachPose = [&](auto&& f) {
    for (std::int32_t k = first; k < last; ++k) {
      f(order_[k], affine_[order_[k]]);
      if (continuous_) f(order_[k], affine_[order_[k] + 1]);
    }
  };
  eachPose([&](std::int32_t, const Affine& a) {
    low = low.cwiseMin(a);
    high = high.cwiseMax(a);
  });
  Affine weight = Affine::Ones();
  for (int k = 0; k < 3; ++k) weight.col(k) *= half_[k];
  const Affine middle = 0.5 * (low + high);
  double best = std::numeric_limits<double>::infinity();
  for (std::int32_t k = first; k < last; ++k) {
    const double d = (affine_[order_[k]] - middle).cwiseProduct(weight).squaredNorm();
    if (d < best || (d == best && order_[k] < c.representative)) {
      best = d;
      c.representative = order_[k];
    }
  }
  const Affine rep = affine_[c.representative];
  c.low = low - rep;
  c.high = high - rep;
  eachPose([&](std::int32_t member, const Affine& a) {
    const Affine d = a - rep;
    const double bulge = continuous_ ? steps_->bulge(member) : 0.0;
    c.bulge = std::max(c.bulge, bulge);
    forCorners(Vector3d::Zero(), half_, [&](const Vector3d& y) {
      c.reach = std::max(c.reach, (d.leftCols<3>() * y + d.col(3)).norm() + bulge);
    });
  });
  const std::int32_t count = last - first;
  if (count <= kBucket) return;
  int axis = 0;
  const Affine extent = (high - low).cwiseProduct(weight);
  Eigen::Map<const Eigen::Matrix<double, 12, 1>>(extent.data()).maxCoeff(&axis);
  const auto key = [&](std::int32_t i) {
    return continuous_ ? affine_[i].data()[axis] + affine_[i + 1].data()[axis]
                       : affine_[i].data()[axis];
  };
  const auto middleMember = order_.begin() + first + count / 2;
  std::nth_element(order_.begin() + first, middleMember, order_.begin() + last,
                   [&](std::int32_t a, std::int32_t b) {
                     const double x = key(a);
                     const double y = key(b);
                     return x != y ? x < y : a < b;
                   });
  const std::int32_t split = first + count / 2;
  const std::int32_t leftNode = node + 1;
  const std::int32_t rightNode = leftNode + clusterNodes(count / 2);
  c.right = rightNode;
  const auto left = [&] { buildCluster(leftNode, first, split); };
  const auto right = [&] { buildCluster(rightNode, split, last); };
  if (count > 2048) {
    tbb::parallel_invoke(left, right);
  } else {
    left();
    right();
  }
}

MotionNode MotionTree::root() const {
  MotionNode node;
  if (members_ > 1) {
    node.cluster = 0;
  } else {
    node.member = 0;
    node.to = continuous_ ? 1 : 0;
  }
  return node;
}

MotionBound MotionTree::bound(const MotionNode& node) const {
  MotionBound b;
  if (node.cluster >= 0) {
    const Cluster& c = clusters_[node.cluster];
    b.kind_ = MotionBound::Kind::Cluster;
    b.low_ = &c.low;
    b.high_ = &c.high;
    b.bodyCentre_ = centre_;
    b.reach = c.reach;
    b.parameter = c.representative;
    b.rest_ = c.bulge;
    const Pose& pose = poses_[c.representative];
    b.R = pose.rotation.toRotationMatrix();
    b.t = pose.translation;
    return b;
  }
  if (!continuous_) {
    const Pose& pose = poses_[node.member];
    b.parameter = node.member;
    b.R = pose.rotation.toRotationMatrix();
    b.t = pose.translation;
    return b;
  }
  const double middle = 0.5 * (node.from + node.to);
  const MotionSteps::Flow flow = steps_->flowAt(node.member, middle);
  b.kind_ = MotionBound::Kind::Flow;
  b.parameter = node.member + middle;
  b.R = flow.pose.rotation.toRotationMatrix();
  b.t = flow.pose.translation;
  b.linear_ = flow.twist.linear;
  b.angular_ = flow.twist.angular;
  b.span_ = 0.5 * (node.to - node.from);
  b.rest_ = 4 * b.span_ * b.span_ * steps_->bulge(node.member);
  double speed = 0;
  forCorners(centre_, half_, [&](const Vector3d& c) {
    speed = std::max(speed, (b.linear_ + b.angular_.cross(b.R * c + b.t)).norm());
  });
  b.reach = std::min(b.span_ * speed + b.rest_, b.span_ * flow.fastest);
  return b;
}

bool MotionTree::splits(const MotionNode& node) const {
  return node.cluster >= 0 || (continuous_ && node.to - node.from > 1e-12);
}

void MotionTree::split(const MotionNode& node, std::vector<MotionNode>& out) const {
  if (node.cluster < 0) {
    const double middle = 0.5 * (node.from + node.to);
    out.push_back({-1, node.member, node.from, middle});
    out.push_back({-1, node.member, middle, node.to});
    return;
  }
  const Cluster& c = clusters_[node.cluster];
  if (c.right >= 0) {
    out.push_back({node.cluster + 1, -1, 0, 0});
    out.push_back({c.right, -1, 0, 0});
    return;
  }
  for (std::int32_t k = c.first; k < c.last; ++k)
    out.push_back({-1, order_[k], 0, continuous_ ? 1.0 : 0.0});
}

void MotionTree::listMembers(const MotionNode& node, std::vector<std::int32_t>& out) const {
  if (node.cluster < 0) {
    out.push_back(node.member);
    return;
  }
  const Cluster& c = clusters_[node.cluster];
  out.insert(out.end(), order_.begin() + c.first, order_.begin() + c.last);
}

}  // namespace swept::clearance
