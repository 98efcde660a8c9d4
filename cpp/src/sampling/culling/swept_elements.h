// Which faces and side patches of the swept surface have to be sampled, step by step.
//
// A face that moves outward at all its points throughout a step is +1, inward -1, else 0. With the
// chord motion of the step, points p + s d(p): a face is +1 when n(s) . d > 0 at its corners for
// all s (n is quadratic in s; the margin covers its middle coefficient, snapping and rounding).
//   A face copy at placement k is enclosed if it moved the same way (+1,+1 or -1,-1) before and
//   after k: it lies between the two prisms. For closed, outward oriented bodies also if it moves
//   outward after k (prism outside, body inside), or moved inward before k.
//   A side patch is enclosed if both faces at its edge move the same way in the step.
// Clusters of faces are decided as a whole where their normal cone and ball allow it.
// Source: docs/pipeline.md, "Culling"; the argument needs only closed bodies of positive volume on
// both sides of the dropped piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/culling/face_clusters.h"
#include "sampling/sampler.h"

namespace swept {

/// Directions of all faces during one step; buffers are reused from step to step.
class FaceDirections {
 public:
  FaceDirections(const SamplerInput& input, const FaceClusters& clusters);
  /// Decides the step placements[k] -> placements[k + 1].
  void compute(std::size_t step);

  /// -1, 0 (mixed, or known only face by face) or +1.
  int ofCluster(std::size_t cluster) const { return clusterDirection_[cluster]; }
  int ofFace(std::size_t face) const { return ofPlace(clusters_->placeOf[face]); }
  /// By its place in FaceClusters::faces.
  int ofPlace(std::size_t place) const { return placeDirection_[place]; }

 private:
  struct Step;
  int decideCluster(const FaceCluster& cluster, const Step& step) const;
  int decideBall(const FaceClusters::FaceBall& ball, const Step& step) const;
  int decideFace(std::size_t face, const Step& step) const;

  const SamplerInput* input_;
  const FaceClusters* clusters_;
  double farthest_ = 0;  // mm, of the body from its origin
  std::vector<std::int8_t> clusterDirection_, placeDirection_;
};

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable);
bool patchIsEnclosed(const BodyEdge& edge, const FaceDirections& directions);

}  // namespace swept
