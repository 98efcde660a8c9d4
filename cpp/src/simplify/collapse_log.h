// What an edge collapse did, step by step, to take back steps at a few places where the surface
// turns out to lie too far off: the rest stays as it is.
// Units: mm. Memory: about 200 bytes a step. Cost of taking back: O(steps).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simplify/collapse.h"

namespace swept {

class CollapseLog {
 public:
  using Corners = std::array<std::int32_t, 3>;

  /// `from` went into `to`, which was at `place`; triangles that stayed, their corners before, and
  /// those that went.
  void add(std::int32_t from, std::int32_t to, const Eigen::Vector3d& place,
           const std::vector<std::int32_t>& staying, const std::vector<Corners>& corners,
           const std::vector<std::int32_t>& going);
  void append(const CollapseLog& later);

  /// Takes back the last `depth` steps at each of the triangles, and all later ones that build on
  /// them. Points that were attached to their triangles find the nearest of those that are there
  /// again. Returns the triangles that have changed, rising; empty: no step has touched any.
  std::vector<std::int32_t> takeBack(CollapseState& state,
                                     const std::vector<std::int32_t>& triangles, int depth);

 private:
  struct Step {
    std::int32_t from, to;
    Eigen::Vector3d place;
    std::size_t first;  ///< in triangles_; the corners of those that stayed follow the same order
    std::int32_t staying, going;
  };
  template <class Visit>
  void forTriangles(const Step& step, const Visit& visit) const;
  std::vector<char> chosenSteps(const std::vector<std::int32_t>& triangles, int depth,
                                std::vector<char>& dirty) const;
  void takeBack(CollapseState& state, const Step& step) const;

  std::vector<Step> steps_;
  std::vector<std::int32_t> triangles_;  ///< of each step: those that stayed, those that went
  std::vector<Corners> corners_;         ///< in step with triangles_; unused for those that went
};

}  // namespace swept
