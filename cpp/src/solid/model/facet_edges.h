// Edges between facets and curved faces that lie on both.
// In: a Model whose facets have their planes. Straight edges between a facet and a curved face are
// chords of the latter; they become the curves in which the facet's plane cuts its surface, where
// that curve stays well within the facet's corners. Edges for which it does not stay straight, with
// the gap that they have. Units: mm. Cost: O(edges between facets and curved faces).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/model/model.h"

namespace swept::step {

void curveFacetEdges(Model& model);

}  // namespace swept::step
