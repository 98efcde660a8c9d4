// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/self_intersections.h"

#include <algorithm>
#include <optional>

#include "base/sort_unique.h"
#include "geometry/box_tree.h"
#include "geometry/certainly_apart.h"
#include "geometry/exact_predicates.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

constexpr std::size_t kMaxPairsOfPart = 1 << 20;
/// All pairs of triangles are tested at vertices with at most this many triangles.
constexpr std::size_t kMaxPairwiseFan = 48;
constexpr double kDirectionRounding = 1e-9;  ///< more than the rounding of a unit vector
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

struct Found {
  std::int64_t count = 0;
  Pairs pairs;
  void add(std::int32_t a, std::int32_t b) {
    ++count;
    if (pairs.size() < kMaxPairsOfPart) pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
};

/// Searches for intersecting triangles without a common corner.
class PairSearch {
 public:
  PairSearch(const TriMesh& mesh, RunContext& run)
      : mesh_(mesh), run_(run), tree_(boxTreeOf(mesh.vertices, mesh.triangles)) {
    run.checkpoint(Phase::Check);
    if (tree_.root().isItem()) return;
    vertices_ = RawArray<GroupVertices>(tree_.count(1));
    constexpr std::size_t kGroups = 1 << 11;
    parallelBlocks(vertices_.size(), kGroups, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g) {
        const std::size_t filled = std::min<std::size_t>(kWidth, tree_.size() - kWidth * g);
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
          for (int k = 0; k < 3; ++k) {
            vertices_[g].vertex[k][lane] =
                lane < filled ? mesh_.triangles[tree_.item(kWidth * g + lane)][k] : -1;
          }
        }
      }
    });
  }

  struct Task {
    std::uint32_t first, second;
  };
  std::int32_t top() const { return tree_.root().level; }
  /// Returns pairs of nodes on one level that cover all pairs of triangles whose boxes can
  /// intersect.
  std::vector<Task> tasks(std::int32_t level) const {
    std::vector<Task> list{{0, 0}};
    for (std::int32_t at = top(); at > level; --at) {
      std::vector<Task> next;
      for (const Task& task : list) {
        forEachChildPair(at, task.first, task.second, [&](std::uint32_t a, std::uint32_t b) {
          next.push_back({a, b});
        });
      }
      list = std::move(next);
    }
    return list;
  }

  void search(std::int32_t level, std::uint32_t a, std::uint32_t b, Found& found) const {
    if (level == 1) {
      intersectGroups(a, b, found);
      return;
    }
    forEachChildPair(level, a, b,
                     [&](std::uint32_t c, std::uint32_t d) { search(level - 1, c, d, found); });
  }

 private:
  static constexpr int kWidth = BoxTree::kWidth;
  struct alignas(16) GroupVertices {
    std::int32_t vertex[3][kWidth];
  };

  template <class Visit>
  void forEachChildPair(std::int32_t level, std::uint32_t a, std::uint32_t b,
                        const Visit& visit) const {
    const BoxTree::Group &p = tree_.childBoxes({level, a}), &q = tree_.childBoxes({level, b});
    for (int i = 0; i < kWidth; ++i) {
      const auto hit = q.intersecting(p.box(i));  // an empty lane intersects nothing
      for (int j = a == b ? i : 0; j < kWidth; ++j) {
        if (hit[j] != 0) visit(kWidth * a + i, kWidth * b + j);
      }
    }
  }

  void intersectGroups(std::uint32_t a, std::uint32_t b, Found& found) const {
    const BoxTree::Group &p = tree_.childBoxes({1, a}), &q = tree_.childBoxes({1, b});
    const GroupVertices &u = vertices_[a], &v = vertices_[b];
    std::optional<TriangleSeparator> first;
    for (int i = 0; i < kWidth; ++i) {
      auto hit = q.intersecting(p.box(i));
      for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < kWidth; ++j) {
          hit[j] &= (u.vertex[k][i] != v.vertex[0][j]) & (u.vertex[k][i] != v.vertex[1][j]) &
                    (u.vertex[k][i] != v.vertex[2][j]);
        }
      }
      first.reset();
      for (int j = a == b ? i + 1 : 0; j < kWidth; ++j) {
        if (hit[j] == 0) continue;
        const std::int32_t t = tree_.item(kWidth * a + i);
        if (!first) first.emplace(mesh_, t);
        intersectTriangles(*first, t, tree_.item(kWidth * b + j), found);
      }
    }
  }

  void intersectTriangles(const TriangleSeparator& first, std::int32_t a, std::int32_t b,
                          Found& found) const {
    const TriangleSeparator second(mesh_, b);
    if (first.separatedByEdge(second) || first.separatedByPlane(second) ||
        second.separatedByEdge(first) || second.separatedByPlane(first)) {
      return;
    }
    if (hasNoArea(mesh_, a) || hasNoArea(mesh_, b)) return;
    if ((found.count & 1023) == 1023) run_.checkpoint(Phase::Check);
    const auto &p = first.corners(), &q = second.corners();
    if (trianglesMeet({&p[0], &p[1], &p[2]}, {&q[0], &q[1], &q[2]})) found.add(a, b);
  }

  const TriMesh& mesh_;
  RunContext& run_;
  BoxTree tree_;
  RawArray<GroupVertices> vertices_;  ///< by node of level 1
};

