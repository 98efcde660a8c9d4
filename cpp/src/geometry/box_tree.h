// Bounding boxes of triangles, eight to a leaf, in an implicit tree with four children a node.
// In:    a finite mesh. Out: leaves and boxes for a search of overlapping pairs.
// Order: triangles are sorted by size class (powers of four), then along a Hilbert curve, so that
//        neighbours in the list are neighbours in space and large triangles do not blow up the
//        boxes of small ones.
// Boxes are in float, relative to the middle of the mesh and rounded outward.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/raw_array.h"
#include "swept/types.h"

namespace swept {

constexpr int kLeafSize = 8;

struct alignas(32) TriangleLeaf {
  float low[3][kLeafSize];
  float high[3][kLeafSize];
  std::int32_t vertex[3][kLeafSize];
  std::int32_t triangle[kLeafSize];  ///< -1: empty place, its box meets nothing
};

struct FloatBox {
  std::array<float, 3> low, high;
  bool meets(const FloatBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

struct BoxTree {
  RawArray<TriangleLeaf> leaves;
  /// levels[0]: boxes of the leaves; levels[k][i] covers levels[k-1][4i .. 4i+3]. The last has one.
  std::vector<std::vector<FloatBox>> levels;
};

BoxTree buildBoxTree(const TriMesh& mesh);

}  // namespace swept
