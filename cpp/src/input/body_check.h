// Input check of the generator.
// In:    any triangles. Out: the same body welded, cleaned and oriented, with findings.
// Units: mm. Cost: O(n log n) time, about 200 bytes a triangle.
// Rows 1 to 12 of the table of bad input (docs/bad_input.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct CheckedBody {
  TriMesh mesh;         ///< welded, no degenerate or duplicate triangles, no unused vertices
  bool closed = false;  ///< every edge has an even number of triangles
  /// Closed, every edge balanced (as many triangles in one direction as in the other), outer shells
  /// outward, cavities inward: what the culling of enclosed faces needs.
  bool orientable = false;
  /// The faces of its triangles were given; else, where sources are asked for, each triangle's own
  /// number stands for its face.
  bool namedFaces = false;
  std::vector<Finding> findings;
};

/// Throws Error(InvalidInput) with code EmptyMesh, BadFaces, BadIndex, NonFiniteVertex,
/// NoVolume, OutOfRange.
/// An open body is accepted here (row 6); whether the sweep closes it is seen after sampling.
CheckedBody checkBody(const TriMesh& body, const Options& options, RunContext& run);

}  // namespace swept
