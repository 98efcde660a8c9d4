// Exact position, normal and time of a crossing, in double, from the element that won it.
//
// Face: the line against the face's plane at its placement. Side patch: Newton on the true motion,
// which within one step is the chord plus a quadratic through the exact midpoint,
//   x(s) = (1-s) p + s q + 4 s (1-s) m,  m = x_mid - (p + q) / 2   (error of third order in the
//   turn);
// the normal is edge x velocity.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"

namespace swept {

class CrossingRefiner {
 public:
  CrossingRefiner(const SamplerInput& input, const MarkedEdges& marked);
  /// axis, (i, j, k): the lattice edge; fraction: where the sampler saw it; low: seen from the low
  /// end.
  Crossing refine(int axis, std::int32_t i, std::int32_t j, std::int32_t k, float fraction,
                  std::uint32_t element, bool low) const;

 private:
  struct Hit {
    double along;
    Eigen::Vector3d normal;
    double timeSeconds;
  };
  Hit onFace(const SweptElement& element, int axis, const Eigen::Vector3d& line) const;
  Hit onPatch(const SweptElement& element, int axis, const Eigen::Vector3d& line) const;

  const SamplerInput& input_;
  const MarkedEdges& marked_;
  std::vector<Placement> placements_;  // in cells
  std::vector<Placement> bulges_;      // m as an affine map, in cells
};

}  // namespace swept
