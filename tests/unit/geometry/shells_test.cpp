// Shells, compared with a flood fill over the triangles; nesting of shells, with balls at known
// places.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/shells.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/shapes.h"

namespace swept::test {
namespace {

/// Numbers the shells by flood fill: from each triangle without a number over all triangles
/// joined to it.
template <class Joined>
std::vector<std::int32_t> flood(const TriMesh& mesh, const Joined& joined) {
  std::vector<std::int32_t> number(mesh.triangles.size(), -1);
  std::int32_t count = 0;
  for (std::size_t seed = 0; seed < number.size(); ++seed) {
    if (number[seed] >= 0) continue;
    std::vector<std::size_t> open{seed};
    number[seed] = count;
    while (!open.empty()) {
      const std::size_t t = open.back();
      open.pop_back();
      for (std::size_t other = 0; other < number.size(); ++other) {
        if (number[other] >= 0 || !joined(t, other)) continue;
        number[other] = count;
        open.push_back(other);
      }
    }
    ++count;
  }
  return number;
}

/// Pieces of a few triangles each, some of them only touching at a vertex, in shuffled order.
TriMesh scattered(unsigned seed) {
  std::mt19937 random(seed);
  TriMesh mesh;
  std::uniform_real_distribution<double> place(-10, 10);
  for (int n = 0; n < 12; ++n) {
    const Eigen::Vector3d at(place(random), place(random), place(random));
    append(mesh, n % 3 == 0 ? makeBall(at, 1, 1) : makeBox(at, at + Eigen::Vector3d(1, 1, 1)));
  }
  std::uniform_int_distribution<std::int32_t> pick(
      0, static_cast<std::int32_t>(mesh.vertices.size()) - 1);
  for (int n = 0; n < 3; ++n) {
    const std::int32_t from = pick(random), to = pick(random);
    for (auto& t : mesh.triangles) std::replace(t.begin(), t.end(), from, to);
  }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  return mesh;
}

TEST(Shells, ByEdgesAsAFloodFindsThem) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const TriMesh mesh = scattered(seed);
    const Adjacency adjacency = findAdjacency(mesh);
    const Shells shells = shellsByEdges(adjacency.across);
    EXPECT_EQ(shells.ofTriangle, flood(mesh, [&](std::size_t t, std::size_t other) {
                for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
                  const std::uint32_t g = adjacency.across[h];
                  if (g != kNoNeighbour && g / 3 == other) return true;
                }
                return false;
              }));
    EXPECT_EQ(shells.count,
              1 + *std::max_element(shells.ofTriangle.begin(), shells.ofTriangle.end()));
  }
}

TEST(Shells, ByVerticesAsAFloodFindsThem) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const TriMesh mesh = scattered(seed);
    const Shells shells = shellsByVertices(mesh);
    EXPECT_EQ(shells.ofTriangle, flood(mesh, [&](std::size_t t, std::size_t other) {
                const auto &a = mesh.triangles[t], &b = mesh.triangles[other];
                return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
              }));
    const std::vector<std::int32_t> smallest = smallestJoinedVertices(mesh);
    std::vector<std::int32_t> expected(shells.count, 1 << 30);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::int32_t v : mesh.triangles[t]) {
        std::int32_t& least = expected[shells.ofTriangle[t]];
        least = std::min(least, v);
      }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::int32_t v : mesh.triangles[t]) {
        EXPECT_EQ(smallest[v], expected[shells.ofTriangle[t]]);
      }
    }
  }
}

TEST(Shells, ExtentsOfEachPiece) {
  const std::vector<TriMesh> pieces{makeBall({1e6, 0, 0}, 2, 4), inverted(makeTorus(5, 1, 60, 30)),
                                    makeBox({-3, -4, -5}, {1, 2, 3})};
  TriMesh mesh;
  for (const TriMesh& piece : pieces) append(mesh, piece);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), std::mt19937(7));
  const Shells shells = shellsByEdges(findAdjacency(mesh).across);
  const std::vector<ShellExtent> extents = measureShells(mesh, shells);
  ASSERT_EQ(extents.size(), pieces.size());
  for (const TriMesh& piece : pieces) {
    Eigen::AlignedBox3d box;
    for (const auto& v : piece.vertices) box.extend(v);
    const auto found = std::find_if(extents.begin(), extents.end(), [&](const ShellExtent& e) {
      return e.box.min() == box.min() && e.box.max() == box.max();
    });
    ASSERT_NE(found, extents.end());
    const double volume = signedVolume(
        transformed(piece, Eigen::Isometry3d(Eigen::Translation3d(-piece.vertices[0]))));
    EXPECT_NEAR(found->volume, volume, 1e-9 * std::abs(volume));
    const auto& of = shells.ofTriangle;
    const auto number = static_cast<std::int32_t>(found - extents.begin());
    EXPECT_EQ(found->first, std::find(of.begin(), of.end(), number) - of.begin());
    EXPECT_EQ(std::ssize(of) - 1 - found->last,
              std::find(of.rbegin(), of.rend(), number) - of.rbegin());
  }
}

TEST(Shells, SameExtentsForAnyNumberOfThreads) {
  TriMesh mesh = makeBall({0, 0, 0}, 3, 6);
  append(mesh, makeBall({0.1, 0, 0}, 1, 5));
  std::vector<double> one;
  for (const int threads : {1, 2, 3, 8}) {
    tbb::task_arena(threads).execute([&] {
      const Shells shells = shellsByEdges(findAdjacency(mesh).across);
      std::vector<double> volumes;
      for (const ShellExtent& e : measureShells(mesh, shells)) volumes.push_back(e.volume);
      if (threads == 1) one = volumes;
      EXPECT_EQ(volumes, one) << threads;
    });
  }
}

TEST(Shells, NestingOfBallsAsTheirPlacesSay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-8, 8), size(0.2, 6);
  struct Ball {
    Eigen::Vector3d centre;
    double radius;
  };
  std::vector<Ball> balls;
  TriMesh mesh;
  while (balls.size() < 40) {
    const Ball ball{{place(random), place(random), place(random)}, size(random)};
    // Clear of all others: completely inside, completely outside, or around them.
    const bool clear = std::all_of(balls.begin(), balls.end(), [&](const Ball& b) {
      const double d = (b.centre - ball.centre).norm();
      return d > 1.1 * (b.radius + ball.radius) || d + ball.radius < 0.85 * b.radius ||
             d + b.radius < 0.85 * ball.radius;
    });
    if (!clear) continue;
    balls.push_back(ball);
    const TriMesh made = makeBall(ball.centre, ball.radius, 3);
    append(mesh, balls.size() % 2 == 0 ? inverted(made) : made);
  }
  const Shells shells = shellsByEdges(findAdjacency(mesh).across);
  ASSERT_EQ(shells.count, 40);
  const RayColumns columns(mesh);
  const ShellNesting nesting(mesh, shells, columns);
  std::size_t nested = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 97) {
    const Ball& inner = balls[shells.ofTriangle[t]];
    std::vector<std::int32_t> expected;
    for (std::int32_t s = 0; s < shells.count; ++s) {
      const bool holds = (balls[s].centre - inner.centre).norm() + inner.radius < balls[s].radius;
      if (holds && s != shells.ofTriangle[t]) expected.push_back(s);
    }
    nested += expected.size();
    EXPECT_EQ(nesting.shellsAround(static_cast<std::int32_t>(t)), expected) << t;
  }
  EXPECT_GT(nested, 100U);
}

}  // namespace
}  // namespace swept::test
