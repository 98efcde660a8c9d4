// Simplification of the envelope: fewer triangles, nowhere farther from the surface than a length.
//
// In:    a closed manifold surface and the grid it was made on. Out: a closed manifold mesh.
// Steps: a cut through the vertex tree (vertex_tree.h) takes what is flat in large pieces, an edge
//        collapse (edge_collapse.h) takes the rest within the tolerance; then the deviation is
//        measured both ways and triangles that meet are looked for; where the result fails, the
//        surface there is left as it was, and the cut is made again.
// A SimplifyTree is kept to cut the same surface again at another tolerance.
// Units: mm outside, cells inside. Cost: O(n) for the tree, O(n log n) for a cut.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "data/grid_plan.h"
#include "simplify/nearest_triangle.h"
#include "simplify/vertex_tree.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Pairs of triangles of a mesh that meet where they should not.
using PairFinder =
    std::function<std::vector<std::pair<std::int32_t, std::int32_t>>(const TriMesh&)>;

struct Simplified {
  TriMesh mesh;
  std::vector<double> contactTime;
  std::vector<std::array<std::int32_t, 2>> featureEdges;  ///< vertex pairs along creases
  double deviation = 0;           ///< mm, the larger of both directions, measured
  std::size_t treeTriangles = 0;  ///< triangles after the cut, before the edge collapse
  int rounds = 0;
};

class SimplifyTree {
 public:
  SimplifyTree(TriMesh mesh, std::vector<double> contactTime, const GridPlan& plan,
               RunContext& run);

  /// tolerance: mm, above 0.
  Simplified cut(double tolerance, const PairFinder& findPairs, RunContext& run) const;

  const TriMesh& mesh() const { return mesh_; }
  const std::vector<double>& contactTime() const { return contactTime_; }
  /// Of the surface as it is without simplification.
  std::vector<std::array<std::int32_t, 2>> featureEdges() const;

 private:
  TriMesh mesh_;
  std::vector<double> contactTime_;
  GridPlan plan_;
  std::vector<Eigen::Vector3d> points_;  ///< vertices in cells
  VertexTree tree_;
  std::vector<std::uint8_t> creased_;  ///< per triangle: touches a vertex of rank 2 or 3
  std::unique_ptr<NearestTriangle> nearest_;
};

}  // namespace swept
