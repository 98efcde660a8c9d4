// The same surface a little inside itself: what is left of a part when a skin is taken off.
// In:    a part. Out: a mesh whose vertices lie up to `skin` inside, less where the part is thin;
// as
//        it is where the mesh is open. It only guides searches; nothing is ever proven with it.
// Units: mm. Cost: one or a few nearest-triangle queries a vertex.
// Source: M. Saha, J.-C. Latombe, Y.-C. Chang, F. Prinz, Finding narrow passages with probabilistic
//         roadmaps: the small-step retraction method (2005).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "clearance/part.h"

namespace swept::path {

TriMesh thinned(const clearance::Part& part, double skin);

}  // namespace swept::path
