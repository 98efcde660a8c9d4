// Ledges lower than a cell. Hardly any grid edge meets their riser, but the envelope must
// contain their upper edge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <vector>

#include "support/checked_compute.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;

/// Returns an L-shaped prism along y: a block with a step of the given height along its middle.
TriMesh stepped(double height) {
  const double x[] = {0, 6, 6, 3, 3, 0}, z[] = {0, 0, 2, 2, 2 + height, 2 + height};
  TriMesh mesh;
  for (const double y : {0.0, 5.0}) {
    for (int n = 0; n < 6; ++n) mesh.vertices.emplace_back(x[n], y, z[n]);
  }
  for (int n = 0; n < 6; ++n) {
    const int m = (n + 1) % 6;
    mesh.triangles.push_back({n, m, m + 6});
    mesh.triangles.push_back({n, m + 6, n + 6});
  }
  // Corner 3 is the re-entrant one: both ends are fans about it.
  for (const auto& [a, b] : {std::pair(4, 5), std::pair(5, 0), std::pair(0, 1), std::pair(1, 2)}) {
    mesh.triangles.push_back({3, b, a});
    mesh.triangles.push_back({9, a + 6, b + 6});
  }
  return signedVolume(mesh) > 0 ? mesh : inverted(mesh);
}

constexpr double kCell = 0.25;

/// Computes the envelope of a block that stands still, turned about `axis`. Its ledge is `height`
/// cells high. use(distance): distance(p) is the distance (in cells) from the envelope to a point p
/// in the block's coordinates.
template <class Use>
void withLedge(double height, const V3& axis, double degrees, const Use& use) {
  const Eigen::Isometry3d pose = placement(axis, degrees, {0.07, 0.11, 0.03});
  Options options;
  options.cellSize = kCell;
  const Trajectory still{{poseOf(0, Eigen::Isometry3d::Identity())}, Interpolation::None};
  const TriMesh body = transformed(stepped(height * kCell), pose);
  const Result result = checkedCompute(body, still, options);
  const MeshDistance envelope(result.mesh);
  use([&](const V3& x) { return envelope.distance(pose * x) / kCell; });
}

TEST(HiddenSide, UpperEdgeOfALedgeLowerThanACell) {
  double most = 0, sum = 0;
  int count = 0;
  for (const double height : {0.3, 0.5, 0.8}) {
    for (const double degrees : {2.0, 4.0, 7.0}) {
      withLedge(height, {0.3, 1, 0.2}, degrees, [&](const auto& distance) {
        for (int n = 2; n <= 98; ++n) {
          const double d = distance(V3(3, 0.05 * n, 2 + height * kCell));
          most = std::max(most, d);
          sum += d;
          ++count;
        }
      });
    }
  }
  std::printf("upper edge of ledges: mean %.4f, max %.4f cell\n", sum / count, most);
  EXPECT_LT(most, 0.25);
  EXPECT_LT(sum / count, 0.03);
}

/// The ledge is oblique to the lattice, so that some cells contain pieces of all three of its
/// faces: the upper one, the riser and the lower one.
TEST(HiddenSide, BothEdgesOfALedgeAcrossTheLattice) {
  std::vector<double> upper, lower;
  for (const double height : {0.4, 0.7, 1.0}) {
    for (const double degrees : {17.0, 31.0, 43.0}) {
      withLedge(height, {0.2, 0.15, 1}, degrees, [&](const auto& distance) {
        for (int n = 4; n <= 196; ++n) {
          upper.push_back(distance(V3(3, 0.025 * n, 2 + height * kCell)));
          lower.push_back(distance(V3(3, 0.025 * n, 2)));
        }
      });
    }
  }
  for (auto* edge : {&upper, &lower}) {
    std::sort(edge->begin(), edge->end());
    const double mean =
        std::accumulate(edge->begin(), edge->end(), 0.0) / static_cast<double>(edge->size());
    std::printf("%s edge: mean %.4f, 99 %% %.4f, max %.4f cell\n",
                edge == &upper ? "upper" : "lower", mean, (*edge)[edge->size() * 99 / 100],
                edge->back());
    EXPECT_LT((*edge)[edge->size() * 99 / 100], 0.25);
    EXPECT_LT(mean, 0.01);
  }
}

/// A wall is nearly as thick as a cell, so grid edges meet its rim in some cells only. The envelope
/// must contain all four edges of the rim along y.
TEST(KnownSide, RimOfAWallNearlyAsThickAsACell) {
  constexpr double kWidth = 4, kLength = 5;
  std::vector<double> edges;
  for (const double height : {0.5, 0.7, 0.9}) {
    for (const double degrees : {17.0, 31.0, 43.0}) {
      const Eigen::Isometry3d pose = placement({0.4, 1, 0.25}, degrees, {0.07, 0.11, 0.03});
      const V3 size(kWidth, kLength, height * kCell);
      Options options;
      options.cellSize = kCell;
      const Trajectory still{{poseOf(0, Eigen::Isometry3d::Identity())}, Interpolation::None};
      const Result result =
          checkedCompute(transformed(makeBox({0, 0, 0}, size), pose), still, options);
      const MeshDistance envelope(result.mesh);
      for (int n = 4; n <= 196; ++n) {
        for (const double x : {0.0, kWidth}) {
          for (const double z : {0.0, size.z()}) {
            edges.push_back(envelope.distance(pose * V3(x, kLength * n / 200, z)) / kCell);
          }
        }
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  const double mean =
      std::accumulate(edges.begin(), edges.end(), 0.0) / static_cast<double>(edges.size());
  std::printf("rim: mean %.4f, 99 %% %.4f, max %.4f cell\n", mean, edges[edges.size() * 99 / 100],
              edges.back());
  EXPECT_LT(mean, 0.02);
  EXPECT_LT(edges[edges.size() * 99 / 100], 0.25);
}

}  // namespace
}  // namespace swept::test
