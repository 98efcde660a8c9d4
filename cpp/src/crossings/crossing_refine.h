// Computes the exact position, normal and time of a crossing in double precision, from the element
// that made it.
//
// In: sampler input, and the lattice edge, sampled fraction and element of a crossing. Out:
// Crossing. Units: cells, seconds. Cost: O(1), a few Newton steps for side patches.
// Source: own method; docs/pipeline.md, "Crossings".
//
// A crossing on a face is the intersection of the lattice line with the plane of the face at its
// placement. A crossing on a side patch is found by Newton's method. The motion in the step is
// approximated by the chord plus a quadratic term through the exact midpoint:
//   x(s) = (1-s) p + s q + 4 s (1-s) m,  m = x_mid - (p + q) / 2.
// The error of x(s) is of third order in the angle by which the body turns during the step. If
// Newton's method ends beside the line, damped steps search for the nearest point of the patch
// (Levenberg 1944, Marquardt 1963).
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
  /// Refines a crossing of the lattice edge (axis, i, j, k). `fraction`: position on the edge that
  /// the sampler found. `low`: true if the crossing is seen from the low end. `exactSeconds`, if
  /// given, receives the time in double.
  Crossing refine(int axis, std::int32_t i, std::int32_t j, std::int32_t k, float fraction,
                  std::uint32_t element, bool low, double* exactSeconds = nullptr) const;

 private:
  struct Hit {
    double along;
    Eigen::Vector3d normal;
    double timeSeconds;
    /// For a side patch: distance (cells) between the lattice line and the point found.
    double offLine = 0;
  };
  Hit onFace(const SweptElement& element, int axis, const Eigen::Vector3d& line) const;
  Hit onSidePatch(const SweptElement& element, int axis, const Eigen::Vector3d& line) const;
  /// Returns the time at which the edge of a side patch passes nearest to a point. Used for the few
  /// crossings for which Newton's method fails.
  double nearestTime(const SweptElement& element, const Eigen::Vector3d& point) const;

  const SamplerInput& input_;
  const MarkedEdges& marked_;
  std::vector<Placement> placements_;  // from body coordinates (mm) to grid coordinates (cells)
  std::vector<Placement> bulges_;      // per step: m (see above) as an affine map, in cells
};

}  // namespace swept
