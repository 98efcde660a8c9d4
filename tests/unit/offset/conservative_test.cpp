// Conservative envelopes: no point of the sweep lies outside, and the reported bound holds.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "support/checked_compute.h"
#include "support/random_case.h"
#include "support/shapes.h"
#include "support/swept_distance.h"
#include "swept/clearance.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;

Result conservative(const TriMesh& body, const Trajectory& motion, Options options) {
  options.conservative = true;
  return checkedCompute(body, motion, options);
}

/// Returns random points of the body's surface at random times, at the placements of SweptDistance.
std::vector<V3> sweepPoints(const SweptDistance& truth, int count, std::mt19937& random) {
  const TriMesh& mesh = truth.body().mesh();
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<std::size_t> any(0, mesh.triangles.size() - 1);
  std::vector<V3> points;
  for (int i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[any(random)];
    double u = unit(random), v = unit(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    if (i % 5 == 0) u = v = 0;  // corners are what gets lost first
    const V3 x = mesh.vertices[t[0]] + u * (mesh.vertices[t[1]] - mesh.vertices[t[0]]) +
                 v * (mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    double time = truth.lastTime() * unit(random);
    if (truth.isUnion() || i % 7 == 0) time = std::round(time);
    points.push_back(truth.placement(time) * x);
  }
  return points;
}

/// Tests that a conservative envelope contains the sweep, and that its reported bound is right.
/// solid: the closed body for the comparison.
void expectContained(const std::string& name, const TriMesh& body, const TriMesh& solid,
                     const Trajectory& motion, const Options& options, int points) {
  SCOPED_TRACE(name);
  const Result result = conservative(body, motion, options);
  if (result.mesh.triangles.empty()) return;
  const double cell = result.report.cellSize, bound = result.report.conservativeBound.value();
  EXPECT_GT(bound, 0);
  EXPECT_LE(bound, 3 * cell + options.tolerance);
  std::mt19937 random(7);
  const SweptDistance truth(solid, motion, 0.02 * cell);
  RunContext run;
  int outside = 0;
  for (const double d : distanceToMesh(sweepPoints(truth, points, random), result.mesh, run)) {
    outside += d >= 0;
  }
  EXPECT_EQ(outside, 0);
  double most = 0;
  const std::size_t stride = 1 + result.mesh.vertices.size() / 200;
  for (std::size_t v = 0; v < result.mesh.vertices.size(); v += stride) {
    const double distance = truth.distance(result.mesh.vertices[v]);
    EXPECT_GT(distance, options.offset - 1e-9);
    most = std::max(most, distance - options.offset);
  }
  EXPECT_LE(most, bound * (1 + 1e-9));
  std::printf("%s: bound %.3f cells, measured %.3f cells\n", name.c_str(), bound / cell,
              most / cell);
}

void expectContained(const std::string& name, const TriMesh& body, const Trajectory& motion,
                     const Options& options, int points) {
  expectContained(name, body, body, motion, options, points);
}

TEST(Conservative, HoldsRandomSweeps) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    const TriMesh body = randomBody(random);
    Trajectory motion = randomMotion(random);
    if (motion.interpolation == Interpolation::Screw) motion.interpolation = Interpolation::Linear;
    Options options;
    options.resolution = 40;
    expectContained("seed " + std::to_string(seed), body, motion, options, 2000);
  }
}

TEST(Conservative, HoldsSharedPartsInMotion) {
  const std::string data = SWEPT_SHARED_DATA;
  struct Case {
    const char *mesh, *motion;
    double meshUnit, motionUnit;
  };
  for (const Case& c :
       {Case{"tooth_crown_4k.ply", "keyposes_16_arc_for_fandisk.csv", 1, 5},
        Case{"fandisk_13k.ply", "keyposes_16_arc_for_fandisk.csv", 1000, 1000},
        Case{"differential_pinion_15k.ply", "installation_34_from_baxter_left.csv", 1, 100}}) {
    const std::string mesh = data + "/meshes/" + c.mesh;
    if (!std::filesystem::exists(mesh)) GTEST_SKIP() << "shared test data not found: " << mesh;
    Options options;
    options.resolution = 64;
    expectContained(
        c.mesh, readMesh(mesh, c.meshUnit),
        readTrajectoryCsv(data + "/motions/" + c.motion, c.motionUnit, Interpolation::Linear),
        options, 2000);
  }
}

