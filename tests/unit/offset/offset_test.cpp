// Envelopes grown by a safety distance, against the exact distance to the body.
// Limits of the distance, as for envelopes: 1 cell everywhere, 0.25 cell at creases; most points
// are within 0.01 cell.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>

#include "support/checked_compute.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"
#include "support/swept_distance.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;
constexpr double kPi = 3.14159265358979323846;

Trajectory still() { return {{Pose{}}, Interpolation::None}; }

Trajectory straight(const V3& travel) {
  Pose end;
  end.timeSeconds = 1;
  end.translation = travel;
  return {{Pose{}, end}, Interpolation::Linear};
}

Trajectory turning() {
  Pose end;
  end.timeSeconds = 2;
  end.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(1.2, V3(1, 2, 3).normalized()));
  end.translation = V3(2, 5, -3);
  return {{Pose{}, end}, Interpolation::Linear};
}

Result grown(const TriMesh& body, const Trajectory& motion, double offset, double cell) {
  Options options;
  options.cellSize = cell;
  options.offset = offset;
  Result result = checkedCompute(body, motion, options);
  EXPECT_EQ(result.report.check.selfIntersections, 0);
  return result;
}

struct Deviation {
  double mean = 0, p95 = 0, most = 0;  // cells
};

/// Returns how far vertices and middles of triangles lie from the surface at the distance d of the
/// body.
Deviation deviation(const Result& result, double d,
                    const std::function<double(const V3&)>& distance, std::size_t samples = 20000) {
  const TriMesh& mesh = result.mesh;
  std::vector<double> all;
  const auto add = [&](const V3& x) {
    all.push_back(std::abs(distance(x) - d) / result.report.cellSize);
  };
  const std::size_t stride = 1 + mesh.triangles.size() / samples;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += stride) {
    const auto& c = mesh.triangles[t];
    add(mesh.vertices[c[0]]);
    add((mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3);
  }
  std::sort(all.begin(), all.end());
  Deviation out;
  for (const double v : all) out.mean += v / static_cast<double>(all.size());
  out.p95 = all[all.size() * 95 / 100];
  out.most = all.back();
  return out;
}

/// Tests an offset of at least half a cell. Its vertices lie at the distance d, up to the chord
/// error of the motion. They are never nearer, and a little farther only where the surface is
/// round. The few vertices whose move would make triangles intersect stay where contouring has put
/// them.
void expectVerticesAt(const Result& result, double d,
                      const std::function<double(const V3&)>& distance, double chord = 0) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  const std::size_t stride = 1 + result.mesh.vertices.size() / 40000;
  std::size_t tested = 0, longer = 0;
  for (std::size_t v = 0; v < result.mesh.vertices.size(); v += stride, ++tested) {
    const double off = (distance(result.mesh.vertices[v]) - d) / result.report.cellSize;
    least = std::min(least, off);
    most = std::max(most, off);
    longer += off > 0.081 + chord ? 1 : 0;
  }
  EXPECT_GT(least, -0.003 - chord);
  EXPECT_LT(most, 0.25);
  EXPECT_LE(1000 * longer, tested);
}

/// Returns the largest distance from the result of points that lie d above the faces of the body
/// and belong to the offset. It shows a missing part, or a crease that was cut off.
double missing(const Result& result, const TriMesh& body, const MeshDistance& distance, double d) {
  const MeshDistance found(result.mesh);
  double most = 0;
  const std::size_t stride = 1 + body.triangles.size() / 5000;
  for (std::size_t t = 0; t < body.triangles.size(); t += stride) {
    const auto& c = body.triangles[t];
    const V3 n = distance.normal(static_cast<std::int32_t>(t));
    for (const auto& [u, v] : {std::pair{0.33, 0.33}, {0.98, 0.01}, {0.01, 0.98}, {0.01, 0.01}}) {
      const V3 p = body.vertices[c[0]] + u * (body.vertices[c[1]] - body.vertices[c[0]]) +
                   v * (body.vertices[c[2]] - body.vertices[c[0]]) + d * n;
      if (distance.distance(p) < d * (1 - 1e-9)) continue;
      most = std::max(most, found.distance(p) / result.report.cellSize);
    }
  }
  return most;
}

