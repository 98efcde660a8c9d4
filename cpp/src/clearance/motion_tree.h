// Hierarchy over a motion: single poses, or steps between poses, clustered by how the body lies.
// In:    trajectory; box of the body in its own frame. Units: mm, rad.
//        The parameter of a motion is pose + s, s in [0, 1] within the step after it.
// Out:   for every node a representative pose and a bound on how far any point of the body lies
//        from where the representative puts it, also along one direction only.
// Cost:  O(n log n), about 600 bytes a pose.
// Why the corners of a box suffice: a displacement is affine in the point, so its length is convex
// and largest at a corner of any box round the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "motion/step_path.h"
#include "swept/types.h"

namespace swept::clearance {

/// A part of the motion: a cluster of members, or [from, to] of one member (a step or a pose).
struct MotionNode {
  std::int32_t cluster = -1;
  std::int32_t member = -1;
  double from = 0;
  double to = 0;
};

/// Representative pose (x_world = R x + t) and displacement bounds of one node.
struct MotionBound {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  double parameter = 0;
  double reach = 0;  ///< mm, largest displacement of any point of the body from the representative

  /// Largest advance along the unit vector n of any body point in the box (body frame).
  double advance(const Eigen::Vector3d& n, const Eigen::Vector3d& centre,
                 const Eigen::Vector3d& half) const;

 private:
  friend class MotionTree;
  enum class Kind { Point, Flow, Cluster } kind_ = Kind::Point;
  // Flow: v(x) = linear + angular x position at the representative, half a span, second-order rest.
  Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_ = Eigen::Vector3d::Zero();
  double span_ = 0;
  double rest_ = 0;
  // Cluster: intervals of the entries of (R - R_rep | shift at the body's centre) of the members.
  const Eigen::Matrix<double, 3, 4>* low_ = nullptr;
  const Eigen::Matrix<double, 3, 4>* high_ = nullptr;
  Eigen::Vector3d bodyCentre_ = Eigen::Vector3d::Zero();
};

class MotionTree {
 public:
  MotionTree(const Trajectory& trajectory, const Eigen::Vector3d& bodyCentre,
             const Eigen::Vector3d& bodyHalf);

  MotionNode root() const;
  MotionBound bound(const MotionNode& node) const;
  bool splits(const MotionNode& node) const;
  /// Appends the parts of a node that splits() says can be split.
  void split(const MotionNode& node, std::vector<MotionNode>& out) const;

  bool isContinuous() const { return continuous_; }
  std::int64_t members() const { return members_; }
  double largestParameter() const { return continuous_ ? double(members_) : double(members_ - 1); }
  Pose poseAt(double parameter) const;
  double timeAt(double parameter) const;
  const Trajectory& trajectory() const { return trajectory_; }
  /// First and last member of a node, all members of it: clusters list theirs.
  void listMembers(const MotionNode& node, std::vector<std::int32_t>& out) const;

 private:
  struct Step {  // from pose i to pose i + 1
    StepPath path;
    double radius = 0;  ///< of the body's box about the axis of the turn
    /// In the step the body leaves the chord of its two ends by at most this, mm.
    double bulge() const { return path.angle() * path.angle() * radius / 8; }
  };
  struct Cluster {
    std::int32_t first, last;  ///< members_ order, half open
    std::int32_t right = -1;   ///< second child; the first one follows; -1: children are members
    std::int32_t representative = 0;
    double reach = 0;
    double bulge = 0;  ///< largest departure of a member step from its chord, mm
    Eigen::Matrix<double, 3, 4> low, high;
  };
  using Affine = Eigen::Matrix<double, 3, 4>;

  Step makeStep(std::int64_t i) const;
  Affine affineOf(const Pose& pose) const;
  void buildCluster(std::int32_t node, std::int32_t first, std::int32_t last);
  static std::int32_t clusterNodes(std::int32_t members);

  Trajectory trajectory_;
  Eigen::Vector3d centre_;
  Eigen::Vector3d half_;
  bool continuous_ = false;
  std::int64_t members_ = 0;
  std::vector<Step> steps_;
  std::vector<Affine> affine_;       ///< per pose: R | R centre + t
  std::vector<std::int32_t> order_;  ///< members sorted into clusters
  std::vector<Cluster> clusters_;
};

}  // namespace swept::clearance
