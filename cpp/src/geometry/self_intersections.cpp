// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/self_intersections.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/box_tree.h"
#include "geometry/certainly_apart.h"
#include "geometry/exact_predicates.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

constexpr std::size_t kMaxPairsOfPart = 1 << 20;
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

struct Found {
  std::int64_t count = 0;
  Pairs pairs;
  void add(std::int32_t a, std::int32_t b) {
    ++count;
    if (pairs.size() < kMaxPairsOfPart) pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
};

/// Searches pairs of triangles without common corner.
class PairSearch {
 public:
  PairSearch(const TriMesh& mesh, const BoxTree& tree, RunContext& run)
      : mesh_(mesh), tree_(tree), run_(run) {}

  struct Task {
    std::size_t first, second;
  };
  /// Pairs of nodes of one level that cover all pairs of leaves whose boxes can meet.
  std::vector<Task> tasks(std::size_t level) const {
    std::vector<Task> list{{0, 0}};
    for (std::size_t at = tree_.levels.size() - 1; at > level; --at) {
      std::vector<Task> next;
      for (const Task& task : list) {
        forEachChildPair(at, task.first, task.second, [&](std::size_t a, std::size_t b) {
          next.push_back({a, b});
        });
      }
      list = std::move(next);
    }
    return list;
  }

  void search(std::size_t level, std::size_t a, std::size_t b, Found& found) const {
    if (level == 0) {
      meetLeaves(a, b, found);
      return;
    }
    forEachChildPair(level, a, b,
                     [&](std::size_t c, std::size_t d) { search(level - 1, c, d, found); });
  }

 private:
  template <class Visit>
  void forEachChildPair(std::size_t level, std::size_t a, std::size_t b, Visit&& visit) const {
    const auto& boxes = tree_.levels[level - 1];
    const std::size_t endA = std::min(boxes.size(), 4 * a + 4);
    const std::size_t endB = std::min(boxes.size(), 4 * b + 4);
    const FloatBox& boxB = tree_.levels[level][b];
    for (std::size_t c = 4 * a; c < endA; ++c) {
      if (a != b && !boxes[c].meets(boxB)) continue;
      for (std::size_t d = a == b ? c : 4 * b; d < endB; ++d) {
        if (c == d || boxes[c].meets(boxes[d])) visit(c, d);
      }
    }
  }

  void meetLeaves(std::size_t a, std::size_t b, Found& found) const {
    const TriangleLeaf& p = tree_.leaves[a];
    const TriangleLeaf& q = tree_.leaves[b];
    const FloatBox& boxQ = tree_.levels[0][b];
    SeenTriangle first;
    for (int i = 0; i < kLeafSize; ++i) {
      if (p.triangle[i] < 0) break;
      if (a != b && (p.low[0][i] > boxQ.high[0] || p.high[0][i] < boxQ.low[0] ||
                     p.low[1][i] > boxQ.high[1] || p.high[1][i] < boxQ.low[1] ||
                     p.low[2][i] > boxQ.high[2] || p.high[2][i] < boxQ.low[2])) {
        continue;
      }
      alignas(32) std::int32_t hit[kLeafSize];
      for (int j = 0; j < kLeafSize; ++j) {
        hit[j] = (p.low[0][i] <= q.high[0][j]) & (p.high[0][i] >= q.low[0][j]) &
                 (p.low[1][i] <= q.high[1][j]) & (p.high[1][i] >= q.low[1][j]) &
                 (p.low[2][i] <= q.high[2][j]) & (p.high[2][i] >= q.low[2][j]);
      }
      for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < kLeafSize; ++j) {
          hit[j] &= (p.vertex[k][i] != q.vertex[0][j]) & (p.vertex[k][i] != q.vertex[1][j]) &
                    (p.vertex[k][i] != q.vertex[2][j]);
        }
      }
      bool prepared = false;
      for (int j = a == b ? i + 1 : 0; j < kLeafSize; ++j) {
        if (hit[j] == 0) continue;
        if (!prepared) first.set(mesh_, p.triangle[i]);
        prepared = true;
        meetTriangles(first, p.triangle[i], q.triangle[j], found);
      }
    }
  }

  void meetTriangles(const SeenTriangle& first, std::int32_t a, std::int32_t b,
                     Found& found) const {
    const auto& tri = mesh_.triangles[b];
    const std::array<Eigen::Vector3d, 3> corners{mesh_.vertices[tri[0]], mesh_.vertices[tri[1]],
                                                 mesh_.vertices[tri[2]]};
    if (first.certainlyApart(corners)) return;
    SeenTriangle second;
    second.set(mesh_, b);
    if (second.certainlyApart(first.corner)) return;
    if (hasNoArea(mesh_, a) || hasNoArea(mesh_, b)) return;
    if ((found.count & 1023) == 1023) run_.checkpoint(Phase::Check);
    if (trianglesMeet({&first.corner[0], &first.corner[1], &first.corner[2]},
                      {&corners[0], &corners[1], &corners[2]})) {
      found.add(a, b);
    }
  }

  const TriMesh& mesh_;
  const BoxTree& tree_;
  RunContext& run_;
};