TEST(Conservative, HoldsWhatNoGridEdgeMeets) {
  // A needle and a plate, a hundredth of a cell thick: the plain envelope loses them.
  TriMesh body = makeBox({0, 0, 0}, {4, 4, 4});
  append(body,
         transformed(makeBox({4, 2, 2}, {9, 2.002, 2.002}), placement({1, 1, 0}, 2, {0, 0, 0})));
  append(body, makeBox({-3, 1, 1.531}, {0, 3, 1.533}));
  Options options;
  options.cellSize = 0.2;
  expectContained("needle", body, {{Pose{}}, Interpolation::None}, options, 2000);
  Pose end;
  end.timeSeconds = 1;
  end.translation = V3(1, 2, 0.5);
  expectContained("moving needle", body, {{Pose{}, end}, Interpolation::Linear}, options, 2000);
}

/// Appends a sheet of four corners with triangles on both sides. If it has a width, its rim is
/// closed.
void appendSheet(TriMesh& mesh, double width) {
  const V3 corners[] = {V3(4, 1, 2), V3(9, 1, 2.3), V3(9, 3, 2.9), V3(4, 3, 2.1)};
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  const std::int32_t other = first + (width > 0 ? 4 : 0);
  for (const V3& v : corners) mesh.vertices.push_back(v);
  for (const auto& [a, b] : {std::pair{1, 2}, {2, 3}}) {
    mesh.triangles.push_back({first, first + a, first + b});
    mesh.triangles.push_back({other, other + b, other + a});
  }
  if (width <= 0) return;
  for (const V3& v : corners) mesh.vertices.push_back(v - V3(0, 0, width));
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    mesh.triangles.push_back({first + next, first + k, other + k});
    mesh.triangles.push_back({first + next, other + k, other + next});
  }
}

TEST(Conservative, HoldsSheetsModelledFromBothSides) {
  // Runs for envelopes that are not conservative remove such sheets, since they enclose nothing.
  TriMesh body = makeBox({0, 0, 0}, {4, 4, 4}), solid = body;
  appendSheet(body, 0);
  appendSheet(solid, 1e-7);
  Options options;
  options.cellSize = 0.2;
  expectContained("sheet", body, solid, {{Pose{}}, Interpolation::None}, options, 2000);
  Pose end;
  end.timeSeconds = 1;
  end.translation = V3(1, 2, 0.5);
  expectContained("moving sheet", body, solid, {{Pose{}, end}, Interpolation::Linear}, options,
                  2000);
}

TEST(Conservative, HoldsAfterSimplification) {
  std::mt19937 random(5);
  const TriMesh body = randomBody(random);
  Trajectory motion = randomMotion(random);
  motion.interpolation = Interpolation::Linear;
  Options options;
  options.resolution = 48;
  const Result plain = conservative(body, motion, options);
  options.tolerance = 0.5 * plain.report.cellSize;
  expectContained("simplified", body, motion, options, 2000);
  const Result simple = conservative(body, motion, options);
  EXPECT_LT(simple.mesh.triangles.size(), plain.mesh.triangles.size() / 2);
}

TEST(Conservative, HoldsTheSafetyDistanceToo) {
  const TriMesh body = makeCylinder(2, -1, 3, 24);
  Pose end;
  end.timeSeconds = 1;
  end.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(1.5, V3(1, 0.2, 0).normalized()));
  Options options;
  options.cellSize = 0.15;
  options.offset = 0.5;
  expectContained("with offset", body, {{Pose{}, end}, Interpolation::Linear}, options, 2000);
}

TEST(Conservative, LongEdgesOfFewTrianglesInATurn) {
  // Side patches of long edges are twisted most, and the faces graze the envelope while they turn.
  const TriMesh bar = makeBox({-20, -0.5, -0.5}, {20, 0.5, 0.5});
  Pose end;
  end.timeSeconds = 1;
  end.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(2.2, V3(1, 1, 1).normalized()));
  end.translation = V3(30, 0, 10);
  Options options;
  options.resolution = 64;
  options.chordTolerance = 0.45;  // half a cell
  expectContained("bar", bar, {{Pose{}, end}, Interpolation::Linear}, options, 2000);
}

}  // namespace
}  // namespace swept::test
