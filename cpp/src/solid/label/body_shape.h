// The faces and edges of a moving body, as carriers and curves. Plain data, without the kernel.
// Units:   mm, in coordinates of the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solid/carrier/carrier.h"
#include "solid/carrier/curve.h"

namespace swept {

struct BodyFace {
  /// Its kind is Facet if a Carrier cannot represent the surface.
  step::Carrier surface;
  std::vector<std::int32_t> edges;  ///< indices into BodyShape::edges
};

struct BodyEdge {
  step::Curve curve;
  /// The faces on both sides, the lower number first; -1: none.
  std::array<std::int32_t, 2> faces{-1, -1};
  double tolerance = 0;  ///< mm: how far the curve may lie from its faces
};

/// The numbers of the faces are those of TriMesh::faceOf.
struct BodyShape {
  std::vector<BodyFace> faces;
  std::vector<BodyEdge> edges;  ///< without seams of closed faces
};

}  // namespace swept
