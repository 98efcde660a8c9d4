// Decides for each step which faces and side patches of the swept surface must be sampled.
//
// In: body, motion, clusters. Out: a direction per face and step. Units: mm.
// Cost: O(clusters), plus O(faces) for undecided clusters.
// Promise: a dropped element is enclosed by the swept volume: on both sides of it, there is a part
//        of the swept volume with a thickness above 0. The proof only requires a closed body.
// Source: docs/pipeline.md, "Culling".
//
// A face has direction +1 if all its points move outward during a whole step, -1 if all move
// inward, otherwise 0. In a step with straight paths, a point p of the body is at p + s d(p), with
// s from 0 to 1. The direction is +1 if n(s) . d > 0 at all corners for all s, where n(s) is the
// normal. (n is quadratic in s. A margin covers its middle coefficient, snapping and rounding.)
//   A copy of a face at placement k is enclosed if it has the same direction, +1 or -1, before and
//   after k: it lies between the two prisms that the face sweeps. For closed bodies with outward
//   normals it is also enclosed if it moves outward after k (prism outside, body inside), or inward
//   before k.
//   A side patch is enclosed if both faces at its edge have the same direction in the step.
// Clusters of faces are decided as a whole if their normal cone and ball allow it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/culling/face_clusters.h"
#include "sampling/sampler.h"

namespace swept {

/// Returns the clusters of the input. If the input has none, builds them in `own`.
const FaceClusters& clustersOf(const SamplerInput& input, FaceClusters& own);

/// The step placements[k] -> placements[k + 1] in coordinates of the body at its start: a point p
/// moves by bend * p + shift.
struct MotionStep {
  MotionStep() = default;
  MotionStep(const SamplerInput& input, std::size_t k);

  Eigen::Matrix3d bend, turnBack;  ///< turnBack: inverse of the turn of the step
  Eigen::Vector3d shift;
  double angle = 0;  ///< rad, upper bound of the turn
  double snap = 0;   ///< mm, bound on the change of a displacement by snapping
};

/// Returns a bound (mm) on the rounding of a displacement in single precision. `farthest`: largest
/// distance (mm) of a body point from the origin of the body.
float displacementRounding(const MotionStep& step, double farthest);

/// Returns the direction of one face during a step.
int directionOf(const SamplerInput& input, const MotionStep& step, std::size_t face);

/// Directions of faces during one step. Each cluster and face is decided at its first query. The
/// buffers are reused for the next step. Not safe for several threads at a time.
class FaceDirections {
 public:
  FaceDirections(const SamplerInput& input, const FaceClusters& clusters);
  /// Changes the step to placements[k] -> placements[k + 1].
  void setStep(std::size_t k);

  /// Returns the direction of a whole cluster, -1 or +1. Returns 0 if its faces have no common
  /// direction, or if only single faces can be decided.
  int ofCluster(std::size_t cluster) const {
    if (decidedAt_[cluster] != stamp_) decide(cluster);
    return clusterDirection_[cluster];
  }
  int ofFace(std::size_t face) const {
    ofCluster(clusters_->clusterOf[face]);
    return ofIndex(clusters_->indexOf[face]);
  }
  /// Returns the direction of the face with this index in FaceClusters::faces. Call ofCluster() for
  /// its cluster first.
  int ofIndex(std::size_t index) const {
    if (faceDirection_[index] == kNotDecided) decideFace(index);
    return faceDirection_[index];
  }

 private:
  static constexpr std::int8_t kNotDecided = 2;
  void decide(std::size_t cluster) const;
  void decideFace(std::size_t index) const;
  int decideCluster(const FaceCluster& cluster) const;
  int decideBall(const FaceClusters::FaceBall& ball) const;

  const SamplerInput* input_;
  const FaceClusters* clusters_;
  double farthest_ = 0;  // mm, distance of the farthest vertex of the body from its origin
  MotionStep step_;
  Eigen::Matrix3f bendFloat_, turnBackFloat_;
  Eigen::Vector3f shiftFloat_;
  float rounding_ = 0;                            // mm: rounding of a displacement in float
  std::uint32_t stamp_ = 0;                       // counts the calls of setStep()
  mutable std::vector<std::uint32_t> decidedAt_;  // per cluster: the stamp_ at which it was decided
  mutable std::vector<std::int8_t> clusterDirection_, faceDirection_;
};

/// Snapping moves a corner by at most this many cells along each axis.
constexpr double kSnapCells = 0x1p-17;
/// Error of n . d from normals in 32-bit floats, as a fraction of |d|; includes a safety factor.
constexpr double kNormalRounding = 1e-6;
/// Returns an approximate bound of the angle by which snapping the corners turns the normal of a
/// triangle. `height`: the smallest height of the triangle (mm).
double snapAngle(double height, double cell);

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable);
bool patchIsEnclosed(const BodyEdge& edge, const FaceDirections& directions);

}  // namespace swept
