// Properties that hold for any body and motion, on seeded random cases: more than 250 in all, twice
// as many with SWEPT_LONG_TESTS. Lengths are in cells; volumes in units of area x cell. Where two
// results are compared, each may be as far from the exact surface as tests/unit/truth allows, so
// the limits here are twice those.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cstring>
#include <optional>

#include "support/mesh_distance.h"
#include "support/random_case.h"
#include "support/sampled.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

const int kSeeds = longRun() ? 72 : 36;
constexpr double kVolumeBar = 0.1;

Result sweep(const TriMesh& body, const Trajectory& motion, int resolution,
             std::optional<int> threads = {}, std::optional<double> cell = {}) {
  Options options;
  options.resolution = resolution;
  options.cellSize = cell;
  RunContext run;
  run.threads = threads;
  return compute(body, motion, options, run);
}

void expectOk(const Result& result) {
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  EXPECT_TRUE(result.report.check.passes());
}

/// Returns the largest distance, in cells, of the vertices of one mesh from the other. Vertices
/// inside the other solid are left out. A gap narrower than a cell may be open on one grid and
/// closed on the other; the space behind it is then a pocket in one result and solid in the
/// other.
double reach(const TriMesh& from, const TriMesh& to, double cell) {
  const MeshDistance tree(to);
  double most = 0;
  for (const auto& v : from.vertices) {
    const double distance = tree.distance(v) / cell;
    if (distance > most && (distance < 0.5 || !tree.inside(v))) most = distance;
  }
  return most;
}

double volumeGap(const Result& a, const Result& b) {
  const double cell = std::max(a.report.cellSize, b.report.cellSize);
  return std::abs(a.report.check.volume - b.report.check.volume) / (a.report.check.area * cell);
}

class Property : public testing::Test {
 protected:
  /// Calls test(body, motion, random) for each seed.
  template <class Test>
  void forSeeds(int first, int count, Test&& test) {
    const int last = first + sampled(count, 24);
    for (int seed = first; seed < last; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      std::mt19937 random(static_cast<unsigned>(seed));
      const TriMesh body = randomBody(random);
      const Trajectory motion = randomMotion(random);
      test(body, motion, random);
    }
  }
};

TEST_F(Property, MovingEverythingMovesTheResult) {
  forSeeds(1000, kSeeds, [](const TriMesh& body, const Trajectory& motion, std::mt19937& random) {
    const Eigen::Isometry3d frame = randomFrame(random);
    Trajectory moved = motion;
    for (auto& pose : moved.poses) {
      pose.rotation = Eigen::Quaterniond(frame.linear()) * pose.rotation;
      pose.translation = frame * pose.translation;
    }
    const Result here = sweep(body, motion, 40);
    const Result there = sweep(body, moved, 40, {}, here.report.cellSize);
    expectOk(here);
    expectOk(there);
    EXPECT_LE(volumeGap(here, there), kVolumeBar);
    const TriMesh mapped = transformed(here.mesh, frame);
    EXPECT_LE(reach(mapped, there.mesh, here.report.cellSize), 2.0);
    EXPECT_LE(reach(there.mesh, mapped, here.report.cellSize), 2.0);
  });
}

TEST_F(Property, FinerCellsConverge) {
  forSeeds(2000, kSeeds / 2, [](const TriMesh& body, const Trajectory& motion, std::mt19937&) {
    const Result coarse = sweep(body, motion, 24);
    const Result middle = sweep(body, motion, 48);
    const Result fine = sweep(body, motion, 96);
    expectOk(coarse);
    expectOk(middle);
    expectOk(fine);
    EXPECT_LE(volumeGap(coarse, fine), kVolumeBar);
    EXPECT_LE(volumeGap(middle, fine), kVolumeBar);
    EXPECT_LE(reach(coarse.mesh, fine.mesh, coarse.report.cellSize), 1.0);
    EXPECT_LE(reach(middle.mesh, fine.mesh, middle.report.cellSize), 1.0);
  });
}

