// SPDX-License-Identifier: LGPL-2.1-or-later
#include "overlap/meetings.h"

#include <algorithm>
#include <string>

#include "base/number_text.h"
#include "base/parallel.h"
#include "geometry/half_edges.h"

namespace swept::overlap {
namespace {

constexpr std::size_t kEdgeBlock = 1 << 10;

/// Returns whether an edge, which crosses the plane of a triangle, passes through the triangle.
/// `before` is the side of the plane on which the edge begins (1 or -1).
bool passesInside(const Lattice& lattice, Side side, const Edge& edge,
                  const Lattice::Corners& triangle, int before) {
  for (int k = 0; k < 3; ++k) {
    const std::int32_t p = triangle[k], q = triangle[(k + 1) % 3];
    const int turn = side == Side::Shrunk ? lattice.turnOf(edge.from, edge.to, p, q)
                                          : lattice.turnOf(p, q, edge.from, edge.to);
    if (turn != -before) return false;
  }
  return true;
}

/// Union-find over vertices connected by edges. Stores for each vertex by how much its winding
/// number differs from that of the root of its set.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count), offset_(count, 0) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = static_cast<std::int32_t>(i);
  }
  std::int32_t find(std::int32_t v) {
    std::int32_t root = v, sum = 0;
    for (; parent_[root] != root; root = parent_[root]) sum += offset_[root];
    while (parent_[v] != root) {
      const std::int32_t next = parent_[v], own = offset_[v];
      parent_[v] = root;
      offset_[v] = sum;
      sum -= own;
      v = next;
    }
    return root;
  }
  /// Unites the sets of a and b, given that winding(b) = winding(a) + step.
  void join(std::int32_t a, std::int32_t b, std::int32_t step) {
    const std::int32_t ra = find(a), rb = find(b);
    if (ra == rb) return;
    const std::int32_t difference = offsetOf(a) + step - offsetOf(b);
    parent_[rb] = ra;
    offset_[rb] = difference;
  }
  std::int32_t offsetOf(std::int32_t v) { return find(v) == v ? 0 : offset_[v]; }

 private:
  std::vector<std::int32_t> parent_, offset_;
};

/// Adds the length of a piece of an edge to `once` or `more`. `winding`: winding number of the
/// other mesh about this piece.
void measure(Windings& windings, std::int32_t winding, double length) {
  if (winding == 1)
    windings.once += length;
  else if (winding != 0)
    windings.more += length;
}

}  // namespace

ClosedMesh closedMesh(const TriMesh& mesh, const std::string& name) {
  ClosedMesh closed;
  closed.mesh = &mesh;
  closed.edgeOf.assign(3 * mesh.triangles.size(), -1);
  const EdgeTable table(mesh);
  std::int64_t faults = 0;
  table.forEachEdge([&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                        const std::uint64_t* last) {
    const std::uint64_t* middle = std::partition_point(first, last, EdgeTable::ascending);
    if (middle - first != last - middle) {
      ++faults;
      return;
    }
    for (const std::uint64_t *up = first, *down = middle; up != middle; ++up, ++down) {
      const Edge edge{low, high, EdgeTable::halfEdge(*up), EdgeTable::halfEdge(*down)};
      closed.edgeOf[edge.forward] = closed.edgeOf[edge.backward] =
          static_cast<std::int32_t>(closed.edges.size());
      closed.edges.push_back(edge);
    }
  });
  if (faults > 0)
    throw Error(Status::InvalidInput, "OpenMesh",
                name + " is not closed (" + counted(faults, "edge does", "edges do") +
                    " not lie between two triangles that face the same way); close its gaps, or "
                    "give the whole solid");
  return closed;
}

BoxTree treeOf(const Lattice& lattice, Side side, const TriMesh& mesh) {
  return BoxTree(mesh.triangles.size(), [&](std::size_t t) {
    BoxTree::Bounds box;
    for (const std::int32_t v : mesh.triangles[t]) box.extend(lattice.position(side, v));
    return box;
  });
}

