// Solids of simple motions: exactly the surfaces of which the envelope consists, and no facets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/system.h"
#include "solid/recognise/recognise.h"
#include "solid/test_meshes.h"
#include "swept/compute.h"
#include "swept/solid.h"

namespace swept {
namespace {

namespace fs = std::filesystem;
using namespace test;
using step::CarrierKind;

TriMesh ball(double radius) {
  std::vector<Eigen::Vector2d> profile;
  constexpr int kSteps = 240;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = -M_PI / 2 + M_PI * i / kSteps;
    profile.emplace_back(i == 0 || i == kSteps ? 0.0 : radius * std::cos(a), radius * std::sin(a));
  }
  return revolved(profile, false, 2 * kSteps);
}

TriMesh rod(double radius, double length) {
  std::vector<Eigen::Vector2d> profile{{0, 0}};
  line(profile, {0, 0}, {radius, 0}, 4);
  line(profile, {radius, 0}, {radius, length}, 8);
  line(profile, {radius, length}, {0, length}, 4);
  return revolved(profile, false, 320);
}

// Returns a turn about an axis through the origin, in `steps` steps.
Trajectory about(const Eigen::Vector3d& axis, double angle, int steps) {
  Trajectory trajectory;
  trajectory.poses.resize(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) {
    Pose& pose = trajectory.poses[static_cast<std::size_t>(i)];
    pose.timeSeconds = i;
    pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle * i / steps, axis));
  }
  return trajectory;
}

// The parameter is the resolution. The tolerance is 0.1 % of the box diagonal.
class SweptBodies : public testing::TestWithParam<int> {
 protected:
  void solid(const TriMesh& body, Trajectory trajectory) {
    Options options;
    options.resolution = GetParam();
    trajectory.interpolation = Interpolation::Screw;
    RunContext run;
    const Result result = compute(body, trajectory, options, run);
    ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : result.mesh.vertices) box.extend(p);
    SolidOptions stepOptions;
    stepOptions.tolerance = 1e-3 * box.diagonal().norm();
    const fs::path file =
        fs::temp_directory_path() / ("swept-bodies-" + std::to_string(os::processId()) + "-" +
                                     std::to_string(GetParam()) + ".step");
    const WrittenSolid report = writeSolid(result.mesh, file.string(), stepOptions, run);
    fs::remove(file);
    kinds_.clear();
    for (const auto& [kind, count] : report.facesByKind) kinds_[kind] = count;
    EXPECT_EQ(report.note, "");
    EXPECT_EQ(kinds_["facet"], 0);
    EXPECT_LE(report.faces, 20);
    EXPECT_TRUE(report.valid);
    EXPECT_LE(report.deviation, stepOptions.tolerance * 1.0001);
    findSurfaces(result.mesh, 0.83 * stepOptions.tolerance);
  }

  void findSurfaces(const TriMesh& mesh, double tolerance) {
    RunContext run;
    const step::HalfEdgeMesh half = step::buildHalfEdges(mesh, run);
    step::Partition partition;
    partition.patchOf.assign(half.triangles.size(), -1);
    step::recogniseSurfaces(half, half, tolerance, partition, run);
    surfaces_.clear();
    for (const step::Patch& patch : partition.patches) surfaces_.push_back(patch.surface);
  }

  void expectRadius(CarrierKind kind, double radius) const {
    int count = 0;
    for (const step::Carrier& s : surfaces_) {
      if (s.kind != kind) continue;
      EXPECT_NEAR(kind == CarrierKind::Torus ? s.minor : s.radius, radius, kExact);
      ++count;
    }
    EXPECT_GT(count, 0);
  }
  void expectOn(CarrierKind kind, const std::vector<Eigen::Vector3d>& points) const {
    for (const Eigen::Vector3d& p : points) {
      double least = 1e300;
      for (const step::Carrier& s : surfaces_) {
        if (s.kind == kind) least = std::min(least, std::abs(s.distance(p)));
      }
      EXPECT_LE(least, kExact) << p.transpose();
    }
  }

  static constexpr double kExact = 1e-3;  // mm
  std::map<std::string, std::int64_t> kinds_;
  std::vector<step::Carrier> surfaces_;
};

