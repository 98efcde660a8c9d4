// Records the steps of edge collapses, so that steps can be undone where the surface deviates too
// far, while the rest of the surface stays unchanged.
// Units:   mm.
// Cost:    about 200 bytes per step; undoing takes O(steps).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simplify/collapse.h"

namespace swept {

/// Returns whether a triangle has the vertex `v` as a corner.
inline bool has(const std::array<std::int32_t, 3>& triangle, std::int32_t v) {
  return triangle[0] == v || triangle[1] == v || triangle[2] == v;
}

class CollapseLog {
 public:
  using Corners = std::array<std::int32_t, 3>;

  /// Records that vertex `from` was merged into `to`, whose position was `position` before.
  /// `remaining`: the triangles that remain; `corners`: their vertices before the step; `removed`:
  /// the removed triangles.
  void add(std::int32_t from, std::int32_t to, const Eigen::Vector3d& position,
           const std::vector<std::int32_t>& remaining, const std::vector<Corners>& corners,
           const std::vector<std::int32_t>& removed);
  void append(const CollapseLog& later);

  /// Undoes the last `depth` steps at each of the triangles, and all later steps that depend on
  /// these. Points that were attached to the changed triangles move to the nearest restored
  /// triangle. Returns the changed triangles in ascending order; empty if no step changed any of
  /// `triangles`.
  std::vector<std::int32_t> takeBack(CollapseState& state,
                                     const std::vector<std::int32_t>& triangles, int depth);

 private:
  struct Step {
    std::int32_t from, to;
    Eigen::Vector3d position;
    std::size_t first;  ///< index in triangles_ and corners_ of the first remaining triangle
    std::int32_t remaining, removed;
  };
  template <class Visit>
  void forTriangles(const Step& step, const Visit& visit) const;
  std::vector<char> chosenSteps(const std::vector<std::int32_t>& triangles, int depth,
                                std::vector<char>& dirty) const;
  void takeBack(CollapseState& state, const Step& step) const;

  std::vector<Step> steps_;
  /// For each step: the remaining triangles, then the removed ones.
  std::vector<std::int32_t> triangles_;
  std::vector<Corners> corners_;  ///< parallel to triangles_; unused for the removed ones
};

}  // namespace swept
