// Cavities that a sweep encloses: they are kept if the user wants it, and only where they exist.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "geometry/shells.h"
#include "support/checked_compute.h"
#include "support/random_case.h"
#include "support/shapes.h"
#include "support/swept_distance.h"
#include "swept/clearance.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;
constexpr double kPi = 3.14159265358979323846;

Result kept(const TriMesh& body, const Trajectory& motion, double cell, bool keep = true,
            double offset = 0) {
  Options options;
  options.cellSize = cell;
  options.keepCavities = keep;
  options.offset = offset;
  return checkedCompute(body, motion, options);
}

Trajectory moving(const V3& travel, double turn = 0) {
  Pose end;
  end.timeSeconds = 1;
  end.translation = travel;
  end.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(turn, V3::UnitZ()));
  return {{Pose{}, end}, Interpolation::Linear};
}

std::int64_t cavities(const Result& result) {
  for (const Finding& f : result.report.warnings) {
    if (f.code == "CavitiesKept") return f.count;
  }
  return -1;
}

/// Returns a ball of radius 5 with a hollow ball of radius 3 in it.
TriMesh hollowBall() {
  TriMesh body = makeBall({0, 0, 0}, 5, 5);
  append(body, inverted(makeBall({0, 0, 0}, 3, 5)));
  return body;
}

/// Returns the volume that two balls of radius r have in common at a distance d.
double lens(double r, double d) { return kPi / 12 * (4 * r + d) * (2 * r - d) * (2 * r - d); }

TEST(Cavities, StillHollowBody) {
  const Trajectory still{{Pose{}}, Interpolation::None};
  const double full = 4.0 / 3 * kPi * 125, hole = 4.0 / 3 * kPi * 27;
  const Result with = kept(hollowBall(), still, 0.25);
  EXPECT_EQ(with.report.check.shells, 2);
  EXPECT_EQ(cavities(with), 1);
  EXPECT_NEAR(with.report.check.volume, full - hole, 0.005 * full);
  const Result without = kept(hollowBall(), still, 0.25, false);
  EXPECT_EQ(without.report.check.shells, 1);
  EXPECT_NEAR(without.report.check.volume, full, 0.005 * full);
}

TEST(Cavities, HollowBallInMotionKeepsWhatNoWallPassed) {
  for (const double travel : {1.0, 3.0, 5.0}) {
    const Result result = kept(hollowBall(), moving({travel, 0, 0}), 0.2);
    const double outer = 4.0 / 3 * kPi * 125 + kPi * 25 * travel;
    EXPECT_EQ(result.report.check.shells, 2) << travel;
    EXPECT_NEAR(result.report.check.volume, outer - lens(3, travel), 0.004 * outer) << travel;
  }
  // The motion is longer than the cavity is wide: the wall sweeps all of the cavity.
  const Result result = kept(hollowBall(), moving({6.5, 0, 0}), 0.2);
  EXPECT_EQ(result.report.check.shells, 1);
  EXPECT_EQ(cavities(result), 0);
}

TEST(Cavities, FastThinWallFillsWhatItPassesWithinAStep) {
  // A plate, one cell thick, passes in one step: a point is inside the plate for a short part of
  // the step only.
  const TriMesh plate = makeBox({0, 0, 0}, {0.2, 5, 5});
  const Result result = kept(plate, moving({8, 0, 0}), 0.2);
  EXPECT_EQ(result.report.check.shells, 1);
  EXPECT_EQ(cavities(result), 0);
  EXPECT_NEAR(result.report.check.volume, 8.2 * 25, 1);
}

