// Rows 1 to 12 of the table of bad input, on checkBody() alone.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/body_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/checkpoint_hook.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

CheckedBody check(const TriMesh& mesh) {
  RunContext run;
  return checkBody(mesh, Options{}, run);
}

const Finding* find(const CheckedBody& body, const std::string& code) {
  for (const auto& finding : body.findings) {
    if (finding.code == code) return &finding;
  }
  return nullptr;
}

std::int64_t count(const CheckedBody& body, const std::string& code) {
  const Finding* finding = find(body, code);
  return finding == nullptr ? 0 : finding->count;
}

void expectMeshRefused(const TriMesh& mesh, const std::string& code, const std::string& words) {
  try {
    check(mesh);
    FAIL() << "not refused: " << code;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::InvalidInput);
    EXPECT_EQ(error.code(), code);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TriMesh unitBox() { return makeBox({0, 0, 0}, {1, 2, 3}); }

TEST(BodyCheck, CleanBodyIsLeftAsItIs) {
  const TriMesh ball = makeBall({5, -3, 2}, 2, 3);
  const CheckedBody body = check(ball);
  EXPECT_TRUE(body.closed);
  EXPECT_TRUE(body.orientable);
  EXPECT_TRUE(body.findings.empty());
  EXPECT_EQ(body.mesh.triangles, ball.triangles);
  ASSERT_EQ(body.mesh.vertices.size(), ball.vertices.size());
  for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
    EXPECT_EQ(body.mesh.vertices[v], ball.vertices[v]);
  }
}

TEST(BodyCheck, bad_input_01_empty_mesh) {
  expectMeshRefused({}, "EmptyMesh", "0 vertices and 0 triangles");
  TriMesh points = unitBox();
  points.triangles.clear();
  expectMeshRefused(points, "EmptyMesh", "8 vertices and 0 triangles");
}

TEST(BodyCheck, bad_input_02_index_out_of_range) {
  TriMesh mesh = unitBox();
  mesh.triangles[7][2] = 8;
  expectMeshRefused(mesh, "BadIndex",
                    "triangle 7 refers to vertex 8, but the mesh has 8 vertices (triangles and "
                    "vertices are counted from 0)");
  mesh.triangles[7][2] = -1;
  expectMeshRefused(mesh, "BadIndex", "triangle 7 refers to vertex -1");
}

TEST(BodyCheck, bad_input_03_not_a_number) {
  TriMesh mesh = unitBox();
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  mesh.vertices[5].x() = std::numeric_limits<double>::infinity();
  expectMeshRefused(mesh, "NonFiniteVertex", "2 vertices");
  expectMeshRefused(mesh, "NonFiniteVertex", "the first ones, counted from 0: 3, 5");
}

TEST(BodyCheck, bad_input_04_degenerate_triangles) {
  TriMesh mesh = unitBox();
  mesh.triangles.push_back({1, 1, 2});
  mesh.triangles.push_back({4, 5, 4});
  const CheckedBody body = check(mesh);
  EXPECT_EQ(count(body, "DegenerateTriangles"), 2);
  EXPECT_EQ(body.mesh.triangles, unitBox().triangles);
  EXPECT_TRUE(body.orientable);

  TriMesh line;
  line.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  line.triangles = {{0, 1, 2}, {0, 0, 1}};
  expectMeshRefused(line, "NoVolume", "2 without area");
}

TEST(BodyCheck, bad_input_05_soup_is_welded) {
  const TriMesh ball = makeBall({0, 0, 0}, 10, 2);
  TriMesh mesh = soup(ball);
  const CheckedBody body = check(mesh);
  EXPECT_TRUE(body.orientable);
  EXPECT_EQ(body.mesh.vertices.size(), ball.vertices.size());
  EXPECT_EQ(count(body, "Welded"),
            static_cast<std::int64_t>(mesh.vertices.size() - ball.vertices.size()));
  EXPECT_EQ(count(body, "WeldedWithinTolerance"), 0);

  // Corners apart by less than a millionth of the size, as after rounding in a file.
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    mesh.vertices[v].x() += 1e-6 * static_cast<double>(v % 7);
  }
  const CheckedBody rounded = check(mesh);
  EXPECT_TRUE(rounded.closed);
  EXPECT_TRUE(rounded.orientable);
  EXPECT_EQ(rounded.mesh.vertices.size(), ball.vertices.size());
  EXPECT_GT(count(rounded, "WeldedWithinTolerance"), 0);
}

