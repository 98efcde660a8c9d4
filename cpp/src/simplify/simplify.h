// Simplification of the envelope: fewer triangles, nowhere farther from the surface than a length.
//
// In:    a closed manifold surface and the grid it was made on. Out: a closed manifold mesh.
// Steps: a cut through the vertex tree (vertex_tree.h) takes what is flat in large pieces, an edge
//        collapse (edge_collapse.h) takes the rest within the tolerance; then the deviation is
//        measured both ways and triangles that meet are looked for; where the result fails, the
//        surface there is left as it was, and the cut is made again.
// A SimplifyTree is kept to cut the same surface again at another tolerance. What is coarser than
// kBaseCells is cut from a base: the surface within a fiftieth of a cell, simplified once, with a
// tree of its own; the base's deviation is taken off the tolerance and added to the result's.
// Units: mm outside, cells inside. Cost: O(n) for the tree, O(n log n) for the base and for fine
// cuts; a coarse cut costs O(b log b) for b triangles of the base.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "grid/grid_plan.h"
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

  /// tolerance: mm, above 0. Safe to call from several threads; the bytes depend on the tolerance
  /// alone, never on earlier cuts.
  Simplified cut(double tolerance, const PairFinder& findPairs, RunContext& run) const;

  const TriMesh& mesh() const { return mesh_; }
  const std::vector<double>& contactTime() const { return contactTime_; }
  /// Of the surface as it is without simplification.
  std::vector<std::array<std::int32_t, 2>> featureEdges() const;

 private:
  /// The surface simplified a little, as a tree of its own; what that cost, in mm.
  struct Base {
    std::unique_ptr<SimplifyTree> tree;
    double deviation = 0;
  };
  const Base& base(const PairFinder& findPairs, RunContext& run) const;
  /// accepted: mm, a measured deviation that ends the rounds even if it is above the tolerance.
  Simplified cutFromHere(double tolerance, double accepted, const PairFinder& findPairs,
                         RunContext& run) const;

  TriMesh mesh_;
  std::vector<double> contactTime_;
  GridPlan plan_;
  std::vector<Eigen::Vector3d> points_;  ///< vertices in cells
  VertexTree tree_;
  std::vector<std::uint8_t> creased_;  ///< per triangle: touches a vertex of rank 2 or 3
  std::unique_ptr<NearestTriangle> nearest_;
  mutable std::mutex baseMutex_;
  mutable Base base_;  ///< made by the first coarse cut
};

}  // namespace swept
