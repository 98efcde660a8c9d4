// The dual surface: leaf cells with their components and vertices, and for every crossing the four
// components round its lattice edge.
//
// In: Hermite grid. Out: vertices by cell layer, quads by crossing. Units: cells. Cost:
// O(crossings).
// Promise: the same bytes for any number of threads.
// Source: dual contouring (Ju, Losasso, Schaefer and Warren 2002); several vertices per cell
// (Nielson 2004; Schaefer, Ju and Warren 2007, "Manifold dual contouring"); thesis section 4.2.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/cell.h"
#include "grid/hermite_grid.h"
#include "grid/surface_probe.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A segment on an ambiguous face: its two crossings and, for each, which side of the crossing's
/// quad passes through the face.
struct FaceSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  bool firstOfFace = false;
};

/// A side of the strip that joins the two vertices of a split wall end to those of the next cell:
/// the two crossings on the face between the cells, and the sides of their quads there.
struct RimSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  std::array<bool, 2> seenFromLow;
};

struct DualVertex {
  Eigen::Vector3f local = Eigen::Vector3f::Zero();  ///< position in the cell, [0, 1]^3
  std::int16_t i = 0, j = 0, k = 0;                 ///< the cell
  float timeSeconds = 0;
};

struct DualSurface {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::vector<DualVertex>> vertices;  ///< per layer of cells
  std::vector<std::uint32_t> firstVertex;  ///< per layer of cells, and one entry behind the last
  /// Per crossing: the vertices (indices within their layer of cells) of the cells round its edge,
  /// in the order of quadCorner(); kNone where a component method dropped the crossing.
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<FaceSegment> ambiguous;  ///< faces with more than one segment, by layer
  std::vector<RimSegment> rims;        ///< each segment once, ordered by its first crossing

  /// Global index of the vertex at a quad's corner; i is the layer of the quad's lattice edge.
  std::uint32_t vertex(int axis, std::int32_t i, std::uint32_t crossing, int corner) const {
    // Corners 0 and 3 lie at -b, corners 0 and 1 at -c. The x axis is b of axis 2 and c of axis 1.
    const bool lower =
        (axis == 2 && (corner == 0 || corner == 3)) || (axis == 1 && (corner == 0 || corner == 1));
    return firstVertex[lower ? i - 1 : i] + quads[crossing][corner];
  }

  /// Of the vertex with this global index in a layer of cells, in grid coordinates.
  Eigen::Vector3d position(std::uint32_t global, std::int32_t layer) const {
    const DualVertex& v = vertices[layer][global - firstVertex[layer]];
    return v.local.cast<double>() + Eigen::Vector3d(v.i, v.j, v.k);
  }
  /// Whether the crossing has all four vertices of its polygon.
  bool isComplete(std::uint32_t crossing) const {
    return std::find(quads[crossing].begin(), quads[crossing].end(), kNone) ==
           quads[crossing].end();
  }
};

/// `probe` looks for the ends of thin walls and for hidden sides; with nullptr a wall ends at its
/// last crossing.
DualSurface buildDualSurface(const HermiteGrid& grid, ComponentMethod method,
                             const SurfaceProbe* probe, RunContext& run);

/// Casts what contouring asks of the probe in one cell, in the cell's own coordinates, and drops
/// what it makes of the answers. `crossings`: those that the cell refers to.
void probeCell(const Cell& cell, const std::vector<Crossing>& crossings, ComponentMethod method,
               const SurfaceProbe& probe);

}  // namespace swept