TEST(BodyCheck, bad_input_05_zero_and_minus_zero_are_one_place) {
  TriMesh mesh = soup(unitBox());
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 2) {
    for (double& x : mesh.vertices[v]) {
      if (x == 0) x = -0.0;
    }
  }
  EXPECT_EQ(check(mesh).mesh.vertices.size(), 8u);
}

TEST(BodyCheck, bad_input_06_open_mesh_is_accepted_with_a_warning) {
  TriMesh mesh = unitBox();
  mesh.triangles.resize(10);  // the side x = 1 is missing
  const CheckedBody body = check(mesh);
  EXPECT_FALSE(body.closed);
  EXPECT_FALSE(body.orientable);
  EXPECT_EQ(count(body, "OpenEdges"), 4);
}

TEST(BodyCheck, bad_input_07_inward_normals) {
  const CheckedBody body = check(inverted(unitBox()));
  EXPECT_EQ(count(body, "Flipped"), 1);
  EXPECT_TRUE(body.orientable);
  EXPECT_NEAR(signedVolume(body.mesh), 6, 1e-12);
}

TEST(BodyCheck, bad_input_08_mixed_orientation) {
  TriMesh mesh = makeBall({0, 0, 0}, 1, 3);
  for (const std::size_t t : {3u, 17u, 40u}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const CheckedBody body = check(mesh);
  EXPECT_EQ(count(body, "MixedOrientation"), 3);
  EXPECT_TRUE(body.orientable);
  EXPECT_NEAR(signedVolume(body.mesh), signedVolume(makeBall({0, 0, 0}, 1, 3)), 1e-12);
}

TEST(BodyCheck, bad_input_08_one_sided_surface_has_no_orientation) {
  // A Moebius band stays open and one-sided.
  TriMesh mesh;
  const int n = 24;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * 3.14159265358979 * i / n;
    for (const double w : {-1.0, 1.0}) {
      const double r = 5 + w * std::cos(u / 2);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
    }
  }
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t a = 2 * i, b = 2 * i + 1;
    std::int32_t c = 2 * ((i + 1) % n), d = c + 1;
    if (i == n - 1) std::swap(c, d);
    mesh.triangles.push_back({a, c, d});
    mesh.triangles.push_back({a, d, b});
  }
  const CheckedBody body = check(mesh);
  EXPECT_EQ(count(body, "NotOrientable"), 1);
  EXPECT_FALSE(body.orientable);
}

TEST(BodyCheck, bad_input_09_non_manifold_edge) {
  // Two boxes that share an edge.
  TriMesh mesh = makeBox({0, 0, 0}, {1, 1, 1});
  append(mesh, makeBox({1, 1, 0}, {2, 2, 1}));
  const CheckedBody body = check(mesh);
  EXPECT_EQ(count(body, "NonManifoldEdges"), 1);
  EXPECT_TRUE(body.closed);
  EXPECT_TRUE(body.orientable);
  EXPECT_NEAR(signedVolume(body.mesh), 2, 1e-12);
}

TEST(BodyCheck, bad_input_10_overlapping_bodies_stay_outward) {
  TriMesh mesh = makeBox({0, 0, 0}, {2, 2, 2});
  append(mesh, makeBox({1, 1, 1}, {3, 3, 3}));
  const CheckedBody body = check(mesh);
  EXPECT_TRUE(body.orientable);
  EXPECT_NEAR(signedVolume(body.mesh), 16, 1e-12);
}

TEST(BodyCheck, bad_input_10_surface_that_crosses_itself_inside_out) {
  // A prism over a bow tie: one of its halves faces inwards, whatever its orientation.
  TriMesh mesh = makeBox({0, 0, 0}, {1, 1, 1});
  const Eigen::Vector2d profile[4] = {{-3, -2}, {1, 1}, {-3, 2}, {1, -1}};
  for (std::size_t v = 0; v < 8; ++v) mesh.vertices[v].head<2>() = profile[v % 4];
  const CheckedBody body = check(mesh);
  EXPECT_TRUE(body.closed);
  EXPECT_FALSE(body.orientable);
}

