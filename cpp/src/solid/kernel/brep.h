// Makes the kernel shape of a Model. The caller must hold a KernelSession.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <string>
#include <vector>

#include "solid/model/model.h"
#include "swept/run_context.h"

namespace swept::step {

struct Brep {
  TopoDS_Shape shape;               ///< one solid, or a compound of solids
  std::vector<TopoDS_Shape> faces;  ///< in the order of Model::faces
  std::vector<TopoDS_Edge> edges;   ///< in the order of Model::edges
  /// Indices of faces whose edges, wires or parameter curves the kernel could not make.
  std::vector<std::int32_t> failed;
};

Brep buildBrep(const Model& model, RunContext& run);

}  // namespace swept::step