TEST_F(Property, ReversedMotionSweepsTheSame) {
  forSeeds(3000, kSeeds, [](const TriMesh& body, const Trajectory& motion, std::mt19937&) {
    Trajectory back = motion;
    const double last = motion.poses.back().timeSeconds;
    std::reverse(back.poses.begin(), back.poses.end());
    for (auto& pose : back.poses) pose.timeSeconds = last - pose.timeSeconds;
    const Result there = sweep(body, motion, 40);
    const Result again = sweep(body, back, 40);
    expectOk(there);
    expectOk(again);
    EXPECT_LE(volumeGap(there, again), 0.01);
    EXPECT_LE(reach(there.mesh, again.mesh, there.report.cellSize), 0.5);
    EXPECT_LE(reach(again.mesh, there.mesh, there.report.cellSize), 0.5);
  });
}

TEST_F(Property, MorePosesNeverRemoveVolume) {
  forSeeds(4000, kSeeds / 2,
           [](const TriMesh& body, const Trajectory& motion, std::mt19937& random) {
             Trajectory longer = motion;
             const Trajectory more = randomMotion(random);
             Pose pose = more.poses.back();
             pose.timeSeconds = motion.poses.back().timeSeconds + 1;
             pose.rotation = motion.poses.back().rotation.slerp(0.4, pose.rotation);
             pose.translation = motion.poses.back().translation + Eigen::Vector3d(1, -2, 0.5);
             longer.poses.push_back(pose);
             const Result before = sweep(body, motion, 40);
             const Result after = sweep(body, longer, 40, {}, before.report.cellSize);
             expectOk(before);
             expectOk(after);
             const double cell = before.report.cellSize;
             EXPECT_GE(after.report.check.volume,
                       before.report.check.volume - kVolumeBar * before.report.check.area * cell);
             const MeshDistance tree(after.mesh);
             for (const auto& v : before.mesh.vertices) {
               if (tree.distance(v) > cell) {
                 EXPECT_TRUE(tree.inside(v)) << v.transpose();
               }
             }
           });
}

TEST_F(Property, VolumeIsAtLeastThatOfTheBody) {
  forSeeds(5000, kSeeds, [](const TriMesh& body, const Trajectory& motion, std::mt19937&) {
    Trajectory still = motion;
    still.poses.resize(1);
    const Result swept = sweep(body, motion, 32);
    const Result one = sweep(body, still, 32, {}, swept.report.cellSize);
    expectOk(swept);
    if (one.report.status != Status::Ok) {  // the cell may be too large for the body alone
      EXPECT_EQ(one.report.code, "CellTooLarge");
      return;
    }
    EXPECT_GE(swept.report.check.volume,
              one.report.check.volume - kVolumeBar * one.report.check.area * one.report.cellSize);
  });
}

TEST_F(Property, TwoBodiesTogetherAreTheirUnion) {
  forSeeds(6000, kSeeds / 2,
           [](const TriMesh& body, const Trajectory& motion, std::mt19937& random) {
             const TriMesh other = randomBody(random);
             TriMesh both = body;
             append(both, other);
             const Result whole = sweep(both, motion, 40);
             expectOk(whole);
             const double cell = whole.report.cellSize;
             const Result first = sweep(body, motion, 40, {}, cell);
             const Result second = sweep(other, motion, 40, {}, cell);
             expectOk(first);
             expectOk(second);
             const MeshDistance a(first.mesh), b(second.mesh);
             for (const auto& v : whole.mesh.vertices) {
               const double distance = std::min(a.distance(v), b.distance(v));
               if (distance > 2 * cell) {
                 EXPECT_TRUE(a.inside(v) || b.inside(v)) << v.transpose();
               }
             }
             EXPECT_LE(whole.report.check.volume, first.report.check.volume +
                                                      second.report.check.volume +
                                                      kVolumeBar * whole.report.check.area * cell);
           });
}

