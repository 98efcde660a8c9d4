// Cuts patches that go round their surface, so that no face needs a seam.
// In, out: Partition; the reference direction of each surface is turned so that its seam lies
// outside the face, and where there is no room for it, the patch is halved. The cutting planes are
// kept in Partition::cuts. Cost: O(triangles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

void cutRoundPatches(const HalfEdgeMesh& mesh, Partition& partition);

}  // namespace swept::step
