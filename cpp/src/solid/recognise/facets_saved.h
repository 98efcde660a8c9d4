// Estimates how many facets a patch saves by being one face.
// In:      a patch of a mesh, tolerance.
// Out:     an approximate number.
// Units:   mm.
// Cost:    O(triangles of the patch).
// Method:  the principal curvatures of the carrier determine how large triangles may be within a
// tolerance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

/// Returns the approximate number of facets in the best triangulation of the patch within the
/// tolerance.
double facetsSaved(const HalfEdgeMesh& mesh, const Patch& patch, double tolerance);

}  // namespace swept::step
