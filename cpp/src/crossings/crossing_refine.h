// Exact position, normal and time of a crossing, in double, from the element that made it.
//
// In: sampler input, and the lattice edge, sampled fraction and element of a crossing. Out:
// Crossing. Units: cells, seconds. Cost: O(1), a few Newton steps for side patches.
// Source: METHOD.md section 2, "crossing positions" and "ruled side patches".
//
// Face: intersection of the lattice line with the face's plane at its placement. Side patch:
// Newton's method on the motion of the step, which is the chord plus a quadratic through the exact
// midpoint,
//   x(s) = (1-s) p + s q + 4 s (1-s) m,  m = x_mid - (p + q) / 2,
// with an error of third order in the turn of the step. Where Newton's method ends beside the line,
// the nearest point of the patch is searched with damped steps (Levenberg 1944, Marquardt 1963).
// The normal is edge x velocity.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"

namespace swept {

class CrossingRefiner {
 public:
  CrossingRefiner(const SamplerInput& input, const MarkedEdges& marked);
  /// axis, (i, j, k): the lattice edge. fraction: where the sampler found the crossing. low:
  /// whether it is the one seen from the low end. exactSeconds, if given, receives the time with
  /// all digits.
  Crossing refine(int axis, std::int32_t i, std::int32_t j, std::int32_t k, float fraction,
                  std::uint32_t element, bool low, double* exactSeconds = nullptr) const;

 private:
  struct Hit {
    double along;
    Eigen::Vector3d normal;
    double timeSeconds;
    double offLine = 0;  ///< cells, of a side patch: where Newton's method ended, from the line
  };
  Hit onFace(const SweptElement& element, int axis, const Eigen::Vector3d& line) const;
  Hit onSidePatch(const SweptElement& element, int axis, const Eigen::Vector3d& line) const;
  /// When the edge of a side patch passes nearest to a point; for the few crossings where Newton's
  /// method finds none.
  double nearestTime(const SweptElement& element, const Eigen::Vector3d& point) const;

  const SamplerInput& input_;
  const MarkedEdges& marked_;
  std::vector<Placement> placements_;  // with results in cells
  std::vector<Placement> bulges_;      // m as an affine map, with results in cells
};

}  // namespace swept
