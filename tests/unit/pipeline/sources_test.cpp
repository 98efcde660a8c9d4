// The recorded source of each triangle of an envelope agrees with the body and the motion, and
// recording it changes nothing else.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "support/random_case.h"
#include "support/shapes.h"
#include "support/source_check.h"
#include "swept/compute.h"
#include "swept/preview.h"

namespace swept::test {
namespace {

/// Limits of the error of a source point, in cells. kOff: the usual limit, since crossings keep
/// this distance from lattice points. kMaxOff: the limit where an edge slides along itself and the
/// core finds no exact crossing. kShareOff: largest fraction of triangles with an error above kOff.
constexpr double kOff = 1e-3, kMaxOff = 0.25, kShareOff = 0.01;

Trajectory turningMotion(Interpolation interpolation) {
  Trajectory motion;
  motion.interpolation = interpolation;
  motion.poses = {poseOf(0, placement({1, 0, 0}, 0, {0, 0, 0})),
                  poseOf(1.5, placement({1, 2, 3}, 25, {14, 3, 5})),
                  poseOf(2, placement({2, -1, 1}, 55, {22, 16, 2}))};
  return motion;
}

/// Returns a prism whose faces are the two ends (1 and 2) and the mantle (0).
TriMesh cylinderWithFaces(int sides) {
  TriMesh body = makeCylinder(6, -8, 8, sides);
  for (const auto& t : body.triangles) {
    const double low = std::max(
                     {body.vertices[t[0]].z(), body.vertices[t[1]].z(), body.vertices[t[2]].z()}),
                 high = std::min(
                     {body.vertices[t[0]].z(), body.vertices[t[1]].z(), body.vertices[t[2]].z()});
    body.faceOf.push_back(low == high ? (low > 0 ? 2 : 1) : 0);
  }
  return body;
}

TriMesh boxWithFaces() {
  TriMesh body = makeBox({0, 0, 0}, {10, 20, 30});
  for (std::int32_t t = 0; t < 12; ++t) {
    const auto& tri = body.triangles[t];
    const Eigen::Vector3d normal = (body.vertices[tri[1]] - body.vertices[tri[0]])
                                       .cross(body.vertices[tri[2]] - body.vertices[tri[0]])
                                       .normalized();
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    body.faceOf.push_back(2 * axis + (normal[axis] > 0 ? 1 : 0));
  }
  return body;
}

Result sweep(const TriMesh& body, const Trajectory& motion, bool sources, double tolerance = 0) {
  Options options;
  options.resolution = 48;
  options.sources = sources;
  options.tolerance = tolerance;
  RunContext run;
  return compute(body, motion, options, run);
}

/// Tests that the mesh has the same bytes as in a run without sources, that all sources are right,
/// and that few are missing.
void expectRightSources(const TriMesh& body, const Trajectory& motion, const std::string& what) {
  const Result plain = sweep(body, motion, false), result = sweep(body, motion, true);
  ASSERT_EQ(result.report.status, plain.report.status) << what << result.report.message;
  EXPECT_EQ(result.mesh.vertices, plain.mesh.vertices) << what;
  EXPECT_EQ(result.mesh.triangles, plain.mesh.triangles) << what;
  EXPECT_EQ(result.contactTime, plain.contactTime) << what;
  EXPECT_TRUE(plain.sources.of.empty() && !plain.sources.rows);
  if (result.report.status != Status::Ok) return;
  ASSERT_EQ(result.sources.of.size(), result.mesh.triangles.size());
  std::vector<double> off = sourceDistances(body, motion, result.sources);
  const auto known = std::remove(off.begin(), off.end(), -1.0);
  EXPECT_LT(off.end() - known, 1 + static_cast<std::ptrdiff_t>(off.size() / 50)) << what;
  off.erase(known, off.end());
  std::sort(off.begin(), off.end());
  const double cell = result.report.cellSize;
  EXPECT_LT(off.back(), kMaxOff * cell) << what;
  EXPECT_LT(off[static_cast<std::size_t>((1 - kShareOff) * static_cast<double>(off.size()))],
            kOff * cell)
      << what;
  EXPECT_LT(off[off.size() / 2], 1e-6 * cell) << what;
}

TEST(Sources, NamedFacesEdgesAndTimesAreTrue) {
  for (const Interpolation kind :
       {Interpolation::None, Interpolation::Linear, Interpolation::Screw}) {
    expectRightSources(boxWithFaces(), turningMotion(kind), "box ");
    expectRightSources(cylinderWithFaces(32), turningMotion(kind), "cylinder ");
  }
  Trajectory aboutMiddle = turningMotion(Interpolation::Linear);
  aboutMiddle.pivot = {5, 10, 15};
  expectRightSources(boxWithFaces(), aboutMiddle, "pivot ");
}

TEST(Sources, TrianglesOfRandomBodiesAreTrue) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const TriMesh body = randomBody(random);
    expectRightSources(body, randomMotion(random), "seed " + std::to_string(seed) + " ");
  }
}

