// The solid as plain data (vertices, edges, faces, shells), independent of a CAD kernel.
// In:      HalfEdgeMesh and Partition.
// Out:     Model.
// Units:   mm.
// Cost:    O(n) for n triangles.
// Promise: Each edge belongs to exactly two faces, or twice to one face (seam). Loops are simple.
//          Outer loops run counter-clockwise, seen from outside.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solid/carrier/carrier.h"
#include "solid/carrier/curve.h"
#include "solid/mesh/half_edge.h"
#include "solid/mesh/patches.h"

namespace swept::step {

struct ModelVertex {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double tolerance = 0;  ///< mm: largest distance from the surfaces that meet here
};

struct ModelEdge {
  std::int32_t start = 0, end = 0;
  Curve curve;           ///< from start to end
  double tolerance = 0;  ///< mm: largest distance from the two surfaces
};

struct ModelUse {
  std::int32_t edge = 0;
  bool forward = true;
};

struct ModelFace {
  Carrier surface;
  std::vector<std::vector<ModelUse>> loops;
  std::int32_t shell = 0;
  std::int32_t patch = 0;
};

struct Model {
  std::vector<ModelVertex> vertices;
  std::vector<ModelEdge> edges;
  std::vector<ModelFace> faces;  ///< grouped by shell
  /// Final position of each mesh vertex; some were moved onto surfaces.
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::int32_t> shellOwner;  ///< as in HalfEdgeMesh
};

/// Builds the model. `tolerance`: mm, largest distance of a dropped border vertex from the straight
/// edge that replaces it.
Model buildModel(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                 RunContext& run);

/// Returns the number of the faces and a position on the first one, for a message. `faces`: at
/// least one, by index.
std::string facesText(const std::vector<std::int32_t>& faces, const Model& model);

}  // namespace swept::step
