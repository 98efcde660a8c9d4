// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/motion_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swept::clearance {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kBucket = 4;  // members of a cluster without child clusters

template <typename F>
void forCorners(const Vector3d& centre, const Vector3d& half, F&& f) {
  for (int k = 0; k < 8; ++k)
    f(Vector3d(centre +
               half.cwiseProduct(Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1))));
}

}  // namespace

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
    : trajectory_(trajectory), centre_(bodyCentre), half_(bodyHalf) {
  const auto poses = static_cast<std::int64_t>(trajectory_.poses.size());
  continuous_ = trajectory_.interpolation != Interpolation::None && poses > 1;
  members_ = continuous_ ? poses - 1 : poses;
  affine_.reserve(trajectory_.poses.size());
  for (const Pose& pose : trajectory_.poses) affine_.push_back(affineOf(pose));
  if (continuous_) {
    steps_.reserve(members_);
    for (std::int64_t i = 0; i < members_; ++i) steps_.push_back(makeStep(i));
  }
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

MotionTree::Step MotionTree::makeStep(std::int64_t i) const {
  Step step{{trajectory_.poses[i], trajectory_.poses[i + 1], trajectory_.interpolation}};
  forCorners(centre_, half_,
             [&](const Vector3d& c) { step.radius = std::max(step.radius, step.path.radius(c)); });
  return step;
}

Pose MotionTree::poseAt(double parameter) const {
  if (!continuous_)
    return trajectory_.poses[std::clamp<std::int64_t>(std::llround(parameter), 0, members_ - 1)];
  const auto i = std::clamp<std::int64_t>(static_cast<std::int64_t>(parameter), 0, members_ - 1);
  const double s = std::clamp(parameter - static_cast<double>(i), 0.0, 1.0);
  return steps_[i].path.poseAt(s);
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
    const double bulge = continuous_ ? steps_[member].bulge() : 0.0;
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
    const Pose& pose = trajectory_.poses[c.representative];
    b.R = pose.rotation.toRotationMatrix();
    b.t = pose.translation;
    return b;
  }
  if (!continuous_) {
    const Pose& pose = trajectory_.poses[node.member];
    b.parameter = node.member;
    b.R = pose.rotation.toRotationMatrix();
    b.t = pose.translation;
    return b;
  }
  const Step& step = steps_[node.member];
  const double middle = 0.5 * (node.from + node.to);
  const Pose pose = step.path.poseAt(middle);
  b.kind_ = MotionBound::Kind::Flow;
  b.parameter = node.member + middle;
  b.R = pose.rotation.toRotationMatrix();
  b.t = pose.translation;
  const double angle = step.path.angle();
  b.angular_ = angle * step.path.axis();
  const Vector3d shift =
      trajectory_.poses[node.member + 1].translation - trajectory_.poses[node.member].translation;
  const bool screw = step.path.isScrew();
  b.linear_ =
      screw
          ? Vector3d(step.path.pitch() * step.path.axis() - b.angular_.cross(step.path.axisPoint()))
          : Vector3d(shift - b.angular_.cross(pose.translation));
  b.span_ = 0.5 * (node.to - node.from);
  b.rest_ = 4 * b.span_ * b.span_ * step.bulge();
  double speed = 0;
  forCorners(centre_, half_, [&](const Vector3d& c) {
    speed = std::max(speed, (b.linear_ + b.angular_.cross(b.R * c + b.t)).norm());
  });
  const double everywhere = screw ? std::hypot(step.path.pitch(), angle * step.radius)
                                  : shift.norm() + angle * step.radius;
  b.reach = std::min(b.span_ * speed + b.rest_, b.span_ * everywhere);
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
