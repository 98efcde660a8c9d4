// Makes the kernel shape of a mesh: recognises surfaces, simplifies, and builds the model. Repeats
// this without the surfaces that the kernel refuses.
// In:      `dense`, the mesh to work on; `whole`, the mesh from which the deviation is measured;
//          the tolerance of the options; fits(count), which tells whether that many faces are
//          allowed.
// Out:     a shape whose faces the kernel accepts, or nothing if it would have too many faces.
// Units:   mm.
// Cost:    a few simplifications of the mesh.
// Throws Error(ExportFailed, "InvalidFaces"), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "solid/kernel/brep.h"
#include "solid/kernel/kernel.h"
#include "solid/mesh/half_edge.h"
#include "solid/model/model.h"
#include "swept/solid.h"

namespace swept::step {

struct Built {
  Model model;
  Brep brep;
  std::map<std::string, std::int64_t> facesByKind;
  double deviation = 0;  // mm, of the mesh's vertices from the faces of the solid
};

/// Returns the shape, or nothing. `faces` receives the number of faces, even if there are too many.
std::optional<Built> makeShape(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense,
                               const StepOptions& options,
                               const std::function<bool(std::int64_t)>& fits, KernelSession& kernel,
                               std::int64_t& faces, RunContext& run);

/// Returns a shape with the faces of StepOptions::origin. Nothing if they do not fit together.
std::optional<Built> makeLabelledShape(const HalfEdgeMesh& mesh, const StepOptions& options,
                                       const std::function<bool(std::int64_t)>& fits,
                                       KernelSession& kernel, RunContext& run);

}  // namespace swept::step
