// Makes a kernel shape from a mesh: recognises surfaces, simplifies, and builds the model. If the
// kernel refuses faces, their surfaces are given up and the steps are repeated.
// In: `dense`, the mesh to work on; `whole`, the mesh from which the deviation is measured; the
// tolerance of the options. Out: a shape whose faces the kernel accepts, or nothing if fits()
// refuses the number of faces. Units: mm. Cost: a few simplifications of the mesh. Throws
// Error(ExportFailed, "InvalidFaces"), Error(Cancelled).
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
  double deviation = 0;  // mm, largest distance of a mesh vertex from its face
};

/// `faces` receives the number of faces, even if fits() refuses it.
std::optional<Built> makeShape(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense,
                               const StepOptions& options,
                               const std::function<bool(std::int64_t)>& fits, KernelSession& kernel,
                               std::int64_t& faces, RunContext& run);

}  // namespace swept::step