TEST_F(Property, MotionCutInTwoIsTheUnionOfItsParts) {
  forSeeds(7000, kSeeds / 2, [](const TriMesh& body, const Trajectory& motion, std::mt19937&) {
    Trajectory first = motion, second = motion;
    const std::size_t cut = motion.poses.size() / 2;
    first.poses.resize(cut + 1);
    second.poses.erase(second.poses.begin(), second.poses.begin() + static_cast<long>(cut));
    const Result whole = sweep(body, motion, 40);
    expectOk(whole);
    const double cell = whole.report.cellSize;
    const Result a = sweep(body, first, 40, {}, cell);
    const Result b = sweep(body, second, 40, {}, cell);
    expectOk(a);
    expectOk(b);
    const MeshDistance treeA(a.mesh), treeB(b.mesh), tree(whole.mesh);
    for (const auto& v : whole.mesh.vertices) {
      const double distance = std::min(treeA.distance(v), treeB.distance(v));
      if (distance > 2 * cell) {
        EXPECT_TRUE(treeA.inside(v) || treeB.inside(v)) << v.transpose();
      }
    }
    for (const TriMesh* part : {&a.mesh, &b.mesh}) {
      for (const auto& v : part->vertices) {
        if (tree.distance(v) > 2 * cell) {
          EXPECT_TRUE(tree.inside(v)) << v.transpose();
        }
      }
    }
  });
}

TEST_F(Property, OrderOfTrianglesDoesNotMatter) {
  forSeeds(8000, kSeeds, [](const TriMesh& body, const Trajectory& motion, std::mt19937& random) {
    const Result one = sweep(body, motion, 40);
    const Result other = sweep(shuffled(body, random), motion, 40);
    expectOk(one);
    expectOk(other);
    EXPECT_LE(volumeGap(one, other), 0.01);
    EXPECT_LE(reach(one.mesh, other.mesh, one.report.cellSize), 0.5);
    EXPECT_LE(reach(other.mesh, one.mesh, one.report.cellSize), 0.5);
  });
}

TEST_F(Property, OrientationOfTrianglesDoesNotMatter) {
  forSeeds(9000, kSeeds / 2,
           [](const TriMesh& body, const Trajectory& motion, std::mt19937& random) {
             TriMesh mixed = body;
             std::bernoulli_distribution coin(0.3);
             for (auto& t : mixed.triangles) {
               if (coin(random)) std::swap(t[1], t[2]);
             }
             const Result one = sweep(body, motion, 40);
             const Result other = sweep(mixed, motion, 40);
             expectOk(one);
             expectOk(other);
             EXPECT_LE(volumeGap(one, other), 0.01);
             EXPECT_LE(reach(other.mesh, one.mesh, one.report.cellSize), 0.5);
           });
}

TEST_F(Property, CullingDoesNotChangeTheEnvelope) {
  forSeeds(10000, kSeeds, [](const TriMesh& body, const Trajectory& motion, std::mt19937&) {
    Options options;
    options.resolution = 40;
    RunContext first, second;
    const Result culled = compute(body, motion, options, first);
    options.cull = false;
    const Result full = compute(body, motion, options, second);
    expectOk(culled);
    expectOk(full);
    EXPECT_LE(volumeGap(culled, full), 1e-3);
    EXPECT_LE(reach(culled.mesh, full.mesh, culled.report.cellSize), 0.5);
    EXPECT_LE(reach(full.mesh, culled.mesh, culled.report.cellSize), 0.5);
  });
}

TEST_F(Property, SameBytesForAnyNumberOfThreads) {
  forSeeds(11000, 12, [](const TriMesh& body, const Trajectory& motion, std::mt19937&) {
    const Result one = sweep(body, motion, 56, 1);
    expectOk(one);
    for (const int threads : {2, 3, 8, 1}) {
      const Result other = sweep(body, motion, 56, threads);
      ASSERT_EQ(one.mesh.triangles, other.mesh.triangles) << threads;
      ASSERT_EQ(one.mesh.vertices.size(), other.mesh.vertices.size());
      EXPECT_EQ(0, std::memcmp(one.mesh.vertices.data(), other.mesh.vertices.data(),
                               one.mesh.vertices.size() * sizeof(Eigen::Vector3d)))
          << threads;
      EXPECT_EQ(one.contactTime, other.contactTime) << threads;
    }
  });
}

}  // namespace
}  // namespace swept::test
