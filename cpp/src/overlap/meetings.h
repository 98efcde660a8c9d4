// Finds where the edges of one mesh pass through the triangles of another mesh, and the winding
// number of the other mesh about each vertex.
// In:    two closed meshes on one lattice. Out: nodes. A node is a point at which an edge of one
//        mesh passes through a triangle of the other mesh, and so enters or leaves the other solid.
// Cost:  O(n log n) for n triangles, on all cores.
// Promise: exact. An edge that passes through the common edge of two triangles has a node with
//        exactly one of them. Any two triangles with area share no nodes, or two nodes that are the
//        ends of a segment.
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

/// An edge with the two half-edges along it; half-edge h = 3 * triangle + corner. If more than two
/// triangles share an edge, they are paired, and each pair has its own Edge.
struct Edge {
  std::int32_t from = 0, to = 0;
  std::int64_t forward = 0, backward = 0;  ///< half-edges from -> to and to -> from
};

/// A mesh in which as many triangles run along every edge in one direction as in the other.
struct ClosedMesh {
  const TriMesh* mesh = nullptr;
  std::vector<Edge> edges;
  std::vector<std::int32_t> edgeOf;  ///< by half-edge: index of its edge
};

/// Finds the edges of a mesh, and keeps a pointer to the mesh. Throws Error(InvalidInput,
/// "OpenMesh") if an edge has more half-edges in one direction than in the other.
ClosedMesh closedMesh(const TriMesh& mesh, const std::string& name);

struct Node {
  std::int32_t edge = 0;      ///< index of the edge in its mesh
  std::int32_t triangle = 0;  ///< index of the triangle in the other mesh
  /// True: the edge, followed in its direction, enters the other solid at the node; false: it
  /// leaves the other solid.
  bool enters = false;
  double fraction = 0;  ///< position of the node on the edge, from 0 to 1
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< mm
};

/// Returns a tree over the boxes of a mesh's triangles, in steps of the lattice.
BoxTree treeOf(const Lattice& lattice, Side side, const TriMesh& mesh);

/// Returns the nodes of the edges of `mesh`, sorted by edge and then by `fraction`, which is
/// rounded. `otherMesh`: the other mesh; `tree`: its treeOf().
std::vector<Node> findNodes(const Lattice& lattice, Side side, const ClosedMesh& mesh,
                            const TriMesh& otherMesh, const BoxTree& tree, RunContext& run);

struct Windings {
  /// For each vertex, the winding number of the other mesh about it: 0 outside the other solid, 1
  /// inside.
  std::vector<std::int32_t> ofVertex;
  /// `once`: total length (mm) of the parts of this mesh's edges on which the winding number of the
  /// other mesh is 1. `more`: of those on which it is neither 0 nor 1.
  double once = 0, more = 0;
};

/// Computes the winding numbers. The arguments are those of findNodes(); `nodes` is its result.
Windings findWindings(const Lattice& lattice, Side side, const ClosedMesh& mesh,
                      const TriMesh& otherMesh, const BoxTree& tree, const std::vector<Node>& nodes,
                      RunContext& run);

}  // namespace swept::overlap
