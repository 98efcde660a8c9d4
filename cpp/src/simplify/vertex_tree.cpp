// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/vertex_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/half_edges.h"
#include "geometry/morton.h"

namespace swept {
namespace {

constexpr double kRankCut = 0.03;  ///< of the largest eigenvalue: a crease of some 20 degrees
/// Nodes of up to 16 cells a side: larger ones seldom pass, and the edge collapse goes on from
/// there with better shapes.
constexpr int kLevels = 4;
constexpr int kNever = kLevels + 1;

std::uint64_t cellCode(const Eigen::Vector3d& p, const Eigen::Vector3d& low) {
  const Eigen::Vector3d c = p - low;
  return mortonCode(static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]),
                    static_cast<std::uint32_t>(c[2]));
}

/// Level of the smallest octree node that holds both cells.
int commonLevel(std::uint64_t a, std::uint64_t b) {
  int level = 0;
  for (std::uint64_t x = a ^ b; x != 0; x >>= 3) ++level;
  return level;
}

/// Joins tops of the tree while one level is merged.
class Merger {
 public:
  explicit Merger(std::vector<TreeNode>& nodes, std::size_t leaves)
      : nodes_(nodes), euler_(leaves, 1), up_(leaves) {
    for (std::size_t i = 0; i < leaves; ++i) up_[i] = static_cast<std::int32_t>(i);
  }
  std::int32_t find(std::int32_t x) {
    while (up_[x] != x) x = up_[x] = up_[up_[x]];
    return x;
  }
  void addEdge(std::int32_t u, std::int32_t v) {
    std::int32_t a = find(u), b = find(v);
    if (a != b) {
      if (a > b) std::swap(a, b);
      up_[b] = a;
      euler_[a] += euler_[b];
      merged_.push_back(a);
      merged_.push_back(b);
    }
    --euler_[a];
  }
  void addTriangle(std::int32_t v) {
    const std::int32_t a = find(v);
    ++euler_[a];
  }
  /// Makes a node of every set joined since the last call.
  void finishLevel() {
    std::sort(merged_.begin(), merged_.end());
    merged_.erase(std::unique(merged_.begin(), merged_.end()), merged_.end());
    std::vector<std::int32_t> roots;
    for (const std::int32_t m : merged_) roots.push_back(find(m));
    const std::size_t base = nodes_.size();
    std::vector<std::int32_t> made;
    for (std::size_t i = 0; i < merged_.size(); ++i) {
      // The root is the smallest member, so it comes first.
      if (roots[i] == merged_[i]) made.push_back(merged_[i]);
    }
    nodes_.resize(base + made.size());
    up_.resize(nodes_.size());
    euler_.resize(nodes_.size());
    const auto idOf = [&](std::int32_t root) {
      return static_cast<std::int32_t>(
          base + (std::lower_bound(made.begin(), made.end(), root) - made.begin()));
    };
    for (std::size_t i = 0; i < merged_.size(); ++i) nodes_[merged_[i]].parent = idOf(roots[i]);
    for (const std::int32_t root : made) {
      const std::int32_t id = idOf(root);
      euler_[id] = euler_[root];
      up_[id] = id;
    }
    for (std::size_t i = 0; i < merged_.size(); ++i) up_[merged_[i]] = nodes_[merged_[i]].parent;
    for (std::size_t id = base; id < nodes_.size(); ++id) nodes_[id].disc = euler_[id] == 1;
    merged_.clear();
  }

 private:
  std::vector<TreeNode>& nodes_;
  std::vector<std::int32_t> euler_, up_, merged_;
};

}  // namespace

