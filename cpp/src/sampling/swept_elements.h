// Which faces and side patches of the swept surface have to be sampled, step by step.
//
// A face that moves outward at all its points throughout a step is +1, inward -1, else 0. With the
// chord motion of the step, points p + s d(p): a face is +1 when n(s) . d > 0 at its corners for
// all s (n is quadratic in s; the margin covers its middle coefficient, snapping and rounding).
//   A face copy at placement k is enclosed if it moved the same way (+1,+1 or -1,-1) before and
//   after k: it lies between the two prisms. For closed, outward oriented bodies also if it moves
//   outward after k (prism outside, body inside), or moved inward before k.
//   A side patch is enclosed if both faces at its edge move the same way in the step.
// Source: docs/pipeline.md, "Culling"; the argument needs only closed bodies of positive volume on
// both sides of the dropped piece.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/sampler.h"

namespace swept {

/// Direction of every face during one step, reusable buffers.
class FaceDirections {
 public:
  explicit FaceDirections(const SamplerInput& input);
  /// Fills out[f] with -1, 0 or +1 for the step placements[k] -> placements[k + 1].
  void compute(std::size_t step, std::vector<std::int8_t>& out);

 private:
  const SamplerInput& input_;
  Eigen::Vector3d centre_;
  std::vector<float> slack_;            // per face
  std::vector<Eigen::Vector3f> local_;  // vertices about the centre
  std::vector<Eigen::Vector3f> before_,
      after_;  // displacement in the frame of k, turned back by the step
};

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable);
bool patchIsEnclosed(const BodyEdge& edge, const std::vector<std::int8_t>& directions);

}  // namespace swept
