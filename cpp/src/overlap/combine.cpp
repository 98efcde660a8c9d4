// SPDX-License-Identifier: LGPL-2.1-or-later
#include "overlap/combine.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "base/fault_text.h"
#include "base/limits.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "geometry/flat_polygons.h"
#include "geometry/half_edges.h"
#include "geometry/mesh_parts.h"
#include "geometry/shells.h"
#include "overlap/meetings.h"

namespace swept::overlap {
namespace {

constexpr std::size_t kTriangleBlock = 1 << 10;

/// A directed edge on the border of a piece of a triangle. `from` and `to`: indices of points in
/// the result.
struct Link {
  std::int32_t triangle;
  std::int32_t from, to;
  auto operator<=>(const Link&) const = default;
};

[[noreturn]] void failBroken(const std::string& what) {
  throw Error(Status::InternalError, "InternalError",
              "the computed surface of the shared volume is not closed (" + what + ")" +
                  faultText("the parts"));
}

/// Throws if more than a small part of the solid `name` overlaps itself. `windings`: winding
/// numbers of this solid along the edges of the solid `other`. A smaller overlap is accepted; its
/// volume then counts more than once.
void requireNoSelfOverlap(const Windings& windings, const std::string& name,
                          const std::string& other) {
  constexpr double kMaxFraction = 0.01;
  if (windings.more <= kMaxFraction * (windings.once + windings.more)) return;
  throw Error(Status::InvalidInput, "OverlappingShells",
              name + " overlaps itself (" +
                  numberText(100 * windings.more / (windings.once + windings.more), 3) +
                  " % of the edges of " + other + " inside " + name +
                  " lie in such an overlap), so their shared volume is ambiguous; give each solid "
                  "of " +
                  name + " separately, or fuse them first");
}

class Builder {
 public:
  Builder(Keep keep, const TriMesh& shrunk, const std::string& shrunkName, const TriMesh& fixed,
          const std::string& fixedName, RunContext& run)
      : keepsInside_(keep == Keep::Inside),
        run_(run),
        lattice_(shrunk, fixed),
        meshes_{closedMesh(shrunk, shrunkName), closedMesh(fixed, fixedName)},
        names_{shrunkName, fixedName} {}

  TriMesh build() {
    for (const Side side : {Side::Shrunk, Side::Fixed}) {
      const ClosedMesh& mesh = of(side);
      const TriMesh& otherMesh = *of(other(side)).mesh;
      const BoxTree tree = treeOf(lattice_, other(side), otherMesh);
      nodes_[int(side)] = findNodes(lattice_, side, mesh, otherMesh, tree, run_);
      windings_[int(side)] =
          findWindings(lattice_, side, mesh, otherMesh, tree, nodes_[int(side)], run_);
      requireNoSelfOverlap(windings_[int(side)], names_[int(other(side))], names_[int(side)]);
    }
    numberPoints();
    findSegments();
    for (const Side side : {Side::Shrunk, Side::Fixed}) addTriangles(side);
    return std::move(out_);
  }

 private:
  const ClosedMesh& of(Side side) const { return meshes_[int(side)]; }
  std::int32_t vertexNumber(Side side, std::int32_t vertex) const {
    return firstVertex_[int(side)] + vertex;
  }
  std::int32_t nodeNumber(Side side, std::size_t node) const {
    return firstNode_[int(side)] + static_cast<std::int32_t>(node);
  }

  /// Returns how many copies of a vertex are kept: 0 or 1, or another number if the other solid
  /// overlaps itself there.
  std::int32_t copies(Side side, std::int32_t vertex) const {
    const std::int32_t winding = windings_[int(side)].ofVertex[vertex];
    return keepsInside_ ? winding : 1 - winding;
  }
  /// Returns whether the kept part of an edge begins at this node, in the direction of the edge.
  bool begins(const Node& node) const { return node.enters == keepsInside_; }

  /// Adds the vertices of both meshes and then their nodes to the result. withoutFlatShells()
  /// removes those that no triangle uses.
  void numberPoints() {
    std::size_t count = 0;
    for (const Side side : {Side::Shrunk, Side::Fixed})
      count += of(side).mesh->vertices.size() + nodes_[int(side)].size();
    if (count > kMaxElements)
      throw Error(Status::ResourceLimit, "ResourceLimit",
                  "the mesh of the volume shared by " + names_[0] + " and " + names_[1] +
                      " would have " + std::to_string(count) + " vertices, but the limit is " +
                      std::to_string(kMaxElements) + "; use coarser meshes");
    for (const Side side : {Side::Shrunk, Side::Fixed}) {
      firstVertex_[int(side)] = static_cast<std::int32_t>(out_.vertices.size());
      const std::vector<Eigen::Vector3d>& own = of(side).mesh->vertices;
      out_.vertices.insert(out_.vertices.end(), own.begin(), own.end());
    }
    for (const Side side : {Side::Shrunk, Side::Fixed}) {
      firstNode_[int(side)] = static_cast<std::int32_t>(out_.vertices.size());
      for (const Node& node : nodes_[int(side)]) out_.vertices.push_back(node.point);
    }
  }

