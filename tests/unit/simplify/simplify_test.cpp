// Simplification: deviation, topology, creases, and recut() to another tolerance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "geometry/nearest_triangle.h"
#include "geometry/quadric.h"
#include "simplify/collapse.h"
#include "simplify/collapse_log.h"
#include "simplify/deviation.h"
#include "simplify/moving_boxes.h"
#include "simplify/thin.h"
#include "support/random_numbers.h"
#include "support/shapes.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::test {
namespace {

Result sweep(const TriMesh& body, const std::vector<Pose>& poses, int resolution,
             double tolerance) {
  Trajectory trajectory;
  trajectory.poses = poses;
  Options options;
  options.resolution = resolution;
  options.tolerance = tolerance;
  RunContext run;
  Result result = compute(body, trajectory, options, run);
  EXPECT_EQ(result.report.status, Status::Ok) << result.report.message;
  return result;
}

/// Returns the distance of a point from a mesh, by a test of all triangles, without a tree.
double distanceTo(const TriMesh& mesh, const Eigen::Vector3d& p) {
  double best = 1e300;
  for (const auto& t : mesh.triangles) {
    best = std::min(
        best, squaredDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
  }
  return std::sqrt(best);
}

/// Returns the largest distance of points of `from` (corners and points within the triangles) from
/// `to`.
double oneSided(const TriMesh& from, const TriMesh& to, int points) {
  double largest = 0;
  const std::size_t step = std::max<std::size_t>(1, from.triangles.size() / points);
  for (std::size_t n = 0; n < from.triangles.size(); n += step) {
    const auto& t = from.triangles[n];
    const auto &a = from.vertices[t[0]], &b = from.vertices[t[1]], &c = from.vertices[t[2]];
    for (const auto& [u, v] :
         {std::pair{0.0, 0.0}, {0.2, 0.3}, {0.6, 0.2}, {0.1, 0.8}, {0.5, 0.0}}) {
      largest = std::max(largest, distanceTo(to, a + u * (b - a) + v * (c - a)));
    }
  }
  return largest;
}

std::vector<std::int32_t> numbersOf(const TriMesh& mesh) {
  std::vector<std::int32_t> numbers(mesh.triangles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

const std::vector<Pose> kTurned = {poseOf(0, placement({1, 2, 3}, 25, {0, 0, 0}))};

std::vector<Pose> bend() {
  return {poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
          poseOf(1, placement({0, 1, 1}, 40, {20, 5, 3}))};
}

}  // namespace

TEST(Simplify, BoxKeepsItsTwelveTriangles) {
  const TriMesh body = makeBox({0, 0, 0}, {10, 7, 4});
  const Result result = sweep(body, kTurned, 64, 0.02);
  EXPECT_TRUE(result.report.check.passes());
  EXPECT_EQ(result.report.check.selfIntersections, 0);
  EXPECT_EQ(result.mesh.triangles.size(), 12u);
  EXPECT_EQ(result.featureEdges.size(), 12u);
  EXPECT_LE(result.report.simplificationDeviation, 0.02);
  EXPECT_NEAR(result.report.check.volume, 280, 280 * 0.002);
}

TEST(Simplify, MeasuredDeviationStaysBelowTheTolerance) {
  for (const double tolerance : {0.03, 0.3}) {
    const TriMesh body = makeCylinder(4, -6, 6, 48);
    const Result plain = sweep(body, bend(), 48, 0), result = sweep(body, bend(), 48, tolerance);
    EXPECT_TRUE(result.report.check.passes());
    EXPECT_EQ(result.report.check.selfIntersections, 0);
    EXPECT_GT(result.report.simplificationDeviation, 0.3 * tolerance);
    EXPECT_LE(result.report.simplificationDeviation, tolerance);
    EXPECT_LE(oneSided(plain.mesh, result.mesh, 1500), tolerance);
    EXPECT_LE(oneSided(result.mesh, plain.mesh, 500), tolerance);
    EXPECT_LT(result.mesh.triangles.size(), plain.mesh.triangles.size() / 4);
    EXPECT_EQ(result.contactTime.size(), result.mesh.vertices.size());
  }
}

TEST(Simplify, SecondCutEqualsADirectOne) {
  const TriMesh body = makeTorus(8, 3, 48, 24);
  Result kept = sweep(body, bend(), 40, 0.4);
  const Result direct = sweep(body, bend(), 40, 0.1), plain = sweep(body, bend(), 40, 0);
  RunContext run;
  recut(kept, 0.1, run);
  EXPECT_EQ(kept.mesh.vertices, direct.mesh.vertices);
  EXPECT_EQ(kept.mesh.triangles, direct.mesh.triangles);
  recut(kept, 0, run);
  EXPECT_EQ(kept.mesh.vertices, plain.mesh.vertices);
  EXPECT_EQ(kept.mesh.triangles, plain.mesh.triangles);
  EXPECT_EQ(kept.report.simplificationDeviation, 0);
}

TEST(Simplify, SameBytesForAnyNumberOfThreads) {
  const TriMesh body = makeTorus(8, 3, 48, 24);
  Trajectory trajectory;
  trajectory.poses = bend();
  Options options;
  options.resolution = 40;
  options.tolerance = 0.1;
  std::vector<TriMesh> meshes;
  for (const int threads : {1, 2, 5}) {
    RunContext run;
    run.threads = threads;
    meshes.push_back(compute(body, trajectory, options, run).mesh);
  }
  for (const TriMesh& mesh : meshes) {
    EXPECT_EQ(mesh.vertices, meshes[0].vertices);
    EXPECT_EQ(mesh.triangles, meshes[0].triangles);
  }
}

TEST(Simplify, RecutNeedsAKeptSurface) {
  Result result = sweep(makeBox({0, 0, 0}, {1, 1, 1}), kTurned, 16, 0);
  RunContext run;
  EXPECT_THROW(recut(result, 0.1, run), Error);
}

TEST(Thin, KeepsTheHandleAndASubsetOfTheVertices) {
  const TriMesh torus = makeTorus(6, 2, 120, 60);
  RunContext run;
  for (const ThinFor purpose : {ThinFor::Collapse, ThinFor::Surfaces}) {
    const Thinned thin = thinOut(torus, 0.05, purpose, Phase::Simplify, run);
    const MeshCheck check = checkMesh(thin.mesh, run);
    EXPECT_TRUE(check.passes());
    EXPECT_EQ(check.selfIntersections, 0);
    const auto v = static_cast<std::int64_t>(thin.mesh.vertices.size());
    const auto f = static_cast<std::int64_t>(thin.mesh.triangles.size());
    EXPECT_EQ(v - 3 * f / 2 + f, 0);  // Euler characteristic of a torus
    // Recognising surfaces needs triangles that stay small and well shaped.
    EXPECT_LT(f * (purpose == ThinFor::Collapse ? 4 : 2),
              static_cast<std::int64_t>(torus.triangles.size()));
    for (std::size_t n = 0; n < thin.source.size(); ++n)
      EXPECT_EQ(thin.mesh.vertices[n], torus.vertices[thin.source[n]]);
    // The deviation is estimated per vertex, so the largest one may exceed the limit a little.
    for (const Eigen::Vector3d& p : torus.vertices) EXPECT_LE(distanceTo(thin.mesh, p), 0.06);
  }
}

/// A flat shell whose two sides are much nearer to each other than the tolerance: either alone
/// could be moved through the other.
TEST(Simplify, SheetsNearEachOtherDoNotMeet) {
  TriMesh mesh = makeTorus(6, 2, 120, 60);
  const std::size_t count = mesh.triangles.size();
  const auto outer = static_cast<std::int32_t>(mesh.vertices.size());
  const TriMesh inner = makeTorus(6, 1.98, 97, 51);
  mesh.vertices.insert(mesh.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (auto t : inner.triangles)
    mesh.triangles.push_back({t[0] + outer, t[2] + outer, t[1] + outer});
  RunContext run;
  ASSERT_EQ(checkMesh(mesh, run).selfIntersections, 0);
  const Simplifier kept(mesh, std::vector<double>(mesh.vertices.size()), 0.3);
  const Simplified cut = kept.simplifyTo(0.2, run);
  EXPECT_EQ(checkMesh(cut.mesh, run).selfIntersections, 0);
  EXPECT_LE(cut.deviation, 0.2);
  EXPECT_LT(cut.mesh.triangles.size(), count);
}

/// At a few places of a thin shell, thinning deviates by four tolerances. The next round keeps
/// the vertices there. Otherwise everything would be repeated with half of the tolerance.
TEST(Simplify, WhatThinningLosesIsKept) {
  const std::string part = SWEPT_SHARED_DATA "/meshes/robot_leg_shell_base_72k_thin.ply";
  const std::string motion = SWEPT_SHARED_DATA "/motions/keyposes_16_arc_for_fandisk.csv";
  if (!std::filesystem::exists(part)) GTEST_SKIP() << "shared test data not found: " << part;
  const double tolerance = 196.6;  // a twentieth of a cell
  const Trajectory trajectory = readTrajectoryCsv(motion, 1000, Interpolation::Linear);
  const Result result = sweep(readMesh(part, 1000), trajectory.poses, 64, tolerance);
  EXPECT_TRUE(result.report.check.passes());
  EXPECT_LE(result.report.simplificationDeviation, tolerance);
  EXPECT_GT(result.report.simplificationDeviation, tolerance / 2);
}

/// A ball with small thorns whose sides fold over each other when vertices are removed.
TEST(Thin, MakesNoPairsWhereSidesFold) {
  TriMesh mesh = makeBall({0, 0, 0}, 5, 6);
  Random random(23);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (v % 5 == 0) mesh.vertices[v] *= 1 + 0.03 * random.number(0, 1);
  }
  RunContext run;
  ASSERT_EQ(checkMesh(mesh, run).selfIntersections, 0);
  for (const double limit : {0.02, 0.1}) {
    const Thinned thin = thinOut(mesh, limit, ThinFor::Collapse, Phase::Simplify, run);
    EXPECT_LT(thin.mesh.triangles.size(), 0.8 * static_cast<double>(mesh.triangles.size()));
    const MeshCheck check = checkMesh(thin.mesh, run);
    EXPECT_TRUE(check.passes());
    EXPECT_EQ(check.selfIntersections, 0);
  }
}

/// The envelope of a heap of thin plates has narrow folds. A vertex of a fold can be near triangles
/// that do not replace its own.
TEST(Thin, FoldsStayWithinTheLimit) {
  Random random(7);
  TriMesh plates;
  for (int n = 0; n < 60; ++n) {
    const Eigen::Vector3d half(random.number(1, 6), random.number(1, 6), random.number(0.02, 0.1));
    append(plates,
           transformed(makeBox(-half, half),
                       placement(random.point(1), random.number(0, 180), random.point(10))));
  }
  const Result result = sweep(plates, bend(), 128, 0);
  const double limit = 0.025 * result.report.cellSize;
  RunContext run;
  const Thinned thin = thinOut(result.mesh, limit, ThinFor::Collapse, Phase::Simplify, run);
  const NearestTriangle nearest(result.mesh.vertices, result.mesh.triangles,
                                NearestTriangle::Walks::Yes);
  const Deviation deviation =
      DeviationMeter(result.mesh, nearest, limit, limit).measure(thin.mesh, numbersOf(thin.mesh));
  EXPECT_LT(thin.mesh.triangles.size(), 0.6 * static_cast<double>(result.mesh.triangles.size()));
  EXPECT_LT(deviation.largest, 3 * limit);
}

TEST(Thin, TrianglesAmongKeptVerticesStay) {
  const TriMesh torus = makeTorus(6, 2, 120, 60);
  std::vector<char> kept(torus.vertices.size(), 0);
  for (std::size_t v = 0; v < kept.size(); ++v) kept[v] = torus.vertices[v][0] > 0;
  RunContext run;
  const Thinned thin = thinOut(torus, 0.05, ThinFor::Collapse, Phase::Simplify, run, kept);
  std::map<std::int32_t, std::size_t> now;  // old triangle -> new triangle
  for (std::size_t t = 0; t < thin.triangle.size(); ++t) now[thin.triangle[t]] = t;
  EXPECT_EQ(now.size(), thin.mesh.triangles.size());
  std::size_t stayed = 0;
  for (std::size_t t = 0; t < torus.triangles.size(); ++t) {
    const auto& before = torus.triangles[t];
    if (!std::all_of(before.begin(), before.end(), [&](std::int32_t v) { return kept[v]; }))
      continue;
    ++stayed;
    const auto place = now.find(static_cast<std::int32_t>(t));
    ASSERT_NE(place, now.end()) << t;
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(thin.source[thin.mesh.triangles[place->second][k]], before[k]);
  }
  EXPECT_GT(stayed, 4000u);
  EXPECT_LT(thin.mesh.triangles.size(), torus.triangles.size() * 3 / 4);
}

/// Returns a state for collapsing edges of a mesh. New points must stay near the mesh.
CollapseState startOf(const TriMesh& mesh, const NearestTriangle& nearest, double tolerance) {
  CollapseState state;
  state.mesh = mesh;
  state.tolerance = tolerance;
  state.original = &nearest;
  state.label.assign(mesh.triangles.size(), -1);
  watchLongEdges(state, std::vector<char>(mesh.triangles.size(), 0));
  return state;
}

std::size_t pointsOf(const CollapseState& state) {
  std::size_t points = 0;
  for (const auto& list : state.attached) points += list.size();
  return points;
}

TEST(CollapseLog, TakesEverythingBack) {
  const TriMesh torus = makeTorus(6, 2, 120, 60);
  const NearestTriangle nearest(torus.vertices, torus.triangles, NearestTriangle::Walks::Yes);
  CollapseState state = startOf(torus, nearest, 0.1);
  const std::size_t points = pointsOf(state);
  CollapseLog log;
  RunContext run;
  collapseEdges(state, false, run, &log);
  ASSERT_LT(takeMesh(state).triangles.size(), torus.triangles.size() / 5);
  std::vector<std::int32_t> all(torus.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<std::int32_t> changed = log.takeBack(state, all, 1 << 20);
  EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));
  EXPECT_EQ(state.mesh.vertices, torus.vertices);
  EXPECT_EQ(state.mesh.triangles, torus.triangles);
  EXPECT_EQ(std::count(state.dead.begin(), state.dead.end(), 1), 0);
  EXPECT_EQ(std::count(state.gone.begin(), state.gone.end(), 1), 0);
  EXPECT_GE(pointsOf(state), points);
  for (std::size_t v = 0; v < torus.vertices.size(); ++v) {
    std::vector<std::int32_t> about = state.around[v];
    std::sort(about.begin(), about.end());
    EXPECT_EQ(std::adjacent_find(about.begin(), about.end()), about.end()) << v;
    for (const std::int32_t t : about)
      EXPECT_EQ(std::count(torus.triangles[t].begin(), torus.triangles[t].end(), v), 1) << v;
    EXPECT_EQ(about.size(), 6u) << v;
  }
  EXPECT_TRUE(log.takeBack(state, all, 1).empty());
}

/// Undoing collapses at some places leaves a closed surface, on which further edges can be
/// collapsed.
TEST(CollapseLog, TakesBackAtSomePlaces) {
  const TriMesh torus = makeTorus(6, 2, 240, 120);
  const NearestTriangle nearest(torus.vertices, torus.triangles, NearestTriangle::Walks::Yes);
  CollapseState state = startOf(torus, nearest, 0.1);
  CollapseLog log;
  RunContext run;
  collapseEdges(state, false, run, &log);
  Random random(41);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::int32_t> number;
    const TriMesh before = takeMesh(state, &number);
    const auto chosen = static_cast<std::size_t>(
        random.number(0, static_cast<double>(before.triangles.size()) - 1));
    const std::vector<std::int32_t> changed = log.takeBack(state, {number[chosen]}, 1 << round % 4);
    ASSERT_FALSE(changed.empty());
    const TriMesh between = takeMesh(state);
    EXPECT_GT(between.triangles.size(), before.triangles.size());
    EXPECT_TRUE(checkMesh(between, run).passes());
    collapseAgain(state, changed, run, log);
    const TriMesh after = takeMesh(state);
    EXPECT_LT(after.triangles.size(), between.triangles.size());
    EXPECT_TRUE(checkMesh(after, run).passes());
    for (std::size_t t = 0; t < state.attached.size(); ++t) {
      for (const Eigen::Vector3d& p : state.attached[t]) {
        ASSERT_FALSE(state.dead[t]);
        const auto& c = state.mesh.triangles[t];
        EXPECT_LE(squaredDistance(p, state.mesh.vertices[c[0]], state.mesh.vertices[c[1]],
                                  state.mesh.vertices[c[2]]),
                  0.1 * 0.1);
      }
    }
  }
}

/// A spike of the original that the result lacks, and a spike of the result that the original
/// lacks.
TEST(Deviation, NamesWhatIsMissedAndWhatStrays) {
  const TriMesh ball = makeBall({0, 0, 0}, 5, 4);
  TriMesh spiked = ball;
  spiked.vertices[7] *= 1.2;
  const auto measure = [](const TriMesh& original, const TriMesh& result) {
    const NearestTriangle nearest(original.vertices, original.triangles,
                                  NearestTriangle::Walks::Yes);
    return DeviationMeter(original, nearest, 0.05, 0.3).measure(result, numbersOf(result));
  };
  const Deviation same = measure(ball, ball);
  EXPECT_NEAR(same.largest, 0, 1e-12);
  EXPECT_TRUE(same.missed.empty() && same.strays.empty());

  const Deviation missed = measure(spiked, ball);
  EXPECT_NEAR(missed.largest, 1, 0.01);
  ASSERT_FALSE(missed.missed.empty());
  for (const FarPoint& place : missed.missed) {
    EXPECT_LT((place.onOriginal - spiked.vertices[7]).norm(), 0.8);
    EXPECT_GT((place.onOriginal - place.onResult).norm(), 0.3);
    EXPECT_NEAR((place.onOriginal - place.onResult).norm(), distanceTo(ball, place.onOriginal),
                1e-9);
  }
  EXPECT_TRUE(missed.strays.empty());

  const Deviation strays = measure(ball, spiked);
  EXPECT_NEAR(strays.largest, 1, 0.01);
  EXPECT_TRUE(strays.missed.empty());
  std::vector<std::int32_t> about;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    const auto& c = ball.triangles[t];
    if (std::find(c.begin(), c.end(), 7) != c.end()) about.push_back(static_cast<std::int32_t>(t));
  }
  std::vector<std::int32_t> named;
  for (const FarPoint& place : strays.strays) {
    named.push_back(place.triangle);
    EXPECT_NEAR((place.onOriginal - place.onResult).norm(), distanceTo(ball, place.onResult), 1e-9);
    EXPECT_GT((place.onOriginal - place.onResult).norm(), 0.3);
  }
  EXPECT_EQ(named, about);
}

