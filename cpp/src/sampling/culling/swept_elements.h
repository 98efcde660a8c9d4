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

/// Directions of all faces during one step; the buffers are reused from step to step.
class FaceDirections {
 public:
  FaceDirections(const SamplerInput& input, const FaceClusters& clusters);
  /// Computes the step placements[k] -> placements[k + 1].
  void compute(std::size_t step);

  /// -1, 0 (mixed, or known only face by face) or +1.
  int ofCluster(std::size_t cluster) const { return clusterDirection_[cluster]; }
  int ofFace(std::size_t face) const { return ofIndex(clusters_->indexOf[face]); }
  /// The same for a face, by its index in FaceClusters::faces.
  int ofIndex(std::size_t index) const { return faceDirection_[index]; }

 private:
  struct Step;
  int decideCluster(const FaceCluster& cluster, const Step& step) const;
  int decideBall(const FaceClusters::FaceBall& ball, const Step& step) const;
  int decideFace(std::size_t face, const Step& step) const;

  const SamplerInput* input_;
  const FaceClusters* clusters_;
  double farthest_ = 0;  // mm, farthest point of the body from its origin
  std::vector<std::int8_t> clusterDirection_, faceDirection_;
};

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable);
bool patchIsEnclosed(const BodyEdge& edge, const FaceDirections& directions);

}  // namespace swept
