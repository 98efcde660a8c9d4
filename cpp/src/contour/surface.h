// Hermite grid -> closed triangle mesh: one vertex a component, one polygon a crossing.
//
// In: Hermite grid. Out: mesh in mm, per vertex the time of contact. Cost: O(crossings).
// Paper: dual contouring (Ju et al. 2002), components per cell (Schaefer and Warren 2004), polygons
// through edge and face points where a diagonal would not do (Ju and Udeshi 2006).
// Invariants (consistent components): closed, edge- and vertex-manifold, oriented outward. The
// polygons of the dual surface form a closed surface by construction; two things could still make
// it non-manifold as a set of triangles, and are mended where they occur: two segments of one face
// that join the same two components (the second gets a vertex on the face), and the two quads of
// one lattice edge choosing the same diagonal (both are fanned about their crossing).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/surface_probe.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct Surface {
  /// In crossingOf: a triangle of the strip that closes the end of a thin wall.
  static constexpr std::uint32_t kNoCrossing = 0xffffffffu;

  TriMesh mesh;
  std::vector<double> contactTime;
  /// Per triangle: the crossing whose polygon it is part of, or kNoCrossing.
  std::vector<std::uint32_t> crossingOf;
  std::size_t dualVertices =
      0;  ///< the first so many vertices are those of components, then extra ones
  /// Per component vertex, bits: how it lives in its cell.
  std::vector<std::uint8_t> lodging;
  static constexpr std::uint8_t kInside = 1;      ///< lies inside its own cell
  static constexpr std::uint8_t kWithBefore = 2;  ///< the vertex before it has the same cell
  static constexpr std::uint8_t kWithAfter = 4;   ///< the vertex after it has the same cell
  static constexpr std::uint8_t kCrowded = kWithBefore | kWithAfter;
  /// Of any vertex: none of these bits where it is no component's.
  std::uint8_t lodgingOf(std::int32_t v) const {
    return static_cast<std::size_t>(v) < lodging.size() ? lodging[v] : std::uint8_t{0};
  }
  std::int64_t fans = 0;         ///< quads fanned about their crossing
  std::int64_t facePoints = 0;   ///< vertices put on cell faces
  std::int64_t rimPolygons = 0;  ///< that close the ends of thin walls
};

/// The grid is left as it was. `probe`: see buildDualSurface().
Surface contourUniform(const HermiteGrid& grid, const Options& options, RunContext& run,
                       const SurfaceProbe* probe = nullptr);

/// Lattice edge of a crossing, found from its index alone: O(log crossings).
struct CrossingPlace {
  int axis = 0;
  std::int32_t i = 0, j = 0, k = 0;
};
CrossingPlace findCrossing(const HermiteGrid& grid, std::uint32_t index);

}  // namespace swept
