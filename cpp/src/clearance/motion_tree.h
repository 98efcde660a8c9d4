// A binary tree over a motion. Its nodes are clusters of similar placements. The members of a
// cluster are steps between poses or, without interpolation, single poses.
// In:      trajectory; box of the body in its own frame. The parameter of a motion is pose index +
//        s, where s in [0, 1] is the fraction of the step after that pose.
// Out:     for each node a representative pose, and bounds on the displacement of any point of the
//          body from its position at that pose: in all directions, and along one direction.
// Units:   mm, rad.
// Cost:    O(n log n) for n poses, about 600 bytes per pose.
// The class MotionSteps supplies the steps: those of one body in the world, or those of one moving
// body relative to another (relative_motion.h).
// Why:     For the bounds, the corners of a box suffice. A displacement is an affine function of
// the point, so its length is convex and largest at a corner of any box that contains the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "motion/step_path.h"
#include "swept/types.h"

namespace swept::clearance {

/// Steps between successive poses, for the tree. s in [0, 1] is the fraction of a step. All bounds
/// hold for the box of the body from which the tree is built.
class MotionSteps {
 public:
  struct Flow {
    Pose pose;       ///< at s
    Twist twist;     ///< at s, per unit of s, in the frame of the poses
    double fastest;  ///< mm per unit of s, upper bound of the speed of any point in the whole step
  };
  virtual ~MotionSteps() = default;
  virtual Pose poseAt(std::int64_t step, double s) const = 0;
  virtual Flow flowAt(std::int64_t step, double s) const = 0;
  /// Returns an upper bound (mm) of how far any point deviates in the step from the chord between
  /// its two end positions. The bound is an eighth of the largest acceleration, in mm per unit of s
  /// squared.
  virtual double bulge(std::int64_t step) const = 0;
};

/// Calls f(corner) for the eight corners of a box.
template <typename F>
void forCorners(const Eigen::Vector3d& centre, const Eigen::Vector3d& half, F&& f) {
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    f(Eigen::Vector3d(centre + half.cwiseProduct(sign)));
  }
}

/// Returns the largest distance (mm) of a corner of the box (body frame) from the rotation axis of
/// the step.
double largestRadius(const StepPath& path, const Eigen::Vector3d& centre,
                     const Eigen::Vector3d& half);

/// A node: a cluster of members, or the part [from, to] of one member. A member is a step or,
/// without interpolation, a single pose.
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
  /// mm, largest displacement of any point from its position at the representative pose
  double reach = 0;

  /// Returns how far any body point in the given box (body frame) can advance along the unit vector
  /// n.
  double advance(const Eigen::Vector3d& n, const Eigen::Vector3d& centre,
                 const Eigen::Vector3d& half) const;

 private:
  friend class MotionTree;
  enum class Kind { Point, Flow, Cluster } kind_ = Kind::Point;
  // If kind_ is Flow: a point x has the velocity linear_ + angular_.cross(x) at the representative
  // pose. span_ is half of the span. rest_ bounds how far a point deviates from its tangent.
  Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_ = Eigen::Vector3d::Zero();
  double span_ = 0;
  double rest_ = 0;
  // If kind_ is Cluster: the interval of each matrix entry over all members. Columns 0 to 2 are R -
  // R_rep (R_rep: rotation of the representative), column 3 is the displacement of the body's
  // centre.
  const Eigen::Matrix<double, 3, 4>* low_ = nullptr;
  const Eigen::Matrix<double, 3, 4>* high_ = nullptr;
  Eigen::Vector3d bodyCentre_ = Eigen::Vector3d::Zero();
};

class MotionTree {
 public:
  MotionTree(const Trajectory& trajectory, const Eigen::Vector3d& bodyCentre,
             const Eigen::Vector3d& bodyHalf);
  /// `poses`: the ends of the steps, at least two. There is one pose more than there are steps.
  MotionTree(std::vector<Pose> poses, std::unique_ptr<const MotionSteps> steps,
             const Eigen::Vector3d& bodyCentre, const Eigen::Vector3d& bodyHalf);

  MotionNode root() const;
  MotionBound bound(const MotionNode& node) const;
  bool splits(const MotionNode& node) const;
  /// Appends the children of a node. Call it only if splits(node).
  void split(const MotionNode& node, std::vector<MotionNode>& out) const;

  bool isContinuous() const { return continuous_; }
  std::int64_t members() const { return members_; }
  double largestParameter() const { return continuous_ ? double(members_) : double(members_ - 1); }
  Pose poseAt(double parameter) const;
  double timeAt(double parameter) const;
  const std::vector<Pose>& poses() const { return poses_; }
  /// Appends all members of a node.
  void listMembers(const MotionNode& node, std::vector<std::int32_t>& out) const;

 private:
  struct Cluster {
    std::int32_t first, last;  ///< range of order_, half open
    /// Index of the second child; the first child is the next node. -1: the cluster has no
    /// children.
    std::int32_t right = -1;
    std::int32_t representative = 0;
    double reach = 0;
    double bulge = 0;  ///< mm, largest deviation of a member step from its chord
    Eigen::Matrix<double, 3, 4> low, high;
  };
  using Affine = Eigen::Matrix<double, 3, 4>;

  Affine affineOf(const Pose& pose) const;
  void buildCluster(std::int32_t node, std::int32_t first, std::int32_t last);
  static std::int32_t clusterNodes(std::int32_t members);

  std::vector<Pose> poses_;
  std::unique_ptr<const MotionSteps> steps_;  ///< nullptr: only single poses, no interpolation
  Eigen::Vector3d centre_;
  Eigen::Vector3d half_;
  bool continuous_ = false;
  std::int64_t members_ = 0;
  std::vector<Affine> affine_;       ///< for each pose the columns R | R centre + t
  std::vector<std::int32_t> order_;  ///< members, sorted by cluster
  std::vector<Cluster> clusters_;
};

}  // namespace swept::clearance
