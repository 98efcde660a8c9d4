// Adjacency, compared with a map of edges, on meshes with and without faults.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/half_edges.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "geometry/body_topology.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

std::map<Edge, std::vector<std::uint32_t>> edgeMap(const TriMesh& mesh) {
  std::map<Edge, std::vector<std::uint32_t>> edges;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    const auto& t = mesh.triangles[h / 3];
    const auto [low, high] = std::minmax({t[h % 3], t[(h + 1) % 3]});
    edges[{low, high}].push_back(h);
  }
  return edges;
}

bool ascends(const TriMesh& mesh, std::uint32_t h) {
  const auto& t = mesh.triangles[h / 3];
  return t[h % 3] < t[(h + 1) % 3];
}

/// Returns random triangles over few vertices. Edges have one, two or many triangles, in any
/// orientation.
TriMesh randomTriangles(int vertices, int triangles, unsigned seed) {
  std::mt19937 random(seed);
  TriMesh mesh;
  std::normal_distribution<double> place;
  for (int v = 0; v < vertices; ++v) {
    mesh.vertices.emplace_back(place(random), place(random), place(random));
  }
  std::uniform_int_distribution<std::int32_t> pick(0, vertices - 1);
  while (static_cast<int>(mesh.triangles.size()) < triangles) {
    const std::int32_t a = pick(random), b = pick(random), c = pick(random);
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

std::vector<TriMesh> allKinds() {
  std::vector<TriMesh> meshes{TriMesh{}, makeBox({0, 0, 0}, {1, 2, 3}), makeTorus(5, 1, 24, 12),
                              makeBall({0, 0, 0}, 1, 5), soup(makeBall({1, 0, 0}, 1, 2))};
  for (unsigned seed = 0; seed < 40; ++seed) {
    meshes.push_back(randomTriangles(5 + static_cast<int>(seed), 60, seed));
  }
  return meshes;
}

TEST(HalfEdges, TableListsEveryEdgeOnceInOrder) {
  for (const TriMesh& mesh : allKinds()) {
    auto expected = edgeMap(mesh);
    Edge last{-1, -1};
    EdgeTable(mesh).forEachEdge([&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                                    const std::uint64_t* end) {
      EXPECT_LT(last, Edge(low, high));
      last = {low, high};
      std::vector<std::uint32_t> found;
      for (const std::uint64_t* r = first; r != end; ++r) {
        found.push_back(static_cast<std::uint32_t>(EdgeTable::halfEdge(*r)));
        EXPECT_EQ(EdgeTable::high(*r), high);
        EXPECT_EQ(EdgeTable::ascending(*r), ascends(mesh, found.back()));
      }
      EXPECT_TRUE(std::is_partitioned(first, end, EdgeTable::ascending));
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected[last]);
      expected.erase(last);
    });
    EXPECT_TRUE(expected.empty());
  }
}

TEST(HalfEdges, AdjacencyAsTheMapHasIt) {
  for (const TriMesh& mesh : allKinds()) {
    const Adjacency found = findAdjacency(mesh);
    ASSERT_EQ(found.across.size(), 3 * mesh.triangles.size());
    EdgeFaults faults;
    for (const auto& [edge, halves] : edgeMap(mesh)) {
      const auto n = static_cast<std::int64_t>(halves.size());
      const std::int64_t up = std::count_if(halves.begin(), halves.end(),
                                            [&](std::uint32_t h) { return ascends(mesh, h); });
      faults.open += n == 1;
      faults.nonManifold += n > 2;
      faults.odd += n % 2;
      faults.misoriented += n > 1 && 2 * up != n;
      for (const std::uint32_t h : halves) {
        EXPECT_EQ(found.across[h], n == 2 ? halves[0] + halves[1] - h : kNoNeighbour);
      }
    }
    EXPECT_EQ(found.faults.open, faults.open);
    EXPECT_EQ(found.faults.nonManifold, faults.nonManifold);
    EXPECT_EQ(found.faults.odd, faults.odd);
    EXPECT_EQ(found.faults.misoriented, faults.misoriented);
  }
}

TEST(HalfEdges, SameRecordsForAnyNumberOfThreads) {
  const TriMesh mesh = makeBall({0, 0, 0}, 1, 6);
  std::vector<std::uint64_t> one;
  for (const int threads : {1, 2, 3, 8}) {
    tbb::task_arena(threads).execute([&] {
      const EdgeTable table(mesh);
      const std::vector<std::uint64_t> records(table.records().data(),
                                               table.records().data() + table.records().size());
      if (threads == 1) one = records;
      EXPECT_EQ(records, one) << threads;
    });
  }
}

TEST(HalfEdges, ByVertexEveryOneOnce) {
  for (const TriMesh& mesh : allKinds()) {
    std::vector<std::vector<std::uint32_t>> expected(mesh.vertices.size());
    for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
      expected[mesh.triangles[h / 3][h % 3]].push_back(h);
    }
    ListsByKey lists = halfEdgesByVertex(mesh);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      const auto found = lists.of(v);
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected[v].begin(), expected[v].end()));
    }
  }
}

TEST(HalfEdges, NextAndPreviousGoRoundATriangle) {
  for (std::int32_t h = 0; h < 12; ++h) {
    EXPECT_EQ(nextHalfEdge(h), h / 3 * 3 + (h + 1) % 3);
    EXPECT_EQ(previousHalfEdge(nextHalfEdge(h)), h);
  }
}

TEST(BodyTopology, EdgesAsTheMapHasThem) {
  for (const TriMesh& mesh : allKinds()) {
    const BodyTopology topology = buildTopology(mesh);
    const auto expected = edgeMap(mesh);
    ASSERT_EQ(topology.edges.size(), expected.size());
    auto edge = topology.edges.begin();
    for (const auto& [ends, halves] : expected) {
      EXPECT_EQ(Edge(edge->a, edge->b), ends);
      EXPECT_EQ(edge->left, static_cast<std::int32_t>(halves.front() / 3));
      const bool two = halves.size() == 2;
      EXPECT_EQ(edge->right, two ? static_cast<std::int32_t>(halves.back() / 3) : -1);
      EXPECT_EQ(edge->opposed, two && ascends(mesh, halves[0]) == ascends(mesh, halves[1]));
      ++edge;
    }
  }
}

}  // namespace
}  // namespace swept::test