/// Triangles round each entangled vertex, all pairs.
Found searchFans(const TriMesh& mesh, const std::vector<std::uint8_t>& entangled, RunContext& run) {
  std::vector<std::pair<std::int32_t, std::int32_t>> members;  // vertex, triangle
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& tri = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      if (!entangled.empty() && entangled[tri[k]] == 0) continue;
      members.emplace_back(tri[k], static_cast<std::int32_t>(t));
    }
  }
  std::sort(members.begin(), members.end());
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i == 0 || members[i].first != members[i - 1].first) starts.push_back(i);
  }
  starts.push_back(members.size());
  constexpr std::size_t kBlock = 256;
  const std::size_t groups = starts.size() - 1;
  std::vector<Found> parts((groups + kBlock - 1) / kBlock);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    run.checkpoint(Phase::Check);
    for (std::size_t g = part * kBlock; g < std::min(groups, (part + 1) * kBlock); ++g) {
      for (std::size_t i = starts[g]; i < starts[g + 1]; ++i) {
        const std::int32_t a = members[i].second;
        if (i + 1 == starts[g + 1] || hasNoArea(mesh, a)) continue;
        if ((i & 255) == 255) run.checkpoint(Phase::Check);
        for (std::size_t j = i + 1; j < starts[g + 1]; ++j) {
          const std::int32_t b = members[j].second;
          if (!hasNoArea(mesh, b) && trianglesIntersect(mesh, a, b)) parts[part].add(a, b);
        }
      }
    }
  });
  // A pair with two common corners was met at both of them.
  Found all;
  for (const Found& part : parts) {
    all.pairs.insert(all.pairs.end(), part.pairs.begin(), part.pairs.end());
  }
  std::sort(all.pairs.begin(), all.pairs.end());
  all.pairs.erase(std::unique(all.pairs.begin(), all.pairs.end()), all.pairs.end());
  all.count = static_cast<std::int64_t>(all.pairs.size());
  return all;
}

}  // namespace

SelfIntersections findSelfIntersections(const TriMesh& mesh,
                                        const std::vector<std::uint8_t>& entangled,
                                        RunContext& run) {
  SelfIntersections result;
  if (mesh.triangles.empty()) return result;
  Found fans = searchFans(mesh, entangled, run);
  result.count = fans.count;
  result.pairs = std::move(fans.pairs);

  const BoxTree tree = buildBoxTree(mesh);
  run.checkpoint(Phase::Check);
  const PairSearch search(mesh, tree, run);
  const std::size_t level = std::min<std::size_t>(4, tree.levels.size() - 1);
  const std::vector<PairSearch::Task> tasks = search.tasks(level);
  std::vector<Found> parts(tasks.size());
  tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
    run.checkpoint(Phase::Check);
    search.search(level, tasks[i].first, tasks[i].second, parts[i]);
  });
  for (const Found& part : parts) {
    result.count += part.count;
    result.pairs.insert(result.pairs.end(), part.pairs.begin(), part.pairs.end());
  }
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

}  // namespace swept
