// Finds the polygon of a crossing: consecutive triangles of the surface.
//
// In: a surface directly after contouring, because mending may add triangles of the polygon
// elsewhere. Cost: one pass over the triangles, 4 bytes per crossing.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "contour/surface.h"

namespace swept {

/// Margin (cells) of tests of positions, far above their rounding (about 1e-12 of a cell in a grid
/// of 4,096 cells).
constexpr double kRounding = 1e-7;

struct Polygon {
  std::uint32_t first, count;
};

class Polygons {
 public:
  Polygons(const Surface& surface, std::size_t crossings)
      : surface_(surface), start_(crossings, kNone) {
    const auto& of = surface.crossingOf;
    parallelBlocks(of.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        if (of[t] == Surface::kNoCrossing || (t > 0 && of[t] == of[t - 1])) continue;
        start_[of[t]] = static_cast<std::uint32_t>(t);
      }
    });
  }

  bool has(std::uint32_t crossing) const { return start_[crossing] != kNone; }
  Polygon of(std::uint32_t crossing) const {
    const std::uint32_t first = start_[crossing];
    std::uint32_t end = first + 1;
    while (end < surface_.crossingOf.size() && surface_.crossingOf[end] == crossing) ++end;
    return {first, end - first};
  }
  const std::array<std::int32_t, 3>* triangles(const Polygon& polygon) const {
    return &surface_.mesh.triangles[polygon.first];
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  const Surface& surface_;
  std::vector<std::uint32_t> start_;
};

}  // namespace swept
