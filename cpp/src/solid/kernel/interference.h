// Finds faces that intersect or touch where they share no vertex or edge. Uses the kernel's own
// test for Boolean operations.
// In:      a Model and its kernel faces. Only faces near a recognised surface or plane region are
//        tested, because the simplifier lets no two facets intersect.
// Out:     indices into Model::faces.
// Cost:    about 2 ms per tested face.
// The caller must hold a KernelSession.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <vector>

#include "solid/kernel/brep.h"
#include "solid/model/model.h"
#include "solid/model/split_edges.h"
#include "swept/run_context.h"

namespace swept::step {

std::vector<std::int32_t> findInterfering(const Model& model, const Brep& brep, RunContext& run);

/// Returns whether faces of the shape intersect others, by the same test of all of them.
bool doesIntersectItself(const TopoDS_Shape& shape, const Message_ProgressRange& progress);

/// Returns edges of curved faces that are farther from a face than a reader of the file would
/// assume. A reader computes the tolerance of an edge from the distances at some of its points.
/// Each entry has the curve parameter at which the distance is largest.
std::vector<EdgeCut> findEdgesOffFaces(const Model& model, const Brep& brep);

}  // namespace swept::step
