// Finds the edges of a body, and the normals and heights of its faces. Here a face is a triangle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept {

struct BodyEdge {
  std::int32_t a = 0, b = 0;           ///< vertices, a < b
  std::int32_t left = -1, right = -1;  ///< faces; right is -1 unless the edge has two faces
  bool opposed = false;                ///< the two faces have opposite orientations
};

struct BodyTopology {
  std::vector<BodyEdge> edges;           ///< sorted by (a, b)
  std::vector<Eigen::Vector3f> normals;  ///< unit, per face
  std::vector<float> heights;            ///< mm, smallest height of each face
};

BodyTopology buildTopology(const TriMesh& body);

}  // namespace swept
