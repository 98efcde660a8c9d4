// The dual surface: a vertex for each component of the leaf cells, and for every crossing a quad of
// the four components round its lattice edge.
//
// In: Hermite grid. Out: vertices by layer of cells, quads by crossing. Units: cells. Cost:
// O(crossings).
// Promise: the same bytes for any number of threads.
// Source: dual contouring (Ju, Losasso, Schaefer and Warren 2002); several vertices per cell
// (Nielson 2004; Schaefer, Ju and Warren 2007, "Manifold dual contouring"; J. Brummer, bachelor's
// thesis, Mainz 2017, section 4.2).
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

/// A segment on an ambiguous face (a face whose crossings can be paired in several ways). The
/// segment joins two crossings. Each crossing has a quad; `side` says which side of this quad
/// passes through the face.
struct FaceSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  bool firstOfFace = false;
};

/// A polygon that joins the two vertices of a split component to those of the neighbouring cell.
/// The polygon passes through the face between the two cells. `crossing` lists the two crossings on
/// that face. `side` says which side of each crossing's quad passes through the face.
struct RimSegment {
  std::array<std::uint32_t, 2> crossing;
  std::array<std::uint8_t, 2> side;
  std::array<bool, 2> seenFromLow;  ///< true: the crossing is seen from the low end of its edge
};

struct DualVertex {
  Eigen::Vector3f local = Eigen::Vector3f::Zero();  ///< position in the cell, [0, 1]^3
  std::int16_t i = 0, j = 0, k = 0;                 ///< the cell
  float timeSeconds = 0;
};

struct DualSurface {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::vector<DualVertex>> vertices;  ///< by layer of cells
  std::vector<std::uint32_t> firstVertex;  ///< by layer of cells, with one more entry at the end
  /// Per crossing: the vertices of the four cells round its edge, in the order of quadCorner().
  /// They are indices within their layer of cells, or kNone if the component method dropped the
  /// crossing.
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<FaceSegment> ambiguous;  ///< the segments on ambiguous faces, by layer
  std::vector<RimSegment> rims;        ///< each segment once, ordered by its first crossing

  /// Returns the global index of the vertex at a quad's corner; i is the layer of the quad's
  /// lattice edge.
  std::uint32_t vertex(int axis, std::int32_t i, std::uint32_t crossing, int corner) const {
    // Layers are counted along x. Let b and c be the two axes across the lattice edge, in cyclic
    // order. Corners 0 and 3 lie on the lower side along b, corners 0 and 1 along c. For axis 2, b
    // is x; for axis 1, c is x. A corner on the lower side along x lies in the layer i - 1.
    const bool lower =
        (axis == 2 && (corner == 0 || corner == 3)) || (axis == 1 && (corner == 0 || corner == 1));
    return firstVertex[lower ? i - 1 : i] + quads[crossing][corner];
  }

  /// Returns the position, in grid coordinates, of the vertex with this global index; `layer` is
  /// its layer of cells.
  Eigen::Vector3d position(std::uint32_t global, std::int32_t layer) const {
    const DualVertex& v = vertices[layer][global - firstVertex[layer]];
    return v.local.cast<double>() + Eigen::Vector3d(v.i, v.j, v.k);
  }
  /// Returns whether the quad of the crossing has all four vertices.
  bool isComplete(std::uint32_t crossing) const {
    return std::find(quads[crossing].begin(), quads[crossing].end(), kNone) ==
           quads[crossing].end();
  }
};

/// Builds the dual surface. `probe` finds the ends of thin walls and hidden sides. With nullptr, a
/// wall ends at its last crossing.
DualSurface buildDualSurface(const HermiteGrid& grid, ComponentMethod method,
                             const SurfaceProbe* probe, RunContext& run);

/// Contours one cell and drops the result. pipeline/probe_trial.cpp measures the time of such calls
/// to estimate the cost of probe lines. The cell lies at the origin; its indices refer to
/// `crossings`.
void probeCell(const Cell& cell, const std::vector<Crossing>& crossings, ComponentMethod method,
               const SurfaceProbe& probe);

}  // namespace swept
