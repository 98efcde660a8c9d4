// The polygon of a crossing: the four vertices round its lattice edge, and how it is cut into
// triangles.
// In: Hermite grid, dual surface. Out: the cut of each quad. Units: cells. Cost: O(1) per crossing.
// Source: Ju and Udeshi 2006: a diagonal is used only if both triangles stay between the
// neighbouring cells.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/dual_surface.h"
#include "grid/hermite_grid.h"

namespace swept {

enum class Split : std::uint8_t { Diagonal02, Diagonal13, Fan };

/// Geometry of the polygons round crossings before they become triangles.
class PolygonBuilder {
 public:
  explicit PolygonBuilder(const DualSurface& dual) : dual_(dual) {}

  /// Global index of the vertex at a quad's corner; i is the layer of the quad's lattice edge.
  std::uint32_t vertex(int axis, std::int32_t i, std::uint32_t crossing, int corner) const {
    // Corners 0 and 3 lie at -b, corners 0 and 1 at -c. The x axis is b of axis 2 and c of axis 1.
    const bool lower =
        (axis == 2 && (corner == 0 || corner == 3)) || (axis == 1 && (corner == 0 || corner == 1));
    return dual_.firstVertex[lower ? i - 1 : i] + dual_.quads[crossing][corner];
  }

  Eigen::Vector3d position(std::uint32_t global, std::int32_t layer) const {
    const DualVertex& v = dual_.vertices[layer][global - dual_.firstVertex[layer]];
    return v.local.cast<double>() + Eigen::Vector3d(v.i, v.j, v.k);
  }

  bool complete(std::uint32_t crossing) const {
    for (const std::uint32_t v : dual_.quads[crossing]) {
      if (v == DualSurface::kNone) return false;
    }
    return true;
  }

  /// How the quad of a crossing is cut into triangles; `point` is where the crossing lies.
  Split choose(int axis, std::int32_t i, const Eigen::Vector3d& point,
               std::uint32_t crossing) const;

 private:
  const DualSurface& dual_;
};

}  // namespace swept