void expectStill(const std::string& name, const TriMesh& body, double size) {
  const MeshDistance distance(body);
  const double cell = size / 90;
  for (const double cells : {0.4, 1.5, 7.0}) {
    const double d = cells * cell;
    const Result result = grown(body, still(), d, cell);
    if (result.mesh.triangles.empty()) continue;
    const Deviation out = deviation(result, d, [&](const V3& x) { return distance.distance(x); });
    if (cells > 0.5) expectVerticesAt(result, d, [&](const V3& x) { return distance.distance(x); });
    const double back = missing(result, body, distance, d);
    std::printf(
        "%s grown by %.1f cells: out to truth mean %.4f p95 %.4f max %.4f, truth to out %.4f\n",
        name.c_str(), cells, out.mean, out.p95, out.most, back);
    EXPECT_LT(out.mean, 0.01) << name;
    EXPECT_LT(out.p95, 0.05) << name;
    // An edge that is rounded by less than a cell may come out sharp, and then lies up to d too far
    // away.
    EXPECT_LT(out.most, cells < 1 ? cells : 0.25) << name;
    EXPECT_LT(back, 0.25) << name;
  }
}

TEST(Offset, StillBodies) {
  const Eigen::Isometry3d oblique = placement({3, -2, 5}, 37.3, {11.7, -3.1, 0.9});
  expectStill("box", transformed(makeBox({0, 0, 0}, {10, 6, 3}), oblique), 10);
  expectStill("box along the axes", makeBox({0, 0, 0}, {10, 6, 3}), 10);
  expectStill("ball", makeBall({1, 2, 3}, 5, 4), 10);
  expectStill("torus", transformed(makeTorus(8, 2, 96, 32), oblique), 20);
}

TEST(Offset, StillFandisk) {
  const std::string path = std::string(SWEPT_SHARED_DATA) + "/meshes/fandisk_13k.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "shared test data not found: " << path;
  expectStill("fandisk", readMesh(path, 1000), 2000);
}

/// The valleys between these balls have bottoms that are narrower than a cell.
TEST(Offset, NothingIsShortBetweenBalls) {
  TriMesh heap;
  for (int n = 0; n < 40; ++n) {
    const double a = 2.4 * n;
    append(heap, makeBall({0.09 * n * std::cos(a), 0.09 * n * std::sin(a), 0.5 * std::sin(7 * a)},
                          0.6 + 0.2 * std::sin(3 * a), 2));
  }
  const double cell = 0.1;
  const MeshDistance distance(heap);
  for (const double d : {0.06, 0.1, 0.23}) {
    const Result result = grown(heap, still(), d, cell);
    expectVerticesAt(result, d, [&](const V3& x) { return distance.distance(x); });
  }
}

TEST(Offset, BoxHasTheVolumeOfItsRoundedBox) {
  const double a = 10, b = 6, c = 3;
  for (const double d : {1e-13, 1e-10, 1e-7, 1e-4, 0.05, 0.3, 2.0}) {
    const Result result = grown(makeBox({0, 0, 0}, {a, b, c}), still(), d, 0.1);
    const double exact = a * b * c + 2 * d * (a * b + b * c + c * a) + kPi * d * d * (a + b + c) +
                         4.0 / 3 * kPi * d * d * d;
    EXPECT_NEAR(result.report.check.volume / exact, 1, 1e-3) << d;
  }
}

TEST(Offset, ThinPlateHasTwoSidesAndARim) {
  const double cell = 0.1, t = 0.01, d = 0.03;  // a tenth and three tenths of a cell
  const Result result =
      grown(transformed(makeBox({0, 0, 0}, {5, 4, t}), placement({1, 2, 3}, 20, {0, 0, 0})),
            still(), d, cell);
  const double exact = 5 * 4 * t + 2 * d * (20 + 4 * t + 5 * t) + kPi * d * d * (9 + t);
  EXPECT_NEAR(result.report.check.volume / exact, 1, 0.05);
}

TEST(Offset, GapsAreAsWideAsTheyShouldBe) {
  const double cell = 0.1, d = 0.5;
  const auto plates = [&](double gap) {
    TriMesh body = makeBox({0, 0, 0}, {5, 5, 1});
    append(body, makeBox({0, 0, 1 + gap}, {5, 5, 2 + gap}));
    return body;
  };
  // A gap of two cells stays open: two shells, each at the right distance from its plate.
  const TriMesh open = plates(2 * d + 2 * cell);
  const Result apart = grown(open, still(), d, cell);
  EXPECT_EQ(apart.report.check.shells, 2);
  const MeshDistance distance(open);
  const Deviation out = deviation(apart, d, [&](const V3& x) { return distance.distance(x); });
  EXPECT_LT(out.most, 0.25);
  // A gap narrower than twice the distance closes, and nothing is left between the plates.
  const Result closed = grown(plates(2 * d - cell), still(), d, cell);
  EXPECT_EQ(closed.report.check.shells, 1);
  EXPECT_EQ(grown(plates(2 * d + 2 * cell), straight({0.01, 0, 0}), d, cell).report.check.shells,
            2);
}

