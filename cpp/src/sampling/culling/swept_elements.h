// Which faces and side patches of the swept surface have to be sampled, step by step.
//
// In: body, motion, clusters. Out: a direction per face and step. Units: mm. Cost: O(clusters), and
// O(faces) where a cluster is mixed.
// Promise: what is dropped is enclosed; the argument needs only bodies that are closed and have
// positive volume on both sides of the dropped piece.
// Source: METHOD.md section 2, "every face of every prism is sent"; docs/pipeline.md, "Culling".
//
// A face that moves outward at all its points throughout a step has direction +1, inward -1,
// otherwise 0. During the chord motion of the step, points are p + s d(p); a face has +1 if n(s) .
// d > 0 at its corners for all s. (n is quadratic in s; a margin covers its middle coefficient,
// snapping and rounding.)
//   A face copy at placement k is enclosed if it has the same direction (+1,+1 or -1,-1) before and
//   after k: it lies between the two prisms. For closed bodies that are oriented outward it is also
//   enclosed if it moves outward after k (prism outside, body inside), or inward before k.
//   A side patch is enclosed if both faces at its edge have the same direction in the step.
// Clusters of faces are decided as a whole where their normal cone and ball allow it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/culling/face_clusters.h"
#include "sampling/sampler.h"

namespace swept {

/// The step placements[k] -> placements[k + 1] as seen from the body at its start: a point p moves
/// by bend * p + shift.
struct MotionStep {
  MotionStep() = default;
  MotionStep(const SamplerInput& input, std::size_t k);

  Eigen::Matrix3d bend, turnBack;
  Eigen::Vector3d shift;
  double angle = 0;  ///< rad, at least the turn of the step
  double snap = 0;   ///< mm
};

/// The direction of one face during a step.
int directionOf(const SamplerInput& input, const MotionStep& step, std::size_t face);

/// Directions of faces during one step, each cluster and each face decided when it is first asked
/// for; the buffers are reused from step to step. Not for several threads at a time.
class FaceDirections {
 public:
  FaceDirections(const SamplerInput& input, const FaceClusters& clusters);
  /// From now on the step is placements[k] -> placements[k + 1].
  void setStep(std::size_t k);

  /// -1, 0 (mixed, or known only face by face) or +1.
  int ofCluster(std::size_t cluster) const {
    if (decidedAt_[cluster] != stamp_) decide(cluster);
    return clusterDirection_[cluster];
  }
  int ofFace(std::size_t face) const {
    ofCluster(clusters_->clusterOf[face]);
    return ofIndex(clusters_->indexOf[face]);
  }
  /// The same for a face, by its index in FaceClusters::faces; its cluster has been asked for.
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
  double farthest_ = 0;  // mm, farthest point of the body from its origin
  MotionStep step_;
  Eigen::Matrix3f bendFloat_, turnBackFloat_;
  Eigen::Vector3f shiftFloat_;
  float rounding_ = 0;                            // mm: rounding of a displacement in float
  std::uint32_t stamp_ = 0;                       // number of the step, in the order of setStep()
  mutable std::vector<std::uint32_t> decidedAt_;  // per cluster: stamp of the step it is known for
  mutable std::vector<std::int8_t> clusterDirection_, faceDirection_;
};

/// Snapping moves a corner by at most this many cells along each axis.
constexpr double kSnapCells = 0x1p-17;
/// Of a displacement: the normals are 32-bit floats, with room to spare.
constexpr double kNormalRounding = 1e-6;
/// Snapping the corners turns the normal of a triangle of this height (mm) by at most about this
/// angle.
double snapAngle(double height, double cell);

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable);
bool patchIsEnclosed(const BodyEdge& edge, const FaceDirections& directions);

}  // namespace swept