  /// Finds the segments. Two intersecting triangles, one of each mesh, share two nodes. Between
  /// these nodes, the border of the piece of each triangle runs along the other triangle.
  void findSegments() {
    struct End {
      std::int32_t shrunk, fixed;
      bool last;  ///< true: the segment on the shrunk mesh's triangle ends here; false: it begins
      std::int32_t point;
      auto operator<=>(const End&) const = default;
    };
    std::vector<End> ends;
    for (const Side side : {Side::Shrunk, Side::Fixed}) {
      const std::vector<Node>& nodes = nodes_[int(side)];
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        const Edge& edge = of(side).edges[nodes[n].edge];
        for (const bool forward : {true, false}) {
          const std::int64_t half = forward ? edge.forward : edge.backward;
          const auto own = static_cast<std::int32_t>(half / 3);
          const bool begin = begins(nodes[n]) == forward;
          if (side == Side::Shrunk)
            ends.push_back({own, nodes[n].triangle, begin, nodeNumber(side, n)});
          else
            ends.push_back({nodes[n].triangle, own, !begin, nodeNumber(side, n)});
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    if (ends.size() % 2 != 0) failBroken("an end of a segment is missing");
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      const End &a = ends[i], &b = ends[i + 1];
      if (a.shrunk != b.shrunk || a.fixed != b.fixed || a.last || !b.last)
        failBroken("triangles " + std::to_string(a.shrunk) + " and " + std::to_string(a.fixed));
      segments_[int(Side::Shrunk)].push_back({a.shrunk, a.point, b.point});
      segments_[int(Side::Fixed)].push_back({a.fixed, b.point, a.point});
    }
    for (std::vector<Link>& list : segments_) std::sort(list.begin(), list.end());
  }

  /// Calls visit(from, to) for the kept pieces of an edge. `from` is nearer to Edge::from. `starts`
  /// is a buffer for reuse.
  template <class Visit>
  void forPieces(Side side, std::int32_t e, const std::vector<std::size_t>& firstOfEdge,
                 std::vector<std::int32_t>& starts, const Visit& visit) const {
    const Edge& edge = of(side).edges[e];
    const std::vector<Node>& nodes = nodes_[int(side)];
    // If the number of copies of a vertex is negative, beginnings and ends of pieces are exchanged
    // there.
    const std::int32_t first = copies(side, edge.from), last = copies(side, edge.to);
    starts.assign(std::max(first, 0), vertexNumber(side, edge.from));
    for (std::size_t n = firstOfEdge[e]; n < firstOfEdge[e + 1]; ++n)
      if (begins(nodes[n])) starts.push_back(nodeNumber(side, n));
    starts.insert(starts.end(), std::max(-last, 0), vertexNumber(side, edge.to));
    std::size_t used = 0;
    const auto end = [&](std::int32_t point) {
      if (used == starts.size()) failBroken("edge " + std::to_string(e));
      visit(starts[used++], point);
    };
    for (std::int32_t k = 0; k < -first; ++k) end(vertexNumber(side, edge.from));
    for (std::size_t n = firstOfEdge[e]; n < firstOfEdge[e + 1]; ++n)
      if (!begins(nodes[n])) end(nodeNumber(side, n));
    for (std::int32_t k = 0; k < last; ++k) end(vertexNumber(side, edge.to));
    if (used != starts.size()) failBroken("edge " + std::to_string(e));
  }

  void addTriangles(Side side) {
    const ClosedMesh& mesh = of(side);
    std::vector<std::size_t> firstOfEdge(mesh.edges.size() + 1, 0);
    for (const Node& node : nodes_[int(side)]) ++firstOfEdge[node.edge + 1];
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) firstOfEdge[e + 1] += firstOfEdge[e];
    using Triangle = std::array<std::int32_t, 3>;
    const std::vector<Triangle> found =
        gather<Triangle>(mesh.mesh->triangles.size(), kTriangleBlock,
                         [&](std::size_t t, std::vector<Triangle>& triangles) {
                           if (t % kTriangleBlock == 0) run_.checkpoint(Phase::Contour);
                           addTriangle(side, static_cast<std::int32_t>(t), firstOfEdge, triangles);
                         });
    out_.triangles.insert(out_.triangles.end(), found.begin(), found.end());
  }

