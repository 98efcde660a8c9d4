// Thinning of bodies that are swept: the bound on moves against brute force, and the distance of
// the thinned body in both directions.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/thin.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "simplify/mapped_move.h"
#include "support/mesh_distance.h"
#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;
using Ring = std::vector<Vector3d>;

/// Returns the triangles between a vertex and the ring, without those that would have no area.
TriMesh fan(const Vector3d& centre, const Ring& ring) {
  TriMesh mesh;
  mesh.vertices = ring;
  mesh.vertices.push_back(centre);
  const auto last = static_cast<std::int32_t>(ring.size());
  for (std::int32_t k = 0; k < last; ++k) {
    const std::int32_t next = (k + 1) % last;
    if (ring[k] == centre || ring[next] == centre) continue;
    mesh.triangles.push_back({last, k, next});
  }
  return mesh;
}

/// Returns the largest distance of points of one mesh from the other, at `count` points a triangle.
double farthest(const TriMesh& from, const TriMesh& to, Random& random, int count) {
  const MeshDistance distance(to);
  double most = 0;
  for (const auto& t : from.triangles) {
    for (int n = 0; n < count; ++n) {
      double a = random.number(0, 1), b = random.number(0, 1);
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const Vector3d &p = from.vertices[t[0]], &q = from.vertices[t[1]], &r = from.vertices[t[2]];
      most = std::max(most, distance.distance(p + a * (q - p) + b * (r - p)));
    }
  }
  return most;
}

TEST(MappedMove, BoundsTheDistanceInBothDirections) {
  Random random(5);
  int bounded = 0;
  for (int n = 0; n < 400; ++n) {
    Ring ring;
    const int count = 3 + n % 7;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * M_PI * (k + random.number(0.1, 0.9)) / count,
                   radius = random.number(0.3, 2);
      ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                        random.number(-0.5, 0.5));
    }
    const double move = mappedMove(ring);
    if (!std::isfinite(move)) continue;
    ++bounded;
    const TriMesh before = fan(Vector3d::Zero(), ring), after = fan(ring[0], ring);
    EXPECT_LE(farthest(before, after, random, 30), move + 1e-12) << n;
    EXPECT_LE(farthest(after, before, random, 30), move + 1e-12) << n;
  }
  EXPECT_GT(bounded, 100);
}

TEST(MappedMove, IsTheHeightOfAFlatPyramid) {
  const double height = 0.25;
  const Ring ring{{1, 0, -height}, {0, 1, -height}, {-1, 0, -height}, {0, -1, -height}};
  EXPECT_NEAR(mappedMove(ring), height, 1e-12);
}

TEST(MappedMove, InPlaneNothingMoves) {
  EXPECT_NEAR(mappedMove({{1, 0, 0}, {0, 1, 0}, {-1, 0.2, 0}, {0, -1, 0}}), 0, 1e-12);
}

TEST(MappedMove, HasNoBoundIfTrianglesOverlap) {
  // The vertex lies in a notch, where the first neighbour does not see all the others.
  EXPECT_TRUE(
      std::isinf(mappedMove({{2, 1, 0}, {0.1, 0.2, 0}, {-2, 1, 0}, {-1, -1, 0}, {1, -1, 0}})));
  // The ring goes round twice.
  Ring twice;
  for (int k = 0; k < 10; ++k)
    twice.emplace_back(std::cos(4 * M_PI * k / 10), std::sin(4 * M_PI * k / 10), 0.01 * k);
  EXPECT_TRUE(std::isinf(mappedMove(twice)));
}

TEST(ThinForSweep, EachBodyLiesWithinTheLimitOfTheOther) {
  RunContext run;
  TriMesh rod = makeCylinder(10, -30, 30, 400);
  append(rod, makeTorus(60, 8, 120, 60));
  Random random(7);
  for (const TriMesh& body : {makeBall({1, 2, 3}, 20, 5), makeTorus(30, 7, 200, 80), rod}) {
    for (const double limit : {0.02, 0.3}) {
      const TriMesh thin = thinOut(body, limit, ThinFor::Sweep, Phase::Motion, run).mesh;
      EXPECT_LT(thin.triangles.size(), body.triangles.size() / (limit > 0.1 ? 3 : 1));
      EXPECT_LE(farthest(body, thin, random, 2), limit);
      EXPECT_LE(farthest(thin, body, random, 20), limit);
      // The deviation comes near the limit, so the comparison above can fail.
      EXPECT_GT(farthest(body, thin, random, 2), 0.2 * limit);
    }
  }
}

// Both ends of the rod are fans of 4,000 very narrow triangles, as its side is.
TEST(ThinForSweep, RodsOfNarrowTrianglesLoseNearlyAllOfThem) {
  RunContext run;
  Random random(3);
  const TriMesh rod = makeCylinder(10, -30, 30, 4000);
  const TriMesh thin = thinOut(rod, 0.02, ThinFor::Sweep, Phase::Motion, run).mesh;
  EXPECT_LT(thin.triangles.size(), rod.triangles.size() / 10);
  EXPECT_LE(farthest(rod, thin, random, 1), 0.02);
  EXPECT_LE(farthest(thin, rod, random, 20), 0.02);
}

TEST(ThinForSweep, SharpEdgesStay) {
  RunContext run;
  TriMesh box = makeBox({0, 0, 0}, {30, 20, 10});
  const TriMesh thin = thinOut(box, 0.1, ThinFor::Sweep, Phase::Motion, run).mesh;
  EXPECT_EQ(thin.vertices.size(), box.vertices.size());
}

}  // namespace
}  // namespace swept::test
