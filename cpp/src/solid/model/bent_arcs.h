// Cuts edges that bend too much in the parameters of a sphere. Files have no parameter curves. A
// reader computes one for each edge, as a cubic spline through 23 of its points, and this spline
// leaves the edge between them. Circles of latitude and meridians are straight there, so they are
// never cut.
// In:      a Model.
// Out:     the same model, with arcs of circles halved until they are held (split_edges.h).
// Units:   mm.
// Cost:    O(edges of spheres).
// Source:  complete cubic splines (de Boor 1978, chapter IV), with the slopes at both ends from
//          four points.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/model/model.h"

namespace swept::step {

/// On spheres of more than a few kilometres, some arcs may stay bent.
void cutBentArcs(Model& model);

}  // namespace swept::step
