// Finds where the chosen (face, placement) pairs leave the envelope open, and the missing pairs.
// In: marked edges and signs from sampling the chosen pairs, placement space. Out: missing pairs,
// and how much is open. Units: mm. Cost: one support query and one exact test per surface point.
// Source: own method; docs/pipeline.md, "Dense motions".
//
// The chosen pairs can be wrong in one way only: a point that the body covers at some placement may
// lie outside according to these pairs. A point that lies inside according to them is truly inside,
// because each sampled crossing belongs to the sweep. The search tests each lattice point next to
// the surface against all placements. A support query gives the placement that moves the surface
// farthest there. An exact test shows whether the body at this placement covers the point. From a
// covered point, the search follows unmarked edges to the surface of the body at this placement. An
// unmarked edge that this surface crosses is a hole. The missing pair is the triangle at the
// crossing, with this placement.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/ray_columns.h"
#include "grid/marked_edges.h"
#include "sampling/dense/candidates.h"
#include "sampling/dense/placement_space.h"
#include "sampling/sampler.h"
#include "signs/signs.h"

namespace swept::dense {

struct LeakSearch {
  std::int64_t tested = 0;  ///< number of surface points (outside ends of edges) that were tested
  /// Number of these points that the body covers at some placement. According to the chosen pairs,
  /// they lie outside.
  std::int64_t covered = 0;
  double deepest = 0;    ///< mm: largest advance of a missed placement beyond a covered point
  bool complete = true;  ///< false: the search stopped at a limit
  /// Missing (face, placement) pairs, sorted; each occurs once.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> missing;
};

/// Surface points that the body covers at no placement, by layer, in the order of the tests.
/// Whether a point is covered does not depend on the choice of pairs, so the next round need not
/// test these points again.
struct ClearPoints {
  struct Point {
    /// Key of the lattice edge within its layer, and of the end of the edge at which the point
    /// lies.
    std::uint64_t key;
    std::uint32_t face, placement;
    bool operator==(const Point&) const = default;
  };
  std::vector<std::vector<Point>> layers;
};

/// Data for exact tests of points and segments against the body. One object serves all calls.
struct BodyTests {
  explicit BodyTests(const TriMesh& body)
      : rays(body), tree(boxTreeOf(body.vertices, body.triangles)) {}

  RayColumns rays;
  BoxTree tree;
};

/// Searches for holes. `margin` (mm): a placement counts as missed if it reaches beyond a point by
/// more than this. All calls that share `clear` must use the same margin.
LeakSearch findLeaks(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                     const MarkedEdges& marked, const SignRuns& signs, double margin,
                     ClearPoints& clear, RunContext& run);

/// Some faces of the body, with their chosen placements and the result of sampling them.
struct ChosenFaces {
  const std::vector<std::uint32_t>& faces;  ///< indices in the body
  const FacePlacements& placements;
  const MarkedEdges& marked;
  std::size_t crossings;
};

struct LeakTrial {
  double open = 0;     ///< fraction of the points next to the surface that the choice leaves open
  double seconds = 0;  ///< CPU seconds per point
};

/// Estimates without signs how much the choice leaves open. A point counts as open if the body
/// covers it at a placement that was not chosen for the face. A point that the body covers at a
/// chosen placement does not lie next to the surface and does not count.
LeakTrial tryLeaks(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                   const ChosenFaces& chosen, double margin);

}  // namespace swept::dense