TEST(Sources, FaultsAreSeenByTheChecker) {
  const TriMesh body = boxWithFaces();
  const Trajectory motion = turningMotion(Interpolation::Linear);
  const Result result = sweep(body, motion, true);
  const double cell = result.report.cellSize;
  const auto wrongShare = [&](const auto& spoil) {
    auto rows = std::make_shared<std::vector<SurfaceSource>>(*result.sources.rows);
    for (SurfaceSource& row : *rows) spoil(row);
    const Sources spoiled{result.sources.of, rows};
    std::int64_t wrong = 0;
    for (const double off : sourceDistances(body, motion, spoiled)) wrong += off > kOff * cell;
    return static_cast<double>(wrong) / static_cast<double>(spoiled.of.size());
  };
  EXPECT_LT(wrongShare([](SurfaceSource&) {}), kShareOff);
  EXPECT_GT(wrongShare([](SurfaceSource& row) { row.faces[0] = (row.faces[0] + 1) % 6; }), 0.9);
  EXPECT_GT(wrongShare([](SurfaceSource& row) { row.step = (row.step + 1) % 3; }), 0.9);
  EXPECT_GT(wrongShare([](SurfaceSource& row) { row.timeSeconds += 0.02; }), 0.9);
  EXPECT_GT(wrongShare([&](SurfaceSource& row) { row.point.y() += 0.1 * cell; }), 0.5);
  EXPECT_GT(wrongShare([](SurfaceSource& row) {
              row.kind = row.kind == SourceKind::Cap ? SourceKind::Edge : SourceKind::Cap;
            }),
            0.9);
}

std::array<std::int64_t, 3> kindsOf(const Result& result) {
  std::array<std::int64_t, 3> count{};
  for (const std::uint32_t of : result.sources.of) {
    if (of != Sources::kNone) ++count[static_cast<std::size_t>((*result.sources.rows)[of].kind)];
  }
  return count;
}

TEST(Sources, KindsSayHowAFaceOrEdgePassed) {
  Trajectory along;
  along.poses = {poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
                 poseOf(1, placement({0, 0, 1}, 0, {0, 0, 30}))};
  // A cylinder along its axis: its mantle slides along itself, its ends are caps.
  const Result slid = sweep(cylinderWithFaces(64), along, true);
  EXPECT_EQ(kindsOf(slid)[1], 0);
  EXPECT_GT(kindsOf(slid)[2], 0);
  for (std::size_t t = 0; t < slid.sources.of.size(); ++t) {
    if (slid.sources.of[t] == Sources::kNone) continue;
    const SurfaceSource& row = (*slid.sources.rows)[slid.sources.of[t]];
    if (row.kind != SourceKind::Cap || row.faces[0] == 0) continue;
    EXPECT_EQ(row.faces[0], row.step == 0 ? 1 : 2);
  }
  // A box along a space diagonal: half of its faces are caps at each end, and edges sweep the rest.
  Trajectory diagonal = along;
  diagonal.poses[1].translation = {30, 30, 30};
  const auto box = kindsOf(sweep(boxWithFaces(), diagonal, true));
  EXPECT_GT(box[0], 0);
  EXPECT_GT(box[1], 0);
  EXPECT_EQ(box[2], 0);
  // A cylinder across its axis: its mantle grazes the envelope. In a mesh without faces, its 64
  // sides count as smooth too.
  Trajectory across = along;
  across.poses[1].translation = {30, 0, 0};
  for (const bool named : {true, false}) {
    TriMesh body = cylinderWithFaces(64);
    if (!named) body.faceOf.clear();
    const auto round = kindsOf(sweep(body, across, true));
    EXPECT_GT(round[0], 0);
    EXPECT_GT(round[2], 0);
  }
}

