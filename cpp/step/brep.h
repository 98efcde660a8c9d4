// Model -> kernel shape, and what is checked on a shape.
// Each function assumes that the caller holds a KernelSession.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <string>
#include <vector>

#include "model.h"
#include "swept/run_context.h"

namespace swept::step {

struct Brep {
  TopoDS_Shape shape;               ///< one solid, or a compound of solids
  std::vector<TopoDS_Shape> faces;  ///< in the order of Model::faces
  std::vector<std::int32_t>
      failed;  ///< faces for which the kernel could not even make what they need
};

Brep buildBrep(const Model& model, RunContext& run);

/// Indices of faces that the kernel's checker refuses. Parallel. from, to: share of the export's
/// progress.
std::vector<std::int32_t> findBadFaces(const std::vector<TopoDS_Shape>& faces, RunContext& run,
                                       double from, double to);

struct ShapeCheck {
  std::int64_t solids = 0, shells = 0, faces = 0, edges = 0;
  bool valid = false;     ///< every face valid, every shell closed and consistently oriented
  std::string complaint;  ///< empty when valid
  double volume = 0;      ///< mm^3
};

ShapeCheck checkShape(const TopoDS_Shape& shape, RunContext& run, double from, double to);

}  // namespace swept::step
