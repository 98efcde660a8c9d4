// Casts short segments at everything that a motion sweeps, with a tree over the placements and a
// tree over the triangles of the body.
//
// In: body and motion. Out: for a segment, the elements that it may hit, roughly the nearest first.
// Units: grid coordinates for segments; mm inside.
// Cost: O(triangles + placements log placements) to build. A search looks at pairs of a group of
// placements and a box of triangles. It leaves out pairs that lie behind the best hit so far, so it
// takes about the same time for one copy of a surface and for thousands of copies one behind the
// other.
// Promise: no element before the best hit is missed. The same order for any number of threads.
// Source: METHOD.md section 2, "Dense motions", space-time subdivision.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/box_tree.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"

namespace swept {

class MotionRays {
 public:
  /// `input` must outlive this object.
  explicit MotionRays(const SamplerInput& input);

  /// Tries an element. Returns the share of the segment up to the best hit so far, or a number
  /// above 1 without a hit. The elements of a pair (triangle, step) are the copy of the triangle at
  /// the start of the step, and the side patches of its edges during the step.
  using Try = std::function<double(std::uint32_t triangle, std::uint32_t placement)>;
  void search(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double best,
              const Try& tryPair) const;

 private:
  friend class RaySearch;
  /// A group of similar placements: how far they, and the ends of their steps, carry a point of the
  /// body from where the placement `middle` carries it.
  struct Group {
    std::uint32_t first = 0, end = 0;  // range of order_
    std::uint32_t middle = 0;
    std::int32_t child = -1;  // the first of two groups; -1: none
    double placeSpread = 0;   // mm, at the centre of the body
    double turnSpread = 0;    // further mm per mm of distance from the centre
  };
  void divide(std::size_t group);

  const SamplerInput& input_;
  BoxTree triangles_;
  double radius_ = 0;  // mm, of the body about its centre
  std::vector<std::uint32_t> order_;
  std::vector<Group> groups_;
};

}  // namespace swept