TEST_P(SweptBodies, BallAlongALine) {
  const Eigen::Vector3d travel(13, 7, 21), direction = travel.normalized();
  solid(ball(5), along(travel));
  EXPECT_EQ(kinds_["cylinder"], 2);
  EXPECT_EQ(kinds_["sphere"], 4);
  expectRadius(CarrierKind::Cylinder, 5);
  expectRadius(CarrierKind::Sphere, 5);
  expectOn(CarrierKind::Sphere, {-5 * direction, travel + 5 * direction});
  const Eigen::Vector3d side = 5 * direction.unitOrthogonal();
  expectOn(CarrierKind::Cylinder, {side, -side, travel + side, travel - side});
}

TEST_P(SweptBodies, LargerBallAlongALine) {
  solid(ball(10), along({30, 40, 20}));
  EXPECT_EQ(kinds_["cylinder"], 2);
  EXPECT_EQ(kinds_["sphere"], 4);
}

TEST_P(SweptBodies, BallOnACircle) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d out = axis.unitOrthogonal();
  solid(transformed(ball(5), Eigen::Quaterniond::Identity(), 20 * out), about(axis, 2 * M_PI, 64));
  EXPECT_EQ(kinds_["torus"], 4);
  expectRadius(CarrierKind::Torus, 5);
  expectOn(CarrierKind::Torus, {25 * out, 15 * out, 20 * out + 5 * axis, -25 * out});
}

TEST_P(SweptBodies, RodAlongItsAxis) {
  const Eigen::Vector3d axis = oddTurn() * Eigen::Vector3d::UnitZ();
  solid(transformed(rod(5, 12), oddTurn(), {0, 0, 0}), along(20 * axis));
  EXPECT_EQ(kinds_["cylinder"], 2);
  EXPECT_EQ(kinds_["plane"], 2);
  expectRadius(CarrierKind::Cylinder, 5);
  expectOn(CarrierKind::Plane, {{0, 0, 0}, 32 * axis});
}

TEST_P(SweptBodies, BoxAlongALine) {
  solid(transformed(boxMesh(1, 1, 1, 10), oddTurn(), {0, 0, 0}), along({13, 7, 21}));
  EXPECT_EQ(kinds_["plane"], 12);
}

TEST_P(SweptBodies, BoxAboutAnEdge) {
  solid(boxMesh(1, 1, 1, 10), about(Eigen::Vector3d::UnitZ(), M_PI / 2, 16));
  EXPECT_EQ(kinds_["cylinder"], 1);
  EXPECT_EQ(kinds_["plane"], 5);
  expectRadius(CarrierKind::Cylinder, std::sqrt(200));
  expectOn(CarrierKind::Plane, {{5, 0, 5}, {-10, 5, 5}, {3, 3, 0}, {3, 3, 10}});
}

TEST_P(SweptBodies, BoxAboutAnEdgeInAGeneralDirection) {
  const Eigen::Quaterniond turn = oddTurn();
  solid(transformed(boxMesh(1, 1, 1, 10), turn, {0, 0, 0}),
        about(turn * Eigen::Vector3d::UnitZ(), M_PI / 2, 16));
  EXPECT_EQ(kinds_["cylinder"], 1);
  EXPECT_EQ(kinds_["plane"], 5);
  expectRadius(CarrierKind::Cylinder, std::sqrt(200));
  const std::array<Eigen::Vector3d, 4> on{{{5, 0, 5}, {-10, 5, 5}, {3, 3, 0}, {3, 3, 10}}};
  expectOn(CarrierKind::Plane, {turn * on[0], turn * on[1], turn * on[2], turn * on[3]});
}

INSTANTIATE_TEST_SUITE_P(Resolutions, SweptBodies, testing::Values(128, 256));

}  // namespace
}  // namespace swept
