// Leaf cells, their components and vertices, and for every crossing the four components round it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "grid/hermite_grid.h"
#include "grid/surface_probe.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A segment on an ambiguous face: its two crossings and the sides of their quads that it is.
struct FaceSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  bool firstOfFace = false;
};

/// Where the two vertices of a split wall end are to be joined to those of the next cell: the two
/// crossings on the face between, and the sides of their quads there.
struct RimSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  std::array<bool, 2> seenFromLow;
};

struct DualVertex {
  Eigen::Vector3f local = Eigen::Vector3f::Zero();  ///< in the cell, [0, 1]^3
  std::int16_t i = 0, j = 0, k = 0;                 ///< cell
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
  std::vector<RimSegment> rims;        ///< each once, ordered by its first crossing
};

/// `probe`: looks for the ends of thin walls; nullptr leaves them at the last crossing.
DualSurface buildDualSurface(const HermiteGrid& grid, ComponentMethod method,
                             const SurfaceProbe* probe, RunContext& run);

}  // namespace swept
