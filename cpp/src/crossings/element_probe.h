// Casts lines at the swept surface near given crossings (implements SurfaceProbe).
//
// In: the elements that made the crossings. Out: first hit, normal and time per line. Units: grid
// coordinates, seconds. Cost: proportional to the elements that pass through the cell, up to a
// limit.
//
// A piece is a swept element in grid coordinates: a face at one placement, or the side patch that
// an edge sweeps in one step. The search starts at the elements of the given crossings, and of all
// crossings in and around the region. It continues to their neighbours, the nearest first: across
// shared edges and paths of vertices, and to the steps before and after. The search crosses an edge
// or a path only where the edge or path passes through the region. Once it has found many pieces,
// it leaves out those that the steps before and after cover: most pieces of a dense motion, and
// none of them lies on the envelope. Covered pieces only help to reach further sheets of the
// envelope. The search uses no other data, so the result does not depend on the sampler that found
// the crossings.
// Source: own method; docs/contouring.md, "Rims".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "grid/surface_probe.h"
#include "sampling/sampler.h"

namespace swept {

class ElementProbe : public SurfaceProbe {
 public:
  /// `winner`: for each crossing of `grid`, the index of its element in `elements`. All arguments
  /// must outlive the probe.
  ElementProbe(const SamplerInput& input, const std::vector<SweptElement>& elements,
               const std::vector<std::uint32_t>& winner, const HermiteGrid& grid);
  void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
            std::vector<ProbeLine>& lines) const override;

 private:
  class Directions;
  /// Corners of a face (the last one twice), or of a side patch in ring order: the ends a and b of
  /// its edge at the start of the step, then b and a at the end of the step.
  struct Piece {
    std::array<Eigen::Vector3d, 4> corner;
    bool isSidePatch = false;
    double start = 0, end = 0;  // seconds
  };
  bool skipsCovered() const { return input_.cull && input_.motion.continuous; }
  bool isCovered(const SweptElement& element, Directions& directions) const;
  Piece pieceOf(const SweptElement& element) const;
  std::vector<Piece> gather(const Eigen::AlignedBox3d& region,
                            const std::vector<std::uint32_t>& crossings) const;
  /// Calls use(other) for the neighbours of an element. A neighbour shares an edge or the path of a
  /// vertex with the element, or is a copy of the same face at the placement before or after.
  /// inside(p, q) must be true for the ends p and q of a shared edge or path.
  template <class Inside, class Use>
  void forNeighbours(const SweptElement& element, const Piece& piece, const Inside& inside,
                     const Use& use) const;
  static void castOne(const Piece& piece, ProbeLine& line, double& first);

  const SamplerInput& input_;
  const std::vector<SweptElement>& elements_;
  const std::vector<std::uint32_t>& winner_;
  const HermiteGrid& grid_;
  std::vector<Placement> placements_;  // from body coordinates (mm) to grid coordinates (cells)
  // Edges of each face. -1: an edge with more than two faces whose BodyEdge does not list this
  // face.
  std::vector<std::array<std::int32_t, 3>> faceEdges_;
};

}  // namespace swept
