// Checks whether a kernel shape is valid: faces, shells, volume. The caller holds a KernelSession.
// Plane triangles with straight edges, of which a faceted solid has many, are tested here. The
// kernel's checker tests the other faces; it takes a hundred times as long per face. The faces are
// checked in parallel.
// Units: mm. Cost: O(faces).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <string>
#include <vector>

#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

/// Returns the indices of the invalid faces. `from`, `to`: the part of the export's progress that
/// this check covers, 0 to 1.
std::vector<std::int32_t> findBadFaces(const std::vector<TopoDS_Shape>& faces, RunContext& run,
                                       double from, double to);

/// Returns whether the face is a valid plane triangle with straight edges.
bool isPlaneTriangle(const TopoDS_Face& face);

/// Checks faces and shells; counts faces, edges, shells and solids; computes the volume.
SolidCheck checkShape(const TopoDS_Shape& shape, RunContext& run, double from, double to);

}  // namespace swept::step
