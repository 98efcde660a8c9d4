// Two-sided Hermite data of the envelope. For each end of a lattice edge that lies outside, the
// grid has the first crossing on the edge, counted from this end (the crossing "seen" from this
// end).
//
// Memory: 8 bytes per edge, 24 bytes per crossing.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"

namespace swept {

struct Crossing {
  float fraction = 0;  ///< along the edge: 0 at the low end, 1 at the high end
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, towards the outside
  float timeSeconds = 0;
};

struct HermiteEdge {
  static constexpr std::uint8_t kLow = 1, kHigh = 2;
  /// Index of the crossing seen from the low end. If there is none, index of the crossing seen from
  /// the high end. If the edge has both, their indices are successive.
  std::uint32_t first = 0;
  std::uint16_t k = 0;
  /// Bits kLow and kHigh. A bit is set if this end of the edge lies outside. There is then a
  /// crossing seen from this end.
  std::uint8_t sides = 0;
};

/// Edges that start in lattice layer i, in the same order and with the same indices as in
/// LayerEdges.
struct HermiteLayer {
  std::array<std::vector<HermiteEdge>, 3> edges;
  std::array<std::vector<std::uint32_t>, 3> columnStart;
  std::uint32_t firstCrossing = 0;  ///< index of the first crossing; the others of the layer follow
};

struct HermiteGrid {
  GridPlan plan;
  std::vector<HermiteLayer> layers;
  std::vector<Crossing> crossings;
  std::vector<std::uint32_t> winner;  ///< per crossing: index of its swept element
  /// Per crossing: its time in double (s). Empty unless ExactTimes::Kept was requested.
  std::vector<double> exactSeconds;
  std::int64_t sheetEdges = 0;  ///< edges that cross a sheet: both crossings are one point
};

}  // namespace swept