TEST(BodyCheck, bad_input_11_duplicate_triangles) {
  TriMesh mesh = unitBox();
  mesh.triangles.push_back({2, 3, 0});  // triangle 0 again, rotated
  const CheckedBody once = check(mesh);
  EXPECT_EQ(count(once, "DuplicateTriangles"), 1);
  EXPECT_EQ(once.mesh.triangles, unitBox().triangles);

  // Two boxes joined at a whole side: both copies of this side are removed.
  TriMesh pair = makeBox({0, 0, 0}, {1, 1, 1});
  TriMesh right = makeBox({1, 0, 0}, {2, 1, 1});
  // Same diagonal on the shared side: mirror of the left box.
  right = makeBox({0, 0, 0}, {1, 1, 1});
  for (auto& v : right.vertices) v.x() = 2 - v.x();
  append(pair, inverted(right));
  const CheckedBody both = check(pair);
  EXPECT_EQ(count(both, "OppositeTriangles"), 4);
  EXPECT_EQ(both.mesh.triangles.size(), 20u);
  EXPECT_TRUE(both.orientable);
  EXPECT_NEAR(signedVolume(both.mesh), 2, 1e-12);
}

TEST(BodyCheck, bad_input_12_cavity) {
  TriMesh mesh = makeBox({0, 0, 0}, {4, 4, 4});
  append(mesh, inverted(makeBox({1, 1, 1}, {2, 2, 2})));
  const CheckedBody body = check(mesh);
  EXPECT_EQ(count(body, "Cavities"), 1);
  EXPECT_EQ(count(body, "Flipped"), 0);
  EXPECT_TRUE(body.orientable);
  EXPECT_NEAR(signedVolume(body.mesh), 63, 1e-12);
  // All triangles reversed: still one cavity.
  const CheckedBody other = check(inverted(mesh));
  EXPECT_EQ(count(other, "Cavities"), 1);
  EXPECT_NEAR(signedVolume(other.mesh), 63, 1e-12);
}

TEST(BodyCheck, bad_input_12_body_within_a_cavity_and_within_material) {
  TriMesh mesh = makeBox({0, 0, 0}, {9, 9, 9});
  append(mesh, inverted(makeBox({1, 1, 1}, {8, 8, 8})));
  append(mesh, makeBox({2, 2, 2}, {3, 3, 3}));
  const CheckedBody island = check(mesh);
  EXPECT_TRUE(island.orientable);
  EXPECT_NEAR(signedVolume(island.mesh), 729 - 343 + 1, 1e-9);

  TriMesh solid = makeBox({0, 0, 0}, {9, 9, 9});
  append(solid, makeBox({2, 2, 2}, {3, 3, 3}));
  const CheckedBody nested = check(solid);
  EXPECT_EQ(count(nested, "NestedShells"), 1);
  EXPECT_EQ(count(nested, "Cavities"), 0);
  EXPECT_TRUE(nested.orientable);
  EXPECT_NEAR(signedVolume(nested.mesh), 730, 1e-9);
}

TEST(BodyCheck, bad_input_14_out_of_range) {
  TriMesh mesh = unitBox();
  for (auto& v : mesh.vertices) v.x() += 2e9;
  expectMeshRefused(mesh, "OutOfRange", "1e9 mm");
}

TEST(BodyCheck, CancelsAtEveryCheckpoint) {
  TriMesh mesh = makeBall({0, 0, 0}, 1, 3);
  RunContext whole;
  checkBody(mesh, Options{}, whole);
  ASSERT_GT(CheckpointHook::passed(whole), 3u);
  for (std::uint64_t n = 1; n <= CheckpointHook::passed(whole); ++n) {
    RunContext run;
    CheckpointHook::cancelAt(run, n);
    try {
      checkBody(mesh, Options{}, run);
      FAIL() << "not cancelled at " << n;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::Cancelled);
    }
  }
}

}  // namespace
}  // namespace swept::test