TEST(Sources, NumbersAreThoseOfWhatWasGiven) {
  // The input has triangles with separate corners, a triangle without area and a duplicate at the
  // beginning, and a repeated pose.
  TriMesh body = boxWithFaces();
  TriMesh given = body;
  given.triangles.insert(given.triangles.begin(), {{0, 1, 1}, body.triangles[3]});
  given.faceOf.insert(given.faceOf.begin(), {5, body.faceOf[3]});
  const std::vector<std::int32_t> faceOf = given.faceOf;
  given = soup(given);
  given.faceOf = faceOf;
  Trajectory motion = turningMotion(Interpolation::Linear);
  Pose again = motion.poses[1];
  again.timeSeconds = 1.75;
  motion.poses.insert(motion.poses.begin() + 2, again);
  motion.poses.push_back(poseOf(3, placement({0, 1, 0}, 80, {30, 20, 10})));
  expectRightSources(given, motion, "faces ");
  given.faceOf.clear();
  expectRightSources(given, motion, "triangles ");
  const Result result = sweep(given, motion, true);
  std::int32_t last = 0;
  for (const SurfaceSource& row : *result.sources.rows) {
    EXPECT_NE(row.step, 2);  // the pose that was left out
    last = std::max(last, row.step);
  }
  EXPECT_EQ(last, 4);
}

TEST(Sources, SimplifiedTrianglesHaveWhatMadeMostOfThem) {
  const TriMesh body = boxWithFaces();
  const Trajectory motion = turningMotion(Interpolation::Linear);
  Result result = sweep(body, motion, true, 0.2);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  const auto expectNear = [&] {
    const double cell = result.report.cellSize;
    ASSERT_EQ(result.sources.of.size(), result.mesh.triangles.size());
    std::int64_t known = 0;
    const std::vector<double> off = sourceDistances(body, motion, result.sources);
    for (std::size_t t = 0; t < off.size(); ++t) {
      if (off[t] < 0) continue;
      ++known;
      EXPECT_LT(off[t], kMaxOff * cell);
      // The point lies on the triangle or beside it.
      const auto& tri = result.mesh.triangles[t];
      Eigen::AlignedBox3d box;
      for (const std::int32_t v : tri) box.extend(result.mesh.vertices[v]);
      const double limit = 0.2 + 2 * cell;
      EXPECT_LT(box.exteriorDistance((*result.sources.rows)[result.sources.of[t]].point), limit);
    }
    EXPECT_GT(known, static_cast<std::int64_t>(0.97 * static_cast<double>(off.size())));
  };
  expectNear();
  const std::size_t fine = result.mesh.triangles.size();
  RunContext run;
  recut(result, 0.6, run);
  EXPECT_LT(result.mesh.triangles.size(), fine);
  expectNear();
  recut(result, 0, run);
  EXPECT_GT(result.mesh.triangles.size(), fine);
  expectNear();
}

TEST(Sources, PreviewsHaveThemToo) {
  Options options;
  options.resolution = 32;
  options.sources = true;
  RunContext run;
  const TriMesh body = cylinderWithFaces(24);
  PreviewSession session(body, options, run);
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    const Trajectory motion = turningMotion(kind);
    const Result result = session.sketch(motion, run);
    ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
    ASSERT_EQ(result.sources.of.size(), result.mesh.triangles.size());
    for (const double off : sourceDistances(body, motion, result.sources))
      EXPECT_LT(off, kMaxOff * result.report.cellSize);
  }
}

TEST(Sources, AreRefusedWhereNothingIsKnown) {
  Options options;
  options.sources = true;
  options.resolution = 32;
  const auto codeOf = [](const TriMesh& body, const Options& with) {
    RunContext run;
    return compute(body, turningMotion(Interpolation::Linear), with, run).report.code;
  };
  Options grown = options, certain = options;
  grown.offset = 1;
  certain.conservative = true;
  EXPECT_EQ(codeOf(boxWithFaces(), grown), "BadOption");
  EXPECT_EQ(codeOf(boxWithFaces(), certain), "BadOption");
  TriMesh few = boxWithFaces(), negative = boxWithFaces();
  few.faceOf.pop_back();
  negative.faceOf[3] = -2;
  EXPECT_EQ(codeOf(few, options), "BadFaces");
  EXPECT_EQ(codeOf(negative, options), "BadFaces");
  options.sources = false;
  EXPECT_EQ(codeOf(few, options), "");  // without sources, the faces are not used
}

}  // namespace
}  // namespace swept::test
