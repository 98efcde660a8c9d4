// Where the edges of one mesh go through the triangles of another.
// In:    two closed meshes on one lattice. Out: for each edge the triangles that it goes through,
//        where that is, and whether the edge enters the other solid there or leaves it.
// Cost:  O(n log n), all cores.
// Promise: exact: an edge that goes through the surface between two triangles goes through one of
//        them, and any two triangles with area share no nodes or two of them, a segment.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/box_tree.h"
#include "overlap/lattice.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::overlap {

/// An edge with the two half-edges along it; half-edge h = 3 * triangle + corner. Where more than
/// two triangles share an edge, each two of them have one of their own.
struct Edge {
  std::int32_t from = 0, to = 0;
  std::int64_t forward = 0, backward = 0;  ///< half-edges from -> to and to -> from
};

/// Closed and turned one way throughout: what Part::closed() says.
struct ClosedMesh {
  const TriMesh* mesh = nullptr;
  std::vector<Edge> edges;
  std::vector<std::int32_t> edgeOf;  ///< by half-edge
};

/// Throws Error(InvalidInput, "OpenMesh") if an edge has not as many triangles one way as the
/// other.
ClosedMesh closedMesh(const TriMesh& mesh, const std::string& name);

struct Node {
  std::int32_t edge = 0;      ///< of its mesh
  std::int32_t triangle = 0;  ///< of the other mesh
  bool enters = false;        ///< the other solid, on the way from Edge::from to Edge::to
  double share = 0;           ///< of that way
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< mm
};

/// The boxes of one mesh's triangles, in steps of the lattice.
BoxTree treeOf(const Lattice& lattice, Side side, const TriMesh& mesh);

/// Nodes of the edges of one mesh, sorted by edge, and along each edge as far as rounding can tell.
/// there, tree: the other mesh and its treeOf().
std::vector<Node> findNodes(const Lattice& lattice, Side side, const ClosedMesh& mesh,
                            const TriMesh& there, const BoxTree& tree, RunContext& run);

struct Windings {
  std::vector<std::int32_t> ofVertex;  ///< how often the other solid goes round it: 0 outside, 1 in
  /// mm of this mesh's edges that the other solid goes round once, and any other number of times
  /// but 0.
  double once = 0, more = 0;
};

/// As findNodes(); nodes: of this mesh's edges.
Windings findWindings(const Lattice& lattice, Side side, const ClosedMesh& mesh,
                      const TriMesh& there, const BoxTree& tree, const std::vector<Node>& nodes,
                      RunContext& run);

}  // namespace swept::overlap