/// Triangles of the result disappear, appear again, and move, so that other places deviate.
TEST(Deviation, IsTheSameIfOnlyChangesAreMeasured) {
  const TriMesh original = makeBall({0, 0, 0}, 5, 5);
  const NearestTriangle nearest(original.vertices, original.triangles, NearestTriangle::Walks::Yes);
  const double spacing = 0.05, tolerance = 0.3;
  TriMesh result = makeBall({0, 0, 0}, 5, 3);
  DeviationMeter meter(original, nearest, spacing, tolerance);
  Random random(5);
  for (int round = 0; round < 12; ++round) {
    for (int n = 0; n < 3; ++n) {
      auto& p = result.vertices[random.index(result.vertices.size())];
      p *= random.number(4.6, 5.4) / p.norm();
    }
    TriMesh part{result.vertices, {}};
    std::vector<std::int32_t> numbers;
    for (const std::int32_t t : numbersOf(result)) {
      if (random.index(200) == 0) continue;
      part.triangles.push_back(result.triangles[t]);
      numbers.push_back(t);
    }
    const Deviation changed = meter.measure(part, numbers);
    const Deviation all =
        DeviationMeter(original, nearest, spacing, tolerance).measure(part, numbers);
    EXPECT_EQ(changed.missed.empty(), all.missed.empty()) << round;
    EXPECT_EQ(changed.missed.size(), all.missed.size()) << round;
    ASSERT_EQ(changed.strays.size(), all.strays.size()) << round;
    for (std::size_t i = 0; i < all.strays.size(); ++i)
      EXPECT_EQ(changed.strays[i].triangle, all.strays[i].triangle) << round;
    EXPECT_NEAR(changed.largest, all.largest, 1e-9) << round;
  }
}