void VertexTree::makeLeaves(const std::vector<Eigen::Vector3d>& vertices,
                            const Triangles& triangles) {
  leaves_ = vertices.size();
  nodes_.reserve(leaves_ * 3 / 2);
  nodes_.resize(leaves_);
  for (const auto& t : triangles) {
    const auto &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
    Eigen::Vector3d n = (b - a).cross(c - a);
    const double twiceArea = n.norm();
    if (!(twiceArea > 0)) continue;
    n /= twiceArea;
    Quadric q;
    q.addPlane(n, a, twiceArea / 6);
    for (const std::int32_t v : t) nodes_[v].quadric += q;
  }
  parallelBlocks(leaves_, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      TreeNode& node = nodes_[v];
      node.mass = node.position = vertices[v];
      node.sample = static_cast<std::int32_t>(v);
      int rank = 0;
      node.quadric.minimise(vertices[v], kRankCut, rank);
      node.rank = static_cast<std::int16_t>(rank);
    }
  });
}

void VertexTree::build(const std::vector<Eigen::Vector3d>& vertices, const Triangles& triangles,
                       RunContext& run) {
  makeLeaves(vertices, triangles);
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  for (const auto& v : vertices) low = low.cwiseMin(v);
  low = low.array().floor();
  std::vector<std::uint64_t> codes(leaves_);
  for (std::size_t v = 0; v < leaves_; ++v) codes[v] = cellCode(vertices[v], low);

  std::array<std::vector<std::array<std::int32_t, 2>>, kNever + 1> edges;
  std::array<std::vector<std::int32_t>, kNever + 1> inner;  // a vertex of each triangle
  for (const auto& t : triangles) {
    int levels[3];
    for (int c = 0; c < 3; ++c) {
      const std::int32_t u = t[c], v = t[(c + 1) % 3];
      levels[c] = std::min(commonLevel(codes[u], codes[v]), kNever);
      // A closed, oriented surface runs along each edge once in each direction.
      if (u < v) edges[levels[c]].push_back({u, v});
    }
    inner[std::max({levels[0], levels[1], levels[2]})].push_back(t[0]);
  }
  Merger merger(nodes_, leaves_);
  for (int level = 0; level <= kLevels; ++level) {
    run.checkpoint(Phase::Simplify, level, 4 * kLevels);
    for (const auto& [u, v] : edges[level]) merger.addEdge(u, v);
    for (const std::int32_t v : inner[level]) merger.addTriangle(v);
    const std::size_t base = nodes_.size();
    merger.finishLevel();
    solve(base, nodes_.size(), level);
  }
}

void VertexTree::solve(std::size_t begin, std::size_t end, int level) {
  if (begin == end) return;
  std::vector<std::int32_t> count(end - begin, 0);
  for (std::size_t i = begin; i < end; ++i) nodes_[i].mass.setZero();
  // Children lie before their parents; those of this level were made since the level below began.
  std::vector<std::int32_t> children;
  for (std::size_t i = 0; i < begin; ++i) {
    if (nodes_[i].parent >= static_cast<std::int32_t>(begin)) {
      children.push_back(static_cast<std::int32_t>(i));
    }
  }
  for (const std::int32_t i : children) {
    const TreeNode& child = nodes_[i];
    TreeNode& node = nodes_[child.parent];
    node.quadric += child.quadric;
    std::int32_t& n = count[child.parent - begin];
    if (child.rank > node.rank) {
      node.rank = child.rank;
      node.mass.setZero();
      n = 0;
    }
    if (child.rank == node.rank) {
      node.mass += child.mass;
      ++n;
    }
  }
  const double reach = 1.5 * std::ldexp(1.0, level);
  parallelBlocks(end - begin, 1024, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      TreeNode& node = nodes_[begin + i];
      node.mass /= count[i];
      int rank = 0;
      node.position = node.quadric.minimise(node.mass, kRankCut, rank);
      if ((node.position - node.mass).cwiseAbs().maxCoeff() > reach) node.position = node.mass;
      node.rank = static_cast<std::int16_t>(rank);
      node.error = std::sqrt(node.quadric.error(node.position) / node.quadric.weight);
    }
  });
  std::vector<double> nearest(end - begin, 1e300);
  for (const std::int32_t i : children) {
    TreeNode& node = nodes_[nodes_[i].parent];
    const double d = (nodes_[i].position - node.position).squaredNorm();
    double& best = nearest[nodes_[i].parent - begin];
    if (d < best) {
      best = d;
      node.sample = nodes_[i].sample;
    }
  }
}

}  // namespace swept