TEST(Offset, BallOnALineIsALargerCapsule) {
  const double r = 3, d = 1, length = 12;
  const TriMesh ball = makeBall({0, 0, 0}, r, 5);
  const Result result = grown(ball, straight({length, 0, 0}), d, 0.2);
  const double big = r + d, exact = kPi * big * big * length + 4.0 / 3 * kPi * big * big * big;
  EXPECT_NEAR(result.report.check.volume / exact, 1, 2e-3);
  ASSERT_EQ(result.contactTime.size(), result.mesh.vertices.size());
  for (std::size_t v = 0; v < result.mesh.vertices.size(); ++v) {
    const double x = result.mesh.vertices[v].x();
    if (x < -0.5 || x > length + 0.5) continue;
    EXPECT_NEAR(result.contactTime[v] * length, x, 0.6);
  }
}

TEST(Offset, TurningBoxAgreesWithTheDistanceOverTime) {
  const TriMesh box = makeBox({1, -2, -1}, {6, 2, 1});
  const Trajectory motion = turning();
  const double cell = 0.1;
  const SweptDistance truth(box, motion, 0.01 * cell);
  for (const double d : {0.15, 0.8}) {
    const Result result = grown(box, motion, d, cell);
    const Deviation out = deviation(
        result, d, [&](const V3& x) { return truth.distance(x); }, 500);
    std::printf("turning box grown by %.1f cells: mean %.4f p95 %.4f max %.4f\n", d / cell,
                out.mean, out.p95, out.most);
    EXPECT_LT(out.mean, 0.01);
    EXPECT_LT(out.most, 0.25);
    expectVerticesAt(
        result, d, [&](const V3& x) { return truth.distance(x); }, 0.02);
  }
}

TEST(Offset, OfAsLittleAsNothingKeepsTheSweptVolume) {
  const TriMesh box =
      transformed(makeBox({1, -2, -1}, {6, 2, 1}), placement({1, 2, 3}, 20, {0, 0, 0}));
  const double cell = 0.1;
  for (const Trajectory& motion : {still(), straight({3.01, 4.02, 5.03}), turning()}) {
    const Result plain = grown(box, motion, 0, cell);
    const SweptDistance truth(box, motion, 0.01 * cell);
    for (const double cells : {1e-9, 1e-5, 1e-3, 0.01, 0.03, 0.1, 0.3}) {
      const double d = cells * cell;
      const Result result = grown(box, motion, d, cell);
      const Deviation out = deviation(
          result, d, [&](const V3& x) { return truth.distance(x); }, 500);
      const double more = result.report.check.volume - plain.report.check.volume;
      std::printf("grown by %g cells: mean %.4f max %.4f, volume %+.5f\n", cells, out.mean,
                  out.most, more);
      EXPECT_LT(out.mean, 0.02) << cells;
      EXPECT_LT(out.most, 0.25) << cells;
      EXPECT_NEAR(more / (plain.report.check.area * cell), cells, 0.02) << cells;
    }
  }
}

TEST(Offset, ManyCopiesAreMeasuredFromTheEnvelope) {
  // Above the limit of copies, the envelope is computed first, and its deviation adds to the
  // error.
  const TriMesh ball = makeBall({0, 0, 0}, 3, 4);  // 5120 triangles
  Trajectory motion{{}, Interpolation::None};
  for (int i = 0; i < 1600; ++i) {
    Pose pose;
    pose.timeSeconds = i;
    pose.translation = 0.1 * V3(std::sin(i * 0.7), std::cos(i * 1.3), std::sin(i * 2.1));
    motion.poses.push_back(pose);
  }
  const double cell = 0.1, d = 0.4;
  const Result result = grown(ball, motion, d, cell);
  const Deviation out = deviation(
      result, d,
      [&](const V3& x) {
        double least = 1e300;
        for (const Pose& p : motion.poses) least = std::min(least, (x - p.translation).norm() - 3);
        return least;
      },
      4000);
  EXPECT_LT(out.most, 0.25);
}

TEST(Offset, SameBytesForAnyNumberOfThreads) {
  const TriMesh body = makeTorus(8, 2, 48, 16);
  Options options;
  options.resolution = 48;
  options.offset = 0.7;
  Result first;
  for (const int threads : {1, 3}) {
    RunContext run;
    run.threads = threads;
    Result result = compute(body, straight({3, 4, 5}), options, run);
    ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
    if (threads == 1) {
      first = std::move(result);
    } else {
      EXPECT_EQ(result.mesh.vertices, first.mesh.vertices);
      EXPECT_EQ(result.mesh.triangles, first.mesh.triangles);
      EXPECT_EQ(result.contactTime, first.contactTime);
    }
  }
}

}  // namespace
}  // namespace swept::test
