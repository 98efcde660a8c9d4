// Checks whether a kernel shape is sound: faces, shells, volume. The caller holds a KernelSession.
// Plane triangles with straight edges, of which a faceted solid has many, are tested here; all
// other faces by the kernel's checker, which takes a hundred times as long per face. Parallel over
// faces.
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

/// Indices of the faces that the kernel's checker refuses. Parallel. from, to: the part of the
/// export's progress.
std::vector<std::int32_t> findBadFaces(const std::vector<TopoDS_Shape>& faces, RunContext& run,
                                       double from, double to);

/// Whether the face is a sound plane triangle with straight edges.
bool isPlaneTriangle(const TopoDS_Face& face);

/// What is sound, and how much of it there is.
SolidCheck checkShape(const TopoDS_Shape& shape, RunContext& run, double from, double to);

}  // namespace swept::step
