// Extrusions and revolutions: bodies with profiles other than lines and circles, moved straight
// or turned.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/system.h"
#include "solid/recognise/fit_profile.h"
#include "solid/recognise/recognise.h"
#include "solid/test_meshes.h"
#include "swept/compute.h"
#include "swept/solid.h"

namespace swept {
namespace {

namespace fs = std::filesystem;
using namespace test;
using step::CarrierKind;

// Returns a right prism over a closed outline (counter-clockwise) about the origin.
TriMesh prism(const std::vector<Eigen::Vector2d>& outline, double height, int rows) {
  TriMesh mesh;
  const auto count = static_cast<std::int32_t>(outline.size());
  for (int k = 0; k <= rows; ++k) {
    for (const Eigen::Vector2d& p : outline)
      mesh.vertices.emplace_back(p.x(), p.y(), height * k / rows);
  }
  const auto bottom = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, 0);
  mesh.vertices.emplace_back(0, 0, height);
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t j = (i + 1) % count;
    for (int k = 0; k < rows; ++k) {
      const std::int32_t a = k * count, b = a + count;
      mesh.triangles.push_back({a + i, a + j, b + j});
      mesh.triangles.push_back({a + i, b + j, b + i});
    }
    mesh.triangles.push_back({bottom, j, i});
    mesh.triangles.push_back({bottom + 1, rows * count + i, rows * count + j});
  }
  return mesh;
}

std::vector<Eigen::Vector2d> ellipse(double a, double b, int steps) {
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < steps; ++i) {
    const double u = 2 * M_PI * i / steps;
    outline.emplace_back(a * std::cos(u), b * std::sin(u));
  }
  return outline;
}

// Returns the outline of a round shape of three lobes.
std::vector<Eigen::Vector2d> clover(double radius, int steps) {
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < steps; ++i) {
    const double u = 2 * M_PI * i / steps, r = radius * (1 + 0.12 * std::cos(3 * u));
    outline.emplace_back(r * std::cos(u), r * std::sin(u));
  }
  return outline;
}

TriMesh vase(int steps, int around) {
  std::vector<Eigen::Vector2d> profile{{0, 0}};
  const auto radius = [](double z) { return 9 + 2 * std::sin(0.25 * z + 0.6); };
  line(profile, {0, 0}, {radius(0), 0}, 12);
  for (int i = 1; i <= steps; ++i) profile.emplace_back(radius(30.0 * i / steps), 30.0 * i / steps);
  line(profile, {radius(30), 30}, {0, 30}, 12);
  return revolved(profile, false, around);
}

class Profiles : public testing::Test {
 protected:
  void SetUp() override {
    file_ =
        fs::temp_directory_path() / ("swept-profiles-" + std::to_string(os::processId()) + ".step");
  }
  void TearDown() override { fs::remove(file_); }

  WrittenSolid write(const TriMesh& mesh, double tolerance) {
    SolidOptions options;
    options.tolerance = tolerance;
    RunContext run;
    const WrittenSolid report = writeSolid(mesh, file_.string(), options, run);
    kinds_.clear();
    for (const auto& [kind, count] : report.facesByKind) kinds_[kind] = count;
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.note, "");
    EXPECT_LE(report.deviation, tolerance * 1.0001);
    return report;
  }

  static TriMesh swept(const TriMesh& body, const Trajectory& trajectory, int resolution) {
    Options options;
    options.resolution = resolution;
    RunContext run;
    Result result = compute(body, trajectory, options, run);
    EXPECT_EQ(result.report.status, Status::Ok) << result.report.message;
    return std::move(result.mesh);
  }

  fs::path file_;
  std::map<std::string, std::int64_t> kinds_;
};

double tolerances(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.vertices) box.extend(p);
  return 1e-3 * box.diagonal().norm();
}

