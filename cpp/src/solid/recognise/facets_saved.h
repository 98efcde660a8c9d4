// How many facets a patch saves by being one face.
// In: a patch of a mesh, tolerance in mm. Out: approximate number. Units: mm. Cost: O(triangles of
// the patch). Source: the size of triangles within a tolerance follows from the two curvatures of
// the carrier.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

/// Approximate number of facets that the best triangulation of the patch within the tolerance
/// needs.
double facetsSaved(const HalfEdgeMesh& mesh, const Patch& patch, double tolerance);

}  // namespace swept::step
