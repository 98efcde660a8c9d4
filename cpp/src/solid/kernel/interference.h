// Finds faces that intersect others outside their common edges and vertices. Uses the kernel's own
// test for Boolean operations.
// In: a Model and its kernel faces. Only faces near a recognised face are tested: the simplifier
// leaves no facets that intersect each other. Out: indices into Model::faces. The caller holds a
// KernelSession. Cost: about 2 ms per tested face.
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

/// Finds edges of curved faces whose tolerance is smaller than their largest distance from a face.
/// A reader of the file sets this tolerance from some points along the edge. Each EdgeCut has the
/// curve parameter of the largest distance.
std::vector<EdgeCut> findUnheldEdges(const Model& model, const Brep& brep);

}  // namespace swept::step
