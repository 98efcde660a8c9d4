// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>

#include "base/parallel.h"
#include "geometry/half_edges.h"
#include "simplify/vertex_tree.h"

namespace swept {
namespace {

constexpr double kMinCosine = 0.3;  ///< between a triangle before and after

class Cutter {
 public:
  Cutter(const VertexTree& tree, const Triangles& triangles, std::vector<std::uint8_t>& blocked)
      : tree_(tree), triangles_(triangles), blocked_(blocked) {}

  void select(double tolerance) {
    const auto& nodes = tree_.nodes();
    std::vector<std::int32_t> rep(nodes.size(), -1);
    for (std::size_t i = nodes.size(); i-- > tree_.leaves();) {
      const TreeNode& n = nodes[i];
      if (n.parent >= 0 && rep[n.parent] >= 0) {
        rep[i] = rep[n.parent];
      } else if (n.disc && !blocked_[i] && n.error < tolerance) {
        rep[i] = static_cast<std::int32_t>(i);
      }
    }
    cut_.node.resize(tree_.leaves());
    parallelBlocks(tree_.leaves(), 8192, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const std::int32_t parent = nodes[v].parent;
        cut_.node[v] = parent >= 0 && rep[parent] >= 0 ? rep[parent] : static_cast<std::int32_t>(v);
      }
    });
  }

  /// Triangles that turn over block the largest of their nodes. Keeps the others.
  bool keepTriangles() {
    const std::size_t n = triangles_.size();
    std::vector<std::vector<std::array<std::int32_t, 3>>> parts((n + kBlock - 1) / kBlock);
    std::vector<std::vector<std::int32_t>> blocks(parts.size());
    parallelBlocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
      auto& part = parts[begin / kBlock];
      for (std::size_t t = begin; t < end; ++t) {
        const auto& tri = triangles_[t];
        const std::array<std::int32_t, 3> to{cut_.node[tri[0]], cut_.node[tri[1]],
                                             cut_.node[tri[2]]};
        if (to[0] == to[1] || to[1] == to[2] || to[2] == to[0]) continue;
        part.push_back(to);
        if (to == tri) continue;
        const Eigen::Vector3d was = normalOf(tri), is = normalOf(to);
        if (was.dot(is) < kMinCosine * was.norm() * is.norm()) {
          blocks[begin / kBlock].push_back(*std::max_element(to.begin(), to.end()));
        }
      }
    });
    bool any = false;
    cut_.triangles.clear();
    for (std::size_t b = 0; b < parts.size(); ++b) {
      cut_.triangles.insert(cut_.triangles.end(), parts[b].begin(), parts[b].end());
      for (const std::int32_t node : blocks[b]) any |= block(node);
    }
    return any;
  }

  /// Nodes at both ends of an edge that has not exactly one triangle on each side.
  bool blockBadEdges() {
    const EdgeTable table(cut_.triangles, static_cast<std::int64_t>(cut_.nodeOf.size()));
    bool any = false;
    table.forEachEdge(0, table.vertexCount(),
                      [&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                          const std::uint64_t* last) {
                        if (last - first == 2 && EdgeTable::ascending(first[0]) &&
                            !EdgeTable::ascending(first[1]) &&
                            opposite(first[0]) != opposite(first[1])) {
                          return;
                        }
                        any |= block(std::max(cut_.nodeOf[low], cut_.nodeOf[high]));
                      });
    return any;
  }

  /// Numbers the vertices of the cut; a node without a triangle (all round it is one other node)
  /// is blocked.
  bool number() {
    std::vector<std::int32_t> at(tree_.nodes().size(), -1);
    cut_.nodeOf.clear();
    for (auto& t : cut_.triangles) {
      for (auto& node : t) {
        if (at[node] < 0) {
          at[node] = static_cast<std::int32_t>(cut_.nodeOf.size());
          cut_.nodeOf.push_back(node);
        }
        node = at[node];
      }
    }
    cut_.vertex.resize(cut_.node.size());
    bool any = false;
    for (std::size_t v = 0; v < cut_.node.size(); ++v) {
      cut_.vertex[v] = at[cut_.node[v]];
      if (cut_.vertex[v] < 0) any |= block(cut_.node[v]);
    }
    return any;
  }

  TreeCut take() { return std::move(cut_); }

 private:
  static constexpr std::size_t kBlock = 16384;

  Eigen::Vector3d normalOf(const std::array<std::int32_t, 3>& t) const {
    const auto& nodes = tree_.nodes();
    const auto &a = nodes[t[0]].position, &b = nodes[t[1]].position, &c = nodes[t[2]].position;
    return (b - a).cross(c - a);
  }
  std::int32_t opposite(std::uint64_t record) const {
    const std::int64_t h = EdgeTable::halfEdge(record);
    return cut_.triangles[h / 3][(h % 3 + 2) % 3];
  }
  bool block(std::int32_t node) {
    if (static_cast<std::size_t>(node) < tree_.leaves() || blocked_[node]) return false;
    blocked_[node] = 1;
    return true;
  }

  const VertexTree& tree_;
  const Triangles& triangles_;
  std::vector<std::uint8_t>& blocked_;
  TreeCut cut_;
};

}  // namespace

TreeCut cutTree(const VertexTree& tree, const Triangles& triangles, double tolerance,
                std::vector<std::uint8_t>& blocked, RunContext& run) {
  Cutter cutter(tree, triangles, blocked);
  for (;;) {
    run.checkpoint(Phase::Simplify, 1, 4);
    cutter.select(tolerance);
    const bool turned = cutter.keepTriangles();
    const bool lost = cutter.number();
    if (turned || lost) continue;  // ends: every round blocks a node, and leaves cannot be blocked
    if (!cutter.blockBadEdges()) break;
  }
  return cutter.take();
}

}  // namespace swept