TEST_F(Profiles, CurveThroughPointsOfAnEllipse) {
  step::Cloud cloud;
  const int count = 400;
  for (int i = 0; i < count; ++i) {
    const double u = 2 * M_PI * ((i * 149) % count) / count;  // in mixed order
    cloud.points.emplace_back(12 * std::cos(u), 7 * std::sin(u));
    cloud.normals.push_back(Eigen::Vector2d(7 * std::cos(u), 12 * std::sin(u)).normalized());
  }
  const auto profile = step::fitProfile(cloud, 1e-4);
  ASSERT_TRUE(profile.has_value());
  EXPECT_TRUE(profile->isClosed());
  for (int i = 0; i < 100; ++i) {
    const double u = 0.063 * i;
    const Eigen::Vector2d p(12 * std::cos(u), 7 * std::sin(u));
    const Eigen::Vector2d n = Eigen::Vector2d(7 * std::cos(u), 12 * std::sin(u)).normalized();
    EXPECT_NEAR(profile->distance(p), 0, 5e-4);
    EXPECT_NEAR(profile->distance(p + 0.5 * n), 0.5, 5e-4);
    EXPECT_NEAR(profile->distance(p - 0.5 * n), -0.5, 5e-4);
    EXPECT_GT(profile->normal(p).dot(n), 0.9999);
    EXPECT_NEAR(profile->offset(0.2).distance(p), -0.2, 2e-3);
  }
}

TEST_F(Profiles, EllipticPrismIsAnExtrusion) {
  const TriMesh mesh = transformed(prism(ellipse(12, 7, 360), 30, 12), oddTurn(), {5, -40, 11});
  const WrittenSolid report = write(mesh, 0.02);
  EXPECT_GE(kinds_["extrusion"], 1);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_LE(report.faces, 6);
  EXPECT_NEAR(report.volume, M_PI * 12 * 7 * 30, 1.5);
}

TEST_F(Profiles, CloverPrismIsAnExtrusion) {
  const TriMesh mesh = transformed(prism(clover(10, 480), 25, 12), oddTurn(), {0, 0, 0});
  const WrittenSolid report = write(mesh, 0.02);
  EXPECT_GE(kinds_["extrusion"], 1);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_LE(report.faces, 6);
  EXPECT_NEAR(report.volume, M_PI * 100 * (1 + 0.12 * 0.12 / 2) * 25, 1.5);
}

TEST_F(Profiles, VaseIsARevolution) {
  const TriMesh mesh = transformed(vase(70, 150), oddTurn(), {3, 8, -2});
  const WrittenSolid report = write(mesh, 0.03);
  EXPECT_GE(kinds_["revolution"], 1);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_LE(report.faces, 6);
  EXPECT_NEAR(report.volume, meshVolume(mesh), 6);
}

TEST_F(Profiles, EllipticRingIsARevolution) {
  std::vector<Eigen::Vector2d> profile;
  for (const Eigen::Vector2d& p : ellipse(6, 3, 72)) profile.push_back({p.x() + 20, p.y()});
  const TriMesh mesh = transformed(revolved(profile, true, 180), oddTurn(), {1, 2, 3});
  const WrittenSolid report = write(mesh, 0.03);
  EXPECT_GE(kinds_["revolution"], 1);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_LE(report.faces, 8);
  EXPECT_NEAR(report.volume, 2 * M_PI * 20 * M_PI * 18, 0.002 * report.volume);
}

// The outline of a swept disc, moved along its axis and at an angle to it.
TEST_F(Profiles, SweptEllipticDisc) {
  const TriMesh body = transformed(prism(ellipse(12, 7, 240), 4, 4), oddTurn(), {0, 0, 0});
  for (const Eigen::Vector3d& travel : {Eigen::Vector3d(0, 0, 25), Eigen::Vector3d(14, 3, 20)}) {
    const TriMesh mesh = swept(body, along(oddTurn() * travel), 96);
    const WrittenSolid report = write(mesh, tolerances(mesh));
    EXPECT_GE(kinds_["extrusion"], 1);
    EXPECT_EQ(kinds_["facet"], 0);
    EXPECT_LE(report.faces, 20);
    EXPECT_NEAR(report.volume, meshVolume(mesh), 0.001 * report.volume);
  }
}

}  // namespace
}  // namespace swept
