// Turns a Hermite grid into a closed triangle mesh. Each component of a cell (crossings that belong
// to one piece of surface, components.h) becomes a vertex, and each crossing a polygon.
//
// In: Hermite grid. Out: mesh in mm, and a contact time for each vertex. Cost: O(crossings).
// Promise (with ComponentMethod::Consistent): closed, edge- and vertex-manifold, oriented outward.
// The polygons of the dual surface form a closed surface by construction. Two things could still
// make the triangles non-manifold, and each is resolved where it occurs. If two components of
// adjacent cells are joined twice through the face between the cells, the second join gets a vertex
// on the face. A lattice edge may have two crossings, each with a quad. If both quads have the same
// diagonal, both become fans about their crossings.
// Source: dual contouring (Ju et al. 2002); several vertices per cell (Nielson 2004; Schaefer, Ju
// and Warren 2007, "Manifold dual contouring"); polygons through points on edges and faces where no
// diagonal is valid (Ju and Udeshi 2006).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/surface_probe.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct Surface {
  /// Entry of crossingOf for a triangle of the strip that closes the end of a thin wall.
  static constexpr std::uint32_t kNoCrossing = 0xffffffffu;

  TriMesh mesh;
  std::vector<double> contactTime;
  /// Per triangle: the crossing to whose polygon the triangle belongs, or kNoCrossing.
  std::vector<std::uint32_t> crossingOf;
  /// Number of component vertices; they come first, before all extra vertices.
  std::size_t dualVertices = 0;
  /// Bits per component vertex: whether it lies in its own cell, and whether other vertices share
  /// the cell.
  std::vector<std::uint8_t> cellFlags;
  /// The vertex lies inside its own cell.
  static constexpr std::uint8_t kInsideCell = 1;
  /// The previous vertex belongs to the same cell.
  static constexpr std::uint8_t kSharedWithPrevious = 2;
  /// The next vertex belongs to the same cell.
  static constexpr std::uint8_t kSharedWithNext = 4;
  static constexpr std::uint8_t kShared = kSharedWithPrevious | kSharedWithNext;
  /// Returns the bits of any vertex of the mesh; 0 if the vertex does not belong to a component.
  std::uint8_t cellFlagsOf(std::int32_t v) const {
    return static_cast<std::size_t>(v) < cellFlags.size() ? cellFlags[v] : std::uint8_t{0};
  }
  /// The vertices that mending has moved or added, in ascending order.
  std::vector<std::int32_t> mended;
};

/// Contours the grid without changing it. For `probe`, see buildDualSurface().
Surface contourUniform(const HermiteGrid& grid, const Options& options, RunContext& run,
                       const SurfaceProbe* probe = nullptr);

/// The lattice edge of a crossing. edgeOfCrossing() finds it from the index of the crossing, in
/// O(log(number of crossings)).
struct CrossingEdge {
  int axis = 0;
  std::int32_t i = 0, j = 0, k = 0;
};
CrossingEdge edgeOfCrossing(const HermiteGrid& grid, std::uint32_t index);
/// Returns the position of a crossing, in cells from the grid's origin.
Eigen::Vector3d positionOfCrossing(const HermiteGrid& grid, const CrossingEdge& edge,
                                   std::uint32_t index);

}  // namespace swept
