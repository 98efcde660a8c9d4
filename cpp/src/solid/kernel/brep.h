// Converts a Model to a shape of the OpenCASCADE kernel. The caller must hold a KernelSession.
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
  TopoDS_Shape shape;                ///< one solid, or a compound of solids
  std::vector<TopoDS_Shape> faces;   ///< in the order of Model::faces
  std::vector<TopoDS_Edge> edges;    ///< in the order of Model::edges
  std::vector<std::int32_t> failed;  ///< faces that the kernel could not build
};

Brep buildBrep(const Model& model, RunContext& run);

}  // namespace swept::step
