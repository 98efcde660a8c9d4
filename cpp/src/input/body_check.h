// Checks the generator (the moving part) before a run.
// In:    any triangles. Out: the same body, welded, cleaned and oriented, with findings.
// Units: mm. Cost: O(n log n) time for n triangles, about 200 bytes per triangle.
// Covers rows 1 to 12 of docs/bad_input.md.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct CheckedBody {
  TriMesh mesh;  ///< welded; without degenerate triangles, duplicates and unused vertices

  bool closed = false;    ///< every edge belongs to an even number of triangles
  bool manifold = false;  ///< no edge belongs to more than two triangles
  /// True if the body is closed, equally many triangles run along each edge in both directions,
  /// outer shells point outward and cavities inward. Culling by direction requires all of this.
  bool orientable = false;
  /// True if the caller gave a face for each triangle. Otherwise, if sources are requested, each
  /// triangle is a face and has its own index.
  bool namedFaces = false;
  std::vector<Finding> findings;
};

/// Checks, welds, cleans and orients the body. Throws Error(InvalidInput) with the code EmptyMesh,
/// BadFaces, BadIndex, NonFiniteVertex, NoVolume or OutOfRange, and Error(ResourceLimit,
/// "TooManyVertices"). Accepts an open body (row 6 of docs/bad_input.md), because only sampling
/// shows whether its sweep is closed.
CheckedBody checkBody(const TriMesh& body, const Options& options, RunContext& run);

}  // namespace swept