  /// Appends the triangles of the kept piece of a triangle.
  void addTriangle(Side side, std::int32_t t, const std::vector<std::size_t>& firstOfEdge,
                   std::vector<std::array<std::int32_t, 3>>& triangles) const {
    const ClosedMesh& mesh = of(side);
    std::vector<Link> links;
    std::vector<std::int32_t> starts;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t e = mesh.edgeOf[3 * std::int64_t(t) + k];
      const bool forward = mesh.edges[e].forward == 3 * std::int64_t(t) + k;
      forPieces(side, e, firstOfEdge, starts, [&](std::int32_t from, std::int32_t to) {
        links.push_back(forward ? Link{t, from, to} : Link{t, to, from});
      });
    }
    const std::vector<Link>& all = segments_[int(side)];
    for (auto own = std::lower_bound(all.begin(), all.end(), Link{t, -1, -1});
         own != all.end() && own->triangle == t; ++own)
      links.push_back(*own);
    if (links.empty()) return;
    const auto& corners = mesh.mesh->triangles[t];
    const std::vector<Eigen::Vector3d>& points = mesh.mesh->vertices;
    const Eigen::Vector3d normal =
        (points[corners[1]] - points[corners[0]]).cross(points[corners[2]] - points[corners[0]]);
    cutIntoTriangles(loopsOf(links, t), out_.vertices, normal, triangles);
  }

  static std::vector<Loop> loopsOf(std::vector<Link>& links, std::int32_t t) {
    std::sort(links.begin(), links.end());
    std::vector<char> seen(links.size(), 0);
    std::vector<Loop> loops;
    for (std::size_t first = 0; first < links.size(); ++first) {
      if (seen[first] != 0) continue;
      Loop loop;
      std::size_t at = first;
      do {
        seen[at] = 1;
        loop.push_back(links[at].from);
        if (links[at].to == loop.front()) break;
        auto next = std::lower_bound(links.begin(), links.end(), Link{t, links[at].to, -1});
        while (next != links.end() && next->from == links[at].to && seen[next - links.begin()] != 0)
          ++next;
        if (next == links.end() || next->from != links[at].to)
          failBroken("triangle " + std::to_string(t));
        at = static_cast<std::size_t>(next - links.begin());
      } while (true);
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  const bool keepsInside_;
  RunContext& run_;
  Lattice lattice_;
  std::array<ClosedMesh, 2> meshes_;
  std::array<std::string, 2> names_;
  std::array<std::vector<Node>, 2> nodes_;
  std::array<Windings, 2> windings_;
  std::array<std::int32_t, 2> firstVertex_{}, firstNode_{};
  std::array<std::vector<Link>, 2> segments_;  ///< sorted by triangle
  TriMesh out_;
};

/// Copies the mesh without shells whose mean thickness is at most `flat` (mm). Such shells arise
/// where faces of the two solids coincide. Computes volume and area.
Combined withoutFlatShells(const TriMesh& mesh, double flat) {
  const Adjacency adjacency = findAdjacency(mesh);
  if (adjacency.faults.open > 0 || adjacency.faults.misoriented > 0)
    failBroken(std::to_string(adjacency.faults.open + adjacency.faults.misoriented) + " edges");
  const Shells shells = shellsByVertices(mesh);
  const std::vector<ShellExtent> extents = measureShells(mesh, shells);
  std::vector<double> areas(shells.count, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& tri = mesh.triangles[t];
    const Eigen::Vector3d &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]],
                          &c = mesh.vertices[tri[2]];
    areas[shells.ofTriangle[t]] += 0.5 * (b - a).cross(c - a).norm();
  }
  Combined shared;
  std::vector<std::int32_t> number(mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::int32_t shell = shells.ofTriangle[t];
    if (std::abs(extents[shell].volume) <= 0.5 * areas[shell] * flat) continue;
    takeTriangle(mesh, t, number, shared.mesh);
  }
  for (std::int32_t s = 0; s < shells.count; ++s)
    if (std::abs(extents[s].volume) > 0.5 * areas[s] * flat) {
      shared.volume += extents[s].volume;
      shared.area += areas[s];
    }
  return shared;
}

}  // namespace

Combined combine(Keep keep, const TriMesh& first, const std::string& firstName,
                 const TriMesh& second, const std::string& secondName, RunContext& run) {
  constexpr double kFlat = 1e-9;  // fraction of the diagonal of the common bounding box
  const Eigen::AlignedBox3d a = boxOf(first), b = boxOf(second);
  // The smaller solid is shrunk. If it lies inside the other one, shrinking moves it away from
  // walls that it touches, so no flat shells arise there.
  const bool swapped = b.diagonal().norm() < a.diagonal().norm();
  Builder builder(keep, swapped ? second : first, swapped ? secondName : firstName,
                  swapped ? first : second, swapped ? firstName : secondName, run);
  const TriMesh whole = builder.build();
  return withoutFlatShells(whole, kFlat * a.merged(b).diagonal().norm());
}

}  // namespace swept::overlap
