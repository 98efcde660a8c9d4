// Leaf cells, their components and vertices, and for every crossing the four components round it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "data/hermite_grid.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A segment on an ambiguous face: its two crossings and the sides of their quads that it is.
struct FaceSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  bool firstOfFace = false;
};

struct DualVertex {
  Eigen::Vector3f local;             ///< in the cell, [0, 1]^3
  std::int16_t i = 0, j = 0, k = 0;  ///< cell
  float timeSeconds = 0;
};

struct DualSurface {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::vector<DualVertex>> vertices;  ///< per cell layer
  std::vector<std::uint32_t> firstVertex;         ///< per cell layer, one past the end at last
  /// Per crossing: vertices (index within their cell layer) of the cells round its edge, counted as
  /// quadCorner() does; kNone where a component method left one out.
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<FaceSegment> ambiguous;  ///< faces with more than one segment, by layer
};

DualSurface buildDualSurface(const HermiteGrid& grid, ComponentMethod method, RunContext& run);

}  // namespace swept
