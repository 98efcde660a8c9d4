// From a mesh to the kernel's shape: recognise surfaces, simplify, build the model, and repeat
// without what the kernel refuses.
// In: `dense`, the mesh to work on; `whole`, the mesh that the deviation is measured from; the
// options' tolerance. Out: a shape whose faces the kernel accepts, or nothing if it would have more
// faces than fit. Units: mm. Cost: a few simplifications of the mesh. Throws Error(ExportFailed,
// "InvalidFaces"), Error(Cancelled).
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
#include "swept/step_export.h"

namespace swept::step {

struct Built {
  Model model;
  Brep brep;
  std::map<std::string, std::int64_t> facesByKind;
  double deviation = 0;  // mm, of the mesh's vertices from their faces
};

/// faces: receives their number, also if there are too many.
std::optional<Built> makeShape(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense,
                               const StepOptions& options,
                               const std::function<bool(std::int64_t)>& fits, KernelSession& kernel,
                               std::int64_t& faces, RunContext& run);

}  // namespace swept::step