/// Returns a box around the directions from a vertex to the points of a triangle at this vertex.
BoxTree::Bounds directionsFrom(std::int32_t vertex, const TriMesh& mesh, std::int32_t triangle) {
  std::array<Eigen::Vector3d, 2> ends;
  int count = 0;
  for (const std::int32_t v : mesh.triangles[triangle]) {
    if (v != vertex) ends[count++] = (mesh.vertices[v] - mesh.vertices[vertex]).normalized();
  }
  BoxTree::Bounds box;
  for (const Eigen::Vector3d& end : ends) box.extend(end);
  // The directions form an arc of a circle. It rises above its chord.
  const double rise = 1 - (ends[0] + ends[1]).norm() / 2 + kDirectionRounding;
  box.low.array() -= rise;
  box.high.array() += rise;
  return box;
}

/// Tests all pairs of the given triangles at a vertex. Pairs with separate directions have only the
/// vertex in common, so large fans are searched with a tree of boxes of directions.
void searchFan(const TriMesh& mesh, std::int32_t vertex, const std::vector<std::int32_t>& fan,
               RunContext& run, Found& found) {
  const auto test = [&](std::size_t i, std::size_t j) {
    if (trianglesIntersect(mesh, fan[i], fan[j])) found.add(fan[i], fan[j]);
  };
  if (fan.size() <= kMaxPairwiseFan) {
    for (std::size_t i = 0; i < fan.size(); ++i) {
      for (std::size_t j = i + 1; j < fan.size(); ++j) test(i, j);
    }
    return;
  }
  const auto boxOf = [&](std::size_t i) { return directionsFrom(vertex, mesh, fan[i]); };
  const BoxTree tree(fan.size(), boxOf);
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if ((i & 255) == 255) run.checkpoint(Phase::Check);
    const BoxTree::Bounds box = boxOf(i);
    tree.forBox(box.low, box.high, [&](std::uint32_t place) {
      const auto j = static_cast<std::size_t>(tree.item(place));
      if (i < j) test(i, j);
    });
  }
}

/// Tests all pairs of triangles at each vertex marked in `entangled`.
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
  parallelFor(parts.size(), [&](std::size_t part) {
    run.checkpoint(Phase::Check);
    std::vector<std::int32_t> fan;  // triangles at one vertex
    for (std::size_t g = part * kBlock; g < std::min(groups, (part + 1) * kBlock); ++g) {
      fan.clear();
      for (std::size_t i = starts[g]; i < starts[g + 1]; ++i) {
        if (!hasNoArea(mesh, members[i].second)) fan.push_back(members[i].second);
      }
      searchFan(mesh, members[starts[g]].first, fan, run, parts[part]);
    }
  });
  // A pair with two common corners was found at both corners.
  Found all;
  for (const Found& part : parts) {
    all.pairs.insert(all.pairs.end(), part.pairs.begin(), part.pairs.end());
  }
  sortUnique(all.pairs);
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

  const PairSearch search(mesh, run);
  if (search.top() == 0) return result;
  const std::int32_t level = std::min(5, search.top());
  const std::vector<PairSearch::Task> tasks = search.tasks(level);
  std::vector<Found> parts(tasks.size());
  parallelFor(tasks.size(), [&](std::size_t i) {
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
