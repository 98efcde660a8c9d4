// Replaces straight edges between a facet and a curved face by curves that lie on both.
// In:      a Model whose facets have their planes.
// Out:     Such a straight edge is a chord of the curved face. It becomes the curve in which the
//          plane of the facet intersects that face, if the curve stays well within the facet.
//          Otherwise the edge stays straight, with its gap.
// Units:   mm.
// Cost:    O(edges between facets and curved faces).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/model/model.h"

namespace swept::step {

void curveFacetEdges(Model& model);

}  // namespace swept::step