std::vector<Node> findNodes(const Lattice& lattice, Side side, const ClosedMesh& mesh,
                            const TriMesh& otherMesh, const BoxTree& tree, RunContext& run) {
  const auto nodesOf = [&](std::size_t e, std::vector<Node>& found) {
    if (e % kEdgeBlock == 0) run.checkpoint(Phase::Contour);
    const Edge& edge = mesh.edges[e];
    const Eigen::Vector3d a = lattice.position(side, edge.from),
                          b = lattice.position(side, edge.to);
    const std::size_t first = found.size();
    tree.forBox(a.cwiseMin(b), a.cwiseMax(b), [&](std::uint32_t index) {
      const std::int32_t t = tree.item(index);
      const Lattice::Corners& triangle = otherMesh.triangles[t];
      const int before = lattice.sideOf(side, edge.from, triangle);
      if (before == 0 || lattice.sideOf(side, edge.to, triangle) != -before) return;
      if (!passesInside(lattice, side, edge, triangle, before)) return;
      const double from = lattice.heightOf(side, edge.from, triangle);
      const double to = lattice.heightOf(side, edge.to, triangle);
      Node node{static_cast<std::int32_t>(e), t, before > 0};
      node.fraction = from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
      const Eigen::Vector3d &p = mesh.mesh->vertices[edge.from], &q = mesh.mesh->vertices[edge.to];
      node.point = p + node.fraction * (q - p);
      found.push_back(node);
    });
    std::sort(found.begin() + first, found.end(), [](const Node& x, const Node& y) {
      return x.fraction != y.fraction ? x.fraction < y.fraction : x.triangle < y.triangle;
    });
  };
  return gather<Node>(mesh.edges.size(), kEdgeBlock, nodesOf);
}

Windings findWindings(const Lattice& lattice, Side side, const ClosedMesh& mesh,
                      const TriMesh& otherMesh, const BoxTree& tree, const std::vector<Node>& nodes,
                      RunContext& run) {
  std::vector<std::int32_t> steps(mesh.edges.size(), 0);
  for (const Node& node : nodes) steps[node.edge] += node.enters ? 1 : -1;
  const std::size_t count = mesh.mesh->vertices.size();
  Pieces pieces(count);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    pieces.join(mesh.edges[e].from, mesh.edges[e].to, steps[e]);
  std::vector<std::int32_t> ofRoot(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    const auto vertex = static_cast<std::int32_t>(v);
    if (pieces.find(vertex) != vertex) continue;
    run.checkpoint(Phase::Contour);
    const Eigen::Vector3d at = lattice.position(side, vertex);
    const Eigen::Vector3d top(at.x(), at.y(), std::max(at.z(), tree.bounds().high.z()));
    tree.forBox(at, top, [&](std::uint32_t index) {
      ofRoot[v] += lattice.rayThrough(side, vertex, otherMesh.triangles[tree.item(index)]);
    });
  }
  Windings found;
  found.ofVertex.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    const auto vertex = static_cast<std::int32_t>(v);
    found.ofVertex[v] = ofRoot[pieces.find(vertex)] + pieces.offsetOf(vertex);
  }
  std::size_t n = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Edge& edge = mesh.edges[e];
    const double length = (mesh.mesh->vertices[edge.to] - mesh.mesh->vertices[edge.from]).norm();
    std::int32_t winding = found.ofVertex[edge.from];
    double fraction = 0;
    for (; n < nodes.size() && nodes[n].edge == std::int32_t(e); ++n) {
      measure(found, winding, length * (nodes[n].fraction - fraction));
      winding += nodes[n].enters ? 1 : -1;
      fraction = nodes[n].fraction;
    }
    measure(found, winding, length * (1 - fraction));
  }
  return found;
}

}  // namespace swept::overlap
