// Checks whether a kernel shape is valid: its faces, its shells and its volume. Plane triangles
// with straight edges, of which a faceted solid has many, are tested here. All other faces are
// tested by the kernel's checker, which takes a hundred times as long per face. The faces are
// tested in parallel. The caller must hold a KernelSession.
// Units:   mm.
// Cost:    O(faces).
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

/// Returns the indices of the faces that the kernel's checker refuses. `from` and `to`: progress of
/// the export (0 to 1) at the beginning and at the end of the call.
std::vector<std::int32_t> findBadFaces(const std::vector<TopoDS_Shape>& faces, RunContext& run,
                                       double from, double to);

/// Returns whether the face is a valid plane triangle with straight edges.
bool isPlaneTriangle(const TopoDS_Face& face);

/// Returns whether the shape is valid, what is wrong with it, and its figures.
SolidCheck checkShape(const TopoDS_Shape& shape, RunContext& run, double from, double to);

}  // namespace swept::step
