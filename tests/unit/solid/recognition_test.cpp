// Recognised surfaces: the right kinds, exact sizes, a valid solid; facets where no surface
// fits.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "base/system.h"
#include "solid/mesh/decimate.h"
#include "solid/recognise/recognise.h"
#include "solid/test_meshes.h"
#include "swept/compute.h"
#include "swept/solid.h"

namespace swept {
namespace {

namespace fs = std::filesystem;
using namespace test;
using step::CarrierKind;

class Recognition : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / ("swept-recognition-" + std::to_string(os::processId()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  WrittenSolid write(const TriMesh& mesh, double tolerance, const char* name = "x.step") {
    SolidOptions options;
    options.tolerance = tolerance;
    RunContext run;
    const WrittenSolid report = writeSolid(mesh, (folder_ / name).string(), options, run);
    kinds_.clear();
    for (const auto& [kind, count] : report.facesByKind) kinds_[kind] = count;
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.note, "");
    return report;
  }
  static std::vector<step::Patch> patchesOf(const TriMesh& mesh, double tolerance) {
    RunContext run;
    const step::HalfEdgeMesh half = step::buildHalfEdges(mesh, run);
    step::Partition partition;
    partition.patchOf.assign(half.triangles.size(), -1);
    step::recogniseSurfaces(half, half, tolerance, partition, run);
    return partition.patches;
  }
  fs::path folder_;
  std::map<std::string, std::int64_t> kinds_;
};

TEST_F(Recognition, TorusIsExact) {
  const TriMesh mesh = transformed(makeTorus(20, 6, 160, 64), oddTurn(), {5, 7, -9});
  for (const step::Patch& patch : patchesOf(mesh, 0.02)) {
    ASSERT_EQ(patch.surface.kind, CarrierKind::Torus);
    EXPECT_NEAR(patch.surface.radius, 20, 1e-6);
    EXPECT_NEAR(patch.surface.minor, 6, 1e-6);
    EXPECT_LT((patch.surface.point - Eigen::Vector3d(5, 7, -9)).norm(), 1e-6);
    EXPECT_LT(patch.deviation, 1e-6);
  }
  const WrittenSolid report = write(mesh, 0.02);
  EXPECT_EQ(kinds_["torus"], report.faces);
  EXPECT_LE(report.faces, 8);
  EXPECT_NEAR(report.volume, 2 * M_PI * M_PI * 20 * 36, 1e-3);
}

TEST_F(Recognition, BoredCylinderHasPlanesAndTwoCylinders) {
  std::vector<Eigen::Vector2d> profile;
  line(profile, {3, 0}, {8, 0}, 10);
  line(profile, {8, 0}, {8, 12}, 20);
  line(profile, {8, 12}, {3, 12}, 10);
  line(profile, {3, 12}, {3, 0}, 20);
  const TriMesh mesh = transformed(revolved(profile, true, 180), oddTurn(), {100, 0, 3});
  ASSERT_GT(meshVolume(mesh), 0);
  bool bore = false;
  for (const step::Patch& patch : patchesOf(mesh, 0.01)) {
    if (patch.surface.kind != CarrierKind::Cylinder) continue;
    EXPECT_NEAR(patch.surface.radius, patch.surface.reversed ? 3 : 8, 1e-6);
    bore = bore || patch.surface.reversed;
  }
  EXPECT_TRUE(bore);
  for (const char* name : {"bored.step", "bored.brep"}) {
    const WrittenSolid report = write(mesh, 0.01, name);
    EXPECT_EQ(kinds_["cylinder"], 4) << name;
    EXPECT_EQ(kinds_["plane"], 2) << name;
    EXPECT_EQ(report.faces, 6) << name;
    EXPECT_NEAR(report.volume, M_PI * (64 - 9) * 12, 1e-3) << name;
  }
}

TEST_F(Recognition, ConeAndSphereMeetInACircle) {
  // A frustum with radii 8 and 5 mm, 10 mm high, under a dome of radius 13 mm about (0, 0, -2).
  std::vector<Eigen::Vector2d> profile;
  line(profile, {0, 0}, {8, 0}, 12, false);
  line(profile, {8, 0}, {5, 10}, 16);
  const double from = std::atan2(12, 5);
  for (int i = 1; i <= 12; ++i) {
    const double a = from + (M_PI / 2 - from) * i / 12;
    profile.emplace_back(i == 12 ? 0.0 : 13 * std::cos(a), -2 + 13 * std::sin(a));
  }
  const TriMesh mesh = revolved(profile, false, 200);
  const WrittenSolid report = write(mesh, 0.01);
  EXPECT_GE(kinds_["cone"], 1);
  EXPECT_GE(kinds_["sphere"], 1);
  EXPECT_EQ(kinds_["plane"], 1);
  EXPECT_EQ(kinds_["facet"], 0);
  const double frustum = M_PI * 10 * (64 + 40 + 25) / 3.0, cap = 1.0;
  EXPECT_NEAR(report.volume, frustum + M_PI * cap * (3 * 25 + cap * cap) / 6, 1e-3);
}

TEST_F(Recognition, SweptBoxIsItsPolyhedron) {
  const TriMesh body = transformed(boxMesh(1, 1, 1, 10), oddTurn(), {0, 0, 0});
  const Eigen::Vector3d travel(13, 7, 21);
  Trajectory trajectory;
  trajectory.poses.resize(2);
  trajectory.poses[1].timeSeconds = 1;
  trajectory.poses[1].translation = travel;
  Options options;
  // A crease may be off by a quarter of a cell. The cells are 0.14 mm here, so this is 0.035 mm,
  // which the tolerance of 0.05 mm covers.
  options.resolution = 256;
  RunContext run;
  const Result result = compute(body, trajectory, options, run);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  const WrittenSolid report = write(result.mesh, 0.05);
  EXPECT_EQ(report.faces, 12);
  EXPECT_EQ(report.edges, 24);
  EXPECT_EQ(kinds_["plane"], 12);
  const Eigen::Vector3d inBody = oddTurn().conjugate() * travel;
  EXPECT_NEAR(report.volume, 1000 + 100 * inBody.cwiseAbs().sum(), 0.05);
}

TEST_F(Recognition, SweptBallIsSphereAndCylinder) {
  std::vector<Eigen::Vector2d> profile;
  constexpr int kSteps = 160;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = -M_PI / 2 + M_PI * i / kSteps;
    profile.emplace_back(i == 0 || i == kSteps ? 0.0 : 5 * std::cos(a), 5 * std::sin(a));
  }
  const Eigen::Vector3d travel(13, 7, 21);
  Trajectory trajectory;
  trajectory.poses.resize(2);
  trajectory.poses[1].timeSeconds = 1;
  trajectory.poses[1].translation = travel;
  Options options;
  options.resolution = 96;
  RunContext run;
  const Result result = compute(revolved(profile, false, 2 * kSteps), trajectory, options, run);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  const WrittenSolid report = write(result.mesh, 0.04);
  EXPECT_LE(report.faces, 20);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_GE(kinds_["sphere"], 2);
  EXPECT_GE(kinds_["cylinder"], 2);
  EXPECT_NEAR(report.volume, M_PI * 25 * travel.norm() + 4 / 3.0 * M_PI * 125, 4.0);
}

// A free form: nothing is recognised, the facets are fewer and within the tolerance.
TEST_F(Recognition, FreeFormIsSimplifiedWithinTheTolerance) {
  TriMesh mesh = makeTorus(20, 6, 150, 60);
  for (auto& p : mesh.vertices) {
    p *= 1 + 0.04 * std::sin(0.31 * p.x()) * std::cos(0.23 * p.y() + 0.5) +
         0.03 * std::sin(0.4 * p.z());
  }
  const double tolerance = 0.05;
  const WrittenSolid report = write(mesh, tolerance);
  EXPECT_LT(report.faces, 6000);
  EXPECT_GT(report.deviation, 0);
  EXPECT_LE(report.deviation, tolerance * 1.0001);
  EXPECT_NEAR(report.volume, meshVolume(mesh), 0.01 * report.volume);
}

// Returns a post on wavy ground. At the foot of the post, points of the border lie on the ground
// even if the border cuts into the post.
TriMesh postOnWaves(double radius) {
  std::vector<Eigen::Vector2d> profile{{0, -10}};
  line(profile, {0, -10}, {40, -10}, 20);
  line(profile, {40, -10}, {40, 0}, 8);
  line(profile, {40, 0}, {radius, 0}, 40);
  line(profile, {radius, 0}, {radius, 20}, 20);
  line(profile, {radius, 20}, {0, 20}, 10);
  TriMesh mesh = revolved(profile, false, 128);
  for (auto& p : mesh.vertices) {
    const double wave = std::sin(0.5 * p.x()) * std::cos(0.4 * p.y() + 0.3);
    p.z() += wave * (p.z() > 0 ? 1 - p.z() / 20 : 1 + p.z() / 10);
  }
  return mesh;
}

TEST_F(Recognition, BordersOfOpenGroundStayOnTheirSurface) {
  const double radius = 10, tolerance = 0.1;
  RunContext run;
  const step::HalfEdgeMesh mesh = step::buildHalfEdges(postOnWaves(radius), run);
  step::Partition partition;
  partition.patchOf.assign(mesh.triangles.size(), -1);
  step::recogniseSurfaces(mesh, mesh, tolerance, partition, run);
  const NearestTriangle original(mesh.points, mesh.triangles);
  const step::Decimated small =
      step::decimate({mesh, partition, {}, {}, 0}, tolerance, original, run);
  int borders = 0;
  for (std::size_t h = 0; h < small.mesh.opposite.size(); ++h) {
    const std::int32_t patch = small.partition.patchOf[h / 3];
    if (patch < 0 || small.partition.patchOf[small.mesh.opposite[h] / 3] >= 0) continue;
    const step::Carrier& surface = small.partition.patches[patch].surface;
    if (surface.kind != CarrierKind::Cylinder || surface.radius > 1.5 * radius) continue;
    const auto half = static_cast<std::int32_t>(h);
    const Eigen::Vector3d middle =
        (small.mesh.points[small.mesh.origin(half)] + small.mesh.points[small.mesh.target(half)]) /
        2;
    EXPECT_LE(std::abs(surface.distance(middle)), tolerance);
    ++borders;
  }
  EXPECT_GT(borders, 10);
  const WrittenSolid report = write(postOnWaves(radius), tolerance);
  EXPECT_GE(kinds_["cylinder"], 1);
  EXPECT_GT(kinds_["facet"], 100);
  EXPECT_LE(report.deviation, tolerance * 1.0001);
}

TEST_F(Recognition, DecimationKeepsTheMeshClosedAndNear) {
  const TriMesh input = makeTorus(20, 6, 120, 48);
  RunContext run;
  const step::HalfEdgeMesh mesh = step::buildHalfEdges(input, run);
  step::Partition nothing;
  nothing.patchOf.assign(mesh.triangles.size(), -1);
  const NearestTriangle original(mesh.points, mesh.triangles);
  const step::Decimated small = step::decimate({mesh, nothing, {}, {}, 0}, 0.1, original, run);
  EXPECT_LT(small.mesh.triangles.size(), mesh.triangles.size() / 4);
  EXPECT_LE(small.deviation, 0.1);
  TriMesh output;
  output.vertices = small.mesh.points;
  output.triangles = small.mesh.triangles;
  const MeshCheck check = checkMesh(output, run);
  EXPECT_TRUE(check.passes());
  EXPECT_NEAR(check.volume, meshVolume(input), 0.1 * check.area);
}

// The mesh is so large that it is processed in parts. The result must not show the parts, and must
// not depend on the number of threads.
TEST_F(Recognition, DecimationInPartsIsTheSameWithOneThread) {
  const TriMesh input = makeTorus(20, 6, 220, 90);
  RunContext run;
  const step::HalfEdgeMesh mesh = step::buildHalfEdges(input, run);
  ASSERT_GT(mesh.triangles.size(), 30000U);
  step::Partition nothing;
  nothing.patchOf.assign(mesh.triangles.size(), -1);
  const NearestTriangle original(mesh.points, mesh.triangles);
  const auto decimated = [&] {
    return step::decimate({mesh, nothing, {}, {}, 0}, 0.1, original, run);
  };
  const step::Decimated parallel = decimated();
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const step::Decimated serial = decimated();
  EXPECT_EQ(parallel.mesh.triangles, serial.mesh.triangles);
  EXPECT_EQ(parallel.mesh.points, serial.mesh.points);
  EXPECT_LE(parallel.deviation, 0.1);
  // A regular mesh of the torus within this deviation has about 700 triangles.
  EXPECT_LT(parallel.mesh.triangles.size(), 1500U);
  TriMesh output;
  output.vertices = parallel.mesh.points;
  output.triangles = parallel.mesh.triangles;
  EXPECT_TRUE(checkMesh(output, run).passes());
}

}  // namespace
}  // namespace swept
