// Cuts edges that bend too much in the parameters of a sphere. The files have no parameter curves,
// so a reader computes one for each edge: a cubic spline through 23 points of the edge. Between
// these points, the spline deviates from the edge. Circles of latitude and meridians are straight
// in the parameters, so they are never cut.
// In:      a Model.
// Out:     the same model, with arcs of circles halved until the spline follows them.
// Units:   mm.
// Cost:    O(edges of spheres).
// Source:  complete cubic splines (de Boor 1978, chapter IV), with the slopes at both ends from
//          four points.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/model/model.h"

namespace swept::step {

/// Halves arcs of circles on spheres until the spline of a reader is less than 1e-7 mm away from
/// them. With radii of more than a few kilometres, it may stay farther away.
void cutBentArcs(Model& model);

}  // namespace swept::step