TEST(Cavities, TwoCopiesOfACupSealASpace) {
  // A box with a pocket at the top; the second copy is upside down above it.
  TriMesh cup = makeBox({0, 0, 0}, {10, 10, 1});
  append(cup, makeBox({0, 0, 0}, {1, 10, 6}));
  append(cup, makeBox({9, 0, 0}, {10, 10, 6}));
  append(cup, makeBox({0, 0, 0}, {10, 1, 6}));
  append(cup, makeBox({0, 9, 0}, {10, 10, 6}));
  Pose over;
  over.timeSeconds = 1;
  over.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(kPi, V3::UnitX()));
  over.translation = V3(0, 10, 11);  // its walls reach 1 mm into those of the first copy
  const Trajectory copies{{Pose{}, over}, Interpolation::None};
  const Result result = kept(cup, copies, 0.25);
  EXPECT_EQ(result.report.check.shells, 2);
  EXPECT_NEAR(result.report.check.volume, 10 * 10 * 11 - 8 * 8 * 9, 10);
  // Grown by 1.5 mm, the space is smaller by 1.5 mm on all sides; by 4.2 mm it is gone.
  const Result grown = kept(cup, copies, 0.25, true, 1.5);
  const Result plain = kept(cup, copies, 0.25, false, 1.5);
  EXPECT_EQ(grown.report.check.shells, 2);
  EXPECT_NEAR(plain.report.check.volume - grown.report.check.volume, 5 * 5 * 6, 2);
  EXPECT_EQ(kept(cup, copies, 0.25, true, 4.2).report.check.shells, 1);
}

TEST(Cavities, TurningRingSealsNothing) {
  const TriMesh ring = makeSquareRing(5, 3, 0, 2);
  const Result result = kept(ring, moving({0, 0, 0}, 0.7), 0.2);
  EXPECT_EQ(cavities(result), 0);
  EXPECT_EQ(result.mesh.triangles, kept(ring, moving({0, 0, 0}, 0.7), 0.2, false).mesh.triangles);
}

std::size_t pieces(const TriMesh& body) {
  const std::vector<std::int32_t> joined = smallestJoinedVertices(body);
  return std::set<std::int32_t>(joined.begin(), joined.end()).size();
}

TEST(Cavities, RandomPointsAreInsideWhereTheSweepIs) {
  int within = 0, hollow = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    // SweptDistance uses the nearest face. Where two pieces of a body overlap, this may be a face
    // inside the body.
    TriMesh body = randomBody(random);
    while (pieces(body) > 1) body = randomBody(random);
    if (seed % 2 == 0) body = hollowBall();
    Trajectory motion = randomMotion(random);
    if (motion.interpolation == Interpolation::Screw) motion.interpolation = Interpolation::Linear;
    for (Pose& pose : motion.poses) pose.translation *= 0.25;
    const double cell = 0.3;
    const Result result = kept(body, motion, cell);
    const SweptDistance truth(body, motion, 0.05 * cell);
    Eigen::AlignedBox3d box;
    for (const V3& v : result.mesh.vertices) box.extend(v);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<V3> points;
    for (int i = 0; i < 400; ++i) {
      const V3 at(unit(random), unit(random), unit(random));
      points.push_back(box.min() + at.cwiseProduct(box.sizes()));
    }
    RunContext run;
    const std::vector<double> found = distanceToMesh(points, result.mesh, run);
    const Result filled = kept(body, motion, cell, false);
    const std::vector<double> outer = distanceToMesh(points, filled.mesh, run);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = truth.distance(points[i]);
      if (std::abs(d) < 0.5 * cell) continue;
      EXPECT_EQ(found[i] < 0, d < 0) << "seed " << seed << " at " << points[i].transpose();
      within += d < 0;
      hollow += d > 0 && outer[i] < 0;
    }
  }
  EXPECT_GT(within, 300);
  EXPECT_GT(hollow, 10);
}

TEST(Cavities, OpenBodySaysThatTheyAreFilled) {
  TriMesh box = makeBox({0, 0, 0}, {4, 4, 4});
  box.triangles.erase(box.triangles.begin());
  const Result result = kept(box, moving({3, 1, 2}), 0.25);
  const auto& notes = result.report.warnings;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [](const Finding& f) { return f.code == "CavitiesFilled"; }));
}

}  // namespace
}  // namespace swept::test
