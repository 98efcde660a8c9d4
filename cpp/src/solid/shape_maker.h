// Turns a mesh into a model of a solid (model/model.h): recognises surfaces, simplifies the other
// triangles, and builds faces and edges. The judge (model/judge.h) asks the geometry kernel whether
// the faces are valid. If some are not, all is repeated without the surfaces of these faces.
// In:      `dense`, the mesh to work on; `whole`, the mesh from which the deviation is measured;
//        the options with the tolerance; fits(count), which returns whether that many faces are
//        allowed.
// Out:     a model whose faces the judge accepts, or nothing if it would have too many faces.
// Units:   mm.
// Cost:    a few simplifications of the mesh.
// Throws Error(ExportFailed, "InvalidFaces"), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "solid/mesh/half_edge.h"
#include "solid/model/judge.h"
#include "solid/model/model.h"
#include "swept/solid.h"

namespace swept::step {

struct Built {
  /// Without faces if the judge assembled the solid itself (body_solid.h).
  Model model;
  std::map<std::string, std::int64_t> facesByKind;
  double deviation = 0;  // mm, of the mesh's vertices from the faces of the solid
  double meshError = 0;  // mm, of an assembled solid: how far most of the mesh lies off it

  std::int64_t faceCount() const {
    std::int64_t count = 0;
    for (const auto& [kind, faces] : facesByKind) count += faces;
    return count;
  }
};

/// Returns the model, or nothing. The judge was given this model last (Judge::setModel()). `faces`
/// receives the number of faces, even if there are too many.
std::optional<Built> makeShape(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense,
                               const SolidOptions& options,
                               const std::function<bool(std::int64_t)>& fits, Judge& judge,
                               std::int64_t& faces, RunContext& run);

}  // namespace swept::step
