// Finds where a choice of (face, placement) pairs left the envelope open, and which pairs are
// missing.
//
// In: marked edges and signs of the choice, placement space. Out: missing pairs, and how much is
// open. Units: mm. Cost: one support query and one exact test per surface point.
// Source: own method; docs/pipeline.md, "Dense motions".
//
// A choice can err towards the outside only: every sampled crossing is a true one, so that what it
// calls inside is inside. Lattice points next to the surface are tested against all placements: the
// placement that pushes the surface farthest there (support query) is tested exactly, body against
// point. Covered points that the choice called outside are followed through unmarked edges to where
// the covering body ends. An unmarked edge that its surface crosses is a hole, and the triangle
// there at that placement is the missing pair.
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
  std::int64_t tested = 0;   ///< surface points (ends of contributing edges) that were tested
  std::int64_t covered = 0;  ///< of these, covered by a placement although called outside
  double deepest = 0;        ///< mm: largest advance by which one of these was missed
  bool complete = true;      ///< false: stopped at a limit
  /// (face, placement), sorted, without repetition
  std::vector<std::pair<std::uint32_t, std::uint32_t>> missing;
};

/// Surface points that no placement covers, by layer, in the order of the tests. Whether a point is
/// covered does not depend on what has been sampled, so that the next round need not test it again.
struct ClearPoints {
  struct Point {
    /// Key of the lattice point, and of the axis and side of the edge that it belongs to.
    std::uint64_t place;
    std::uint32_t face, placement;
    bool operator==(const Point&) const = default;
  };
  std::vector<std::vector<Point>> layers;
};

/// Exact tests of points and segments against the body; made once for all calls.
struct BodyTests {
  explicit BodyTests(const TriMesh& body)
      : rays(body), tree(boxTreeOf(body.vertices, body.triangles)) {}

  RayColumns rays;
  BoxTree tree;
};

/// margin: mm by which a placement must reach beyond a point to count as missed; the same for all
/// calls that share `clear`.
LeakSearch findLeaks(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                     const MarkedEdges& marked, const SignRuns& signs, double margin,
                     ClearPoints& clear, RunContext& run);

/// Some faces of the body as they have been chosen and sampled, numbered from 0.
struct ChosenFaces {
  const std::vector<std::uint32_t>& faces;  ///< their numbers in the body
  const FacePlacements& placements;
  const MarkedEdges& marked;
  std::size_t crossings;
};

struct LeakTrial {
  double open = 0;     ///< part of the points next to the surface that the choice leaves open
  double seconds = 0;  ///< of the CPU, for a point
};

/// For estimates, without signs: points that a placement covers which has not been chosen for the
/// face count as open; those that another chosen one covers do not lie next to the surface.
LeakTrial tryLeaks(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                   const ChosenFaces& chosen, double margin);

}  // namespace swept::dense
