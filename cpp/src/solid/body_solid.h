// Makes the solid of an envelope from the faces and edges of the moving body (SolidOrigin). The
// judge assembles it. The mesh tells whether it is right, and fills what is missing.
// In:      the mesh of the envelope; the options with their origin.
// Out:     a solid that the judge holds, or nothing.
// Units:   mm.
// Cost:    see assemble/assemble.h.
// Throws Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "solid/shape_maker.h"

namespace swept::step {

/// Returns nothing if no such solid can be made, if it deviates from the swept volume by more than
/// the tolerance, or if it has too many faces.
std::optional<Built> makeFromBody(const HalfEdgeMesh& mesh, const SolidOptions& options,
                                  const std::function<bool(std::int64_t)>& fits, Judge& judge,
                                  RunContext& run);

/// After makeFromBody() has returned nothing: fills the holes between those faces that could be
/// made with triangles of the mesh. Returns nothing if there is no such solid with at most so many
/// faces.
std::optional<Built> fillFromBody(const HalfEdgeMesh& mesh, const SolidOptions& options,
                                  std::int64_t mostFaces, Judge& judge, RunContext& run);

}  // namespace swept::step
