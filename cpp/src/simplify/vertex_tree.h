// Vertex tree: which vertices of the surface may be merged into one, over the linear octree of
// their cells.
//
// In:   the uniform surface in cells (vertex position / cell side). Out: nodes; leaves are the
//       vertices, an inner node stands for vertices of one octree node that are joined by mesh
//       edges within it. Two component vertices are joined by an edge exactly if they share a
//       crossing, on the octree node's outer faces as well as inside it.
// Node: sum of the quadrics, mass point of the children of highest feature rank, minimiser, error,
//       and whether the patch is a disc: it is connected, so it is one if V - E + F = 1 over the
//       vertices, edges and triangles that lie wholly in it (a handle or a second boundary cycle
//       makes this smaller, a closed shell larger).
// Cost: O(n) after a sort by cell; about 200 bytes a vertex. Thesis section 4.5, Ju et al. 2002,
//       Schaefer, Ju and Warren 2007.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/quadric.h"
#include "swept/run_context.h"

namespace swept {

using Triangles = std::vector<std::array<std::int32_t, 3>>;

struct TreeNode {
  Quadric quadric;
  Eigen::Vector3d mass, position;
  double error = 0;  ///< cells, root of the mean squared distance to the planes
  std::int32_t parent = -1;
  std::int32_t sample = -1;  ///< a vertex of the patch that lies near the position
  std::int16_t rank = 0;
  bool disc = true;
};

class VertexTree {
 public:
  VertexTree() = default;
  void build(const std::vector<Eigen::Vector3d>& vertices, const Triangles& triangles,
             RunContext& run);

  const std::vector<TreeNode>& nodes() const { return nodes_; }
  std::size_t leaves() const { return leaves_; }

 private:
  void makeLeaves(const std::vector<Eigen::Vector3d>& vertices, const Triangles& triangles);
  void solve(std::size_t begin, std::size_t end, int level);

  std::vector<TreeNode> nodes_;
  std::size_t leaves_ = 0;
};

/// What stands for the vertices at one tolerance.
struct TreeCut {
  std::vector<std::int32_t> node;    ///< per vertex: its node in the cut
  std::vector<std::int32_t> vertex;  ///< per vertex: its vertex in `nodeOf`
  std::vector<std::int32_t> nodeOf;  ///< per vertex of the cut
  Triangles triangles;               ///< of vertices of the cut
};

/// blocked: one a node, changed. Cuts where the error falls below `tolerance` (cells) and no node
/// is blocked; nodes that would make an edge of more than two triangles or turn a triangle over are
/// blocked and split, so the result is a closed manifold if the surface is.
TreeCut cutTree(const VertexTree& tree, const Triangles& triangles, double tolerance,
                std::vector<std::uint8_t>& blocked, RunContext& run);

}  // namespace swept
