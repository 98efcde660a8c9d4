// Faces that meet where they share nothing, as the kernel's own test for Boolean operations finds
// them.
// In: a Model and its kernel faces. Only faces near one that is no facet are tested: facets do not
// meet one another as the simplifier leaves them. Out: indices into Model::faces. The caller holds
// a KernelSession. Cost: about 2 ms a tested face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/kernel/brep.h"
#include "solid/model/model.h"
#include "solid/model/split_edges.h"
#include "swept/run_context.h"

namespace swept::step {

std::vector<std::int32_t> findInterfering(const Model& model, const Brep& brep, RunContext& run);

/// Edges of curved faces whose tolerance, as a reader of the file sets it from points along the
/// edge, is smaller than the largest distance from a face, with the parameter of that distance.
std::vector<EdgeCut> findUnheldEdges(const Model& model, const Brep& brep);

}  // namespace swept::step
