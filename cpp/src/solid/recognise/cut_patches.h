// Cuts patches that close on themselves round their surface, so that no face needs a seam.
// In, out: Partition. The reference direction of each surface is turned so that its seam lies
// outside the face; where there is no room for the seam, the patch is cut in halves.
// Partition::cuts keeps the cutting planes. Units: mm, rad. Cost: O(triangles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

void cutRoundPatches(const HalfEdgeMesh& mesh, Partition& partition);

}  // namespace swept::step
