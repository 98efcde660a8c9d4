// Answers a surface probe from the swept elements: those that won the given crossings, and from
// them on along the edges and steps of the motion that they share, as long as the cell is met.
// Cost: the elements met; none is looked for anywhere else, so that it does not matter which
// sampler found the crossings.
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
  /// `winner`: per crossing its index in `elements`. All must outlive the probe.
  ElementProbe(const SamplerInput& input, const std::vector<SweptElement>& elements,
               const std::vector<std::uint32_t>& winner);
  void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
            std::vector<ProbeLine>& lines) const override;

 private:
  /// Corners of a face, or of a side patch going round: a, b at the step's start, b, a at its end.
  struct Piece {
    std::array<Eigen::Vector3d, 4> corner;
    bool isPatch = false;
    double start = 0, end = 0;  // s
  };
  Piece pieceOf(const SweptElement& element) const;
  std::vector<Piece> gather(const Eigen::AlignedBox3d& region,
                            const std::vector<std::uint32_t>& crossings) const;
  /// use(other) for those that share an edge or a vertex's path with the element, if inside(p, q)
  /// holds for that segment, and for copies of a face in the placements before and after.
  template <class Inside, class Use>
  void forNeighbours(const SweptElement& element, const Piece& piece, const Inside& inside,
                     const Use& use) const;
  static void castOne(const Piece& piece, ProbeLine& line, double& first);

  const SamplerInput& input_;
  const std::vector<SweptElement>& elements_;
  const std::vector<std::uint32_t>& winner_;
  std::vector<Placement> placements_;                   // in cells
  std::vector<std::array<std::int32_t, 3>> faceEdges_;  // -1: rim or more than two faces
};

}  // namespace swept