TEST(MovingBoxes, FindWhatAllBoxesTogetherFind) {
  TriMesh mesh = makeTorus(6, 2, 40, 20);
  std::vector<std::int32_t> members(mesh.triangles.size());
  std::iota(members.begin(), members.end(), 0);
  MovingBoxes boxes(mesh, members);
  std::vector<char> gone(members.size(), 0);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(members.size()); ++t) {
    if (t % 4 != 0) {
      boxes.remove(t);
      gone[t] = 1;
    } else {
      mesh.triangles[t][0] = (7 * t) % static_cast<std::int32_t>(mesh.vertices.size());
      boxes.grow(t);
    }
  }
  for (int n = 0; n < 50; ++n) {
    MovingBoxes::Box box(mesh.vertices[16 * n]);
    box.extend(Eigen::Vector3d(mesh.vertices[16 * n] + Eigen::Vector3d(1, 0.5, 0.7)));
    std::set<std::int32_t> found, expected;
    boxes.forBox(box, [&](std::int32_t t, const MovingBoxes::Box& own) {
      EXPECT_TRUE(found.insert(t).second);
      EXPECT_EQ(own.center(), MovingBoxes::boxOf(mesh, t).center());
    });
    for (const std::int32_t t : members) {
      if (!gone[t] && MovingBoxes::boxOf(mesh, t).intersects(box)) expected.insert(t);
    }
    EXPECT_EQ(found, expected) << n;
  }
}

TEST(Quadric, RankCountsTheDirectionsThatAreFixed) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), p(2, 3, 4), about(0, 0, 0);
  Quadric q;
  int rank = 0;
  q.addPlane(x, p, 1);
  EXPECT_TRUE(q.minimise(about, 0.03, rank).isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_EQ(rank, 1);
  q.addPlane(y, p, 1);
  EXPECT_TRUE(q.minimise(about, 0.03, rank).isApprox(Eigen::Vector3d(2, 3, 0)));
  EXPECT_EQ(rank, 2);
  q.addPlane(z, p, 1);
  EXPECT_TRUE(q.minimise(about, 0.03, rank).isApprox(p));
  EXPECT_EQ(rank, 3);
  EXPECT_NEAR(q.error(p), 0, 1e-12);
}

}  // namespace swept::test
