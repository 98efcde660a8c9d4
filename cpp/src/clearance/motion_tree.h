// Hierarchy over a motion: single poses, or steps between poses, clustered by how the body lies.
// In:    trajectory; box of the body in its own frame. Units: mm, rad.
//        The parameter of a motion is pose + s, s in [0, 1] within the step after it.
// Out:   for every node a representative pose and a bound on how far any point of the body lies
//        from where the representative puts it, also along one direction only.
// Cost:  O(n log n), about 600 bytes a pose.
// The steps are asked through MotionSteps: those of one body in the world, or of one moving body as
// seen from another one (relative_motion.h).
// Why the corners of a box suffice: a displacement is affine in the point, so its length is convex
// and largest at a corner of any box round the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "motion/step_path.h"
#include "swept/types.h"

namespace swept::clearance {

/// What a hierarchy has to know of the steps between successive poses; s in [0, 1] within a step.
/// The body is the box that the hierarchy was given.
class MotionSteps {
 public:
  struct Flow {
    Pose pose;       ///< at s
    Twist twist;     ///< at s, per unit of s, in the frame of the poses
    double fastest;  ///< mm per unit of s, of any point, anywhere in the step
  };
  virtual ~MotionSteps() = default;
  virtual Pose poseAt(std::int64_t step, double s) const = 0;
  virtual Flow flowAt(std::int64_t step, double s) const = 0;
  /// In the step no point leaves the chord of its two ends by more than this, mm: an eighth of the
  /// largest acceleration.
  virtual double bulge(std::int64_t step) const = 0;
};

/// f(corner) for the eight corners of a box.
template <typename F>
void forCorners(const Eigen::Vector3d& centre, const Eigen::Vector3d& half, F&& f) {
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    f(Eigen::Vector3d(centre + half.cwiseProduct(sign)));
  }
}

/// mm, how far a corner of the box (body frame) lies from the line that the step turns about.
double largestRadius(const StepPath& path, const Eigen::Vector3d& centre,
                     const Eigen::Vector3d& half);

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
  /// `poses`: at the ends of the steps, one more than there are steps; two or more.
  MotionTree(std::vector<Pose> poses, std::unique_ptr<const MotionSteps> steps,
             const Eigen::Vector3d& bodyCentre, const Eigen::Vector3d& bodyHalf);

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
  const std::vector<Pose>& poses() const { return poses_; }
  /// First and last member of a node, all members of it: clusters list theirs.
  void listMembers(const MotionNode& node, std::vector<std::int32_t>& out) const;

 private:
  struct Cluster {
    std::int32_t first, last;  ///< members_ order, half open
    std::int32_t right = -1;   ///< second child; the first one follows; -1: children are members
    std::int32_t representative = 0;
    double reach = 0;
    double bulge = 0;  ///< largest departure of a member step from its chord, mm
    Eigen::Matrix<double, 3, 4> low, high;
  };
  using Affine = Eigen::Matrix<double, 3, 4>;

  Affine affineOf(const Pose& pose) const;
  void buildCluster(std::int32_t node, std::int32_t first, std::int32_t last);
  static std::int32_t clusterNodes(std::int32_t members);

  std::vector<Pose> poses_;
  std::unique_ptr<const MotionSteps> steps_;  ///< none: single poses
  Eigen::Vector3d centre_;
  Eigen::Vector3d half_;
  bool continuous_ = false;
  std::int64_t members_ = 0;
  std::vector<Affine> affine_;       ///< per pose: R | R centre + t
  std::vector<std::int32_t> order_;  ///< members sorted into clusters
  std::vector<Cluster> clusters_;
};

}  // namespace swept::clearance
