// Solids whose faces come from the faces and edges of the body: a body from a STEP file that moves
// along straight lines, turns about a fixed axis, or moves and turns at the same time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "judge/solid_judge.h"
#include "solid/test_meshes.h"
#include "support/temporary_folder.h"
#include "swept/body.h"
#include "swept/compute.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace test;
using Eigen::Vector3d;

constexpr double kRadius = 5, kLength = 16;

class BodySolid : public testing::Test {
 protected:
  // Makes a STEP file of the mesh, and reads it as a body with faces.
  void readBodyOf(const TriMesh& mesh) {
    const std::string file = folder_.file("body.step");
    writeSolid(mesh, file, {}, run_);
    readBodyFrom(file);
  }

  void readBodyFrom(const std::string& file) {
    BodyFileOptions files;
    files.resolution = 96;
    body_ = readBody(file, files, run_);
    ASSERT_NE(body_.shape, nullptr);
  }

  void sweep(const std::vector<Vector3d>& positions, const Eigen::Quaterniond& lastTurn) {
    std::vector<Eigen::Quaterniond> turns(positions.size(), none_);
    turns.back() = lastTurn;
    moveThrough(positions, turns);
  }

  // `positions`: how far the pivot has moved.
  void moveThrough(const std::vector<Vector3d>& positions,
                   const std::vector<Eigen::Quaterniond>& turns) {
    motion_ = {};
    for (std::size_t i = 0; i < positions.size(); ++i) {
      Pose& pose = motion_.poses.emplace_back();
      pose.timeSeconds = static_cast<double>(i);
      pose.rotation = turns[i];
      pose.translation = positions[i] + pivot_ - pose.rotation * pivot_;
    }
    motion_.pivot = pivot_;
    compute();
  }

  // Three keys, turned by 25 and 41 degrees.
  void turnSomewhat() {
    moveThrough({{0, 0, 0}, {20, 3, 6}, {30, 20, 4}},
                {none_, turned(0.436, {3, 5, 8}), turned(0.716, {-2, 7, 4})});
  }

  // Three keys, turned by 60 and 100 degrees.
  void turnFar() {
    moveThrough({{0, 0, 0}, {4, 9, 31}, {-10, 25, 40}},
                {none_, turned(1.047, {1, -2, 1}), turned(1.745, {1, 1, -2})});
  }

  void compute() {
    Options options;
    options.resolution = resolution_;
    result_ = swept::compute(body_.mesh, motion_, options, run_);
    ASSERT_EQ(result_.report.status, Status::Ok) << result_.report.message;
  }

  static Eigen::Quaterniond turned(double angle, const Vector3d& axis) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
  }

  SolidOptions optionsWithOrigin() const {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : result_.mesh.vertices) box.extend(p);
    SolidOptions options;
    options.tolerance = 1e-3 * box.diagonal().norm();
    options.origin = std::make_shared<const SolidOrigin>(SolidOrigin{motion_, body_.shape});
    return options;
  }

  WrittenSolid write(const SolidOptions& options) {
    const std::string file = folder_.file("envelope.step");
    const WrittenSolid report = writeSolid(result_.mesh, file, options, run_);
    judged_ = judgeSolid(readShape(file), 9, true);
    kinds_.clear();
    for (const auto& [kind, count] : report.facesByKind) kinds_[kind] = count;
    return report;
  }

  // Tests that the solid has the exact volume, as with exact faces. No mesh has this volume.
  void expectExact(double volume) {
    const SolidOptions options = optionsWithOrigin();
    const WrittenSolid report = write(options);
    EXPECT_EQ(kinds_["facet"], 0);
    EXPECT_NEAR(report.volume, volume, 1e-6 * volume);
    EXPECT_LE(report.deviation, 0.01);
    EXPECT_TRUE(judged_.valid);
    EXPECT_TRUE(judged_.faults.empty()) << (judged_.details.empty() ? "" : judged_.details.front());
    EXPECT_LE(judged_.blockError, 1e-6);
    EXPECT_LE(report.edgeTolerance, options.tolerance);
  }

  // The deviation is that of the chords that replace the motion.
  void expectFacesOfTheSweep() {
    const WrittenSolid report = write(optionsWithOrigin());
    EXPECT_EQ(kinds_["facet"], 0);
    EXPECT_LE(report.deviation, result_.report.chordError + 1e-3);
    EXPECT_TRUE(judged_.valid);
    EXPECT_TRUE(judged_.faults.empty()) << (judged_.details.empty() ? "" : judged_.details.front());
    EXPECT_LE(judged_.blockError, 1e-6);
  }

  // The judge would take minutes for faces that sweep as far as these.
  void expectFacesWithoutFacets(std::int64_t mostFaces) {
    const WrittenSolid report =
        writeSolid(result_.mesh, folder_.file("envelope.step"), optionsWithOrigin(), run_);
    std::int64_t faces = 0;
    for (const auto& [kind, count] : report.facesByKind) {
      EXPECT_NE(kind, "facet");
      faces += count;
    }
    EXPECT_LE(faces, mostFaces);
    EXPECT_LE(report.deviation, result_.report.chordError + 1e-3);
    EXPECT_NEAR(report.volume, report.meshVolume, 5e-3 * report.meshVolume);
  }

  // Does the same as expectFacesOfTheSweep(), and tests that all edges lie on their faces.
  void expectExactFaces() {
    expectFacesOfTheSweep();
    EXPECT_LE(judged_.edgeTolerance, 1e-6);
    EXPECT_NEAR(judged_.volume, meshVolume(result_.mesh), 1e-3 * judged_.volume);
  }

  const Eigen::Quaterniond none_ = Eigen::Quaterniond::Identity();
  int resolution_ = 96;
  Vector3d pivot_ = Vector3d::Zero();
  TemporaryFolder folder_;
  RunContext run_;
  Body body_;
  Trajectory motion_;
  Result result_;
  std::map<std::string, std::int64_t> kinds_;
  JudgedSolid judged_;
};

TEST_F(BodySolid, BoxAlongALine) {
  readBodyOf(boxMesh(12, 8, 5));
  const Vector3d travel(7, 4, 9);
  sweep({{0, 0, 0}, travel}, none_);
  expectExact(12 * 8 * 5 + 8 * 5 * travel.x() + 12 * 5 * travel.y() + 12 * 8 * travel.z());
  EXPECT_EQ(kinds_["plane"], 12);
}

TEST_F(BodySolid, TwoStepsOfOneLineMakeTheSameFaces) {
  readBodyOf(boxMesh(12, 8, 5));
  const Vector3d travel(7, 4, 9);
  sweep({{0, 0, 0}, 0.4 * travel, travel}, none_);
  expectExact(12 * 8 * 5 + 8 * 5 * travel.x() + 12 * 5 * travel.y() + 12 * 8 * travel.z());
  EXPECT_EQ(kinds_["plane"], 12);
}

TEST_F(BodySolid, RodAlongALine) {
  const std::string file = folder_.file("rod.brep");
  writeRod(kRadius, kLength, file);
  readBodyFrom(file);
  const Vector3d travel(9, 3, 11);
  sweep({{0, 0, 0}, travel}, none_);
  // The volume of the body, plus the area of its shadow times the length of the motion.
  expectExact(M_PI * kRadius * kRadius * (kLength + travel.z()) +
              2 * kRadius * kLength * std::hypot(travel.x(), travel.y()));
  // Each of two kinds has two faces. One may be cut where the cylinder of the body closes.
  EXPECT_LE(kinds_["cylinder"], 3);
  EXPECT_LE(kinds_["extrusion"], 3);
  EXPECT_EQ(kinds_["plane"], 4);
}

// Most faces are tangent to their neighbours, and what their contact curves sweep is tangent to
// them.
TEST_F(BodySolid, RoundedBlockAlongALine) {
  const std::string file = folder_.file("block.brep");
  writeRoundedBlock(file);
  readBodyFrom(file);
  sweep({{0, 0, 0}, {17, 9, 21}}, none_);
  const SolidOptions options = optionsWithOrigin();
  const WrittenSolid report = write(options);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_GT(kinds_["cylinder"], 0);
  EXPECT_GT(kinds_["sphere"], 0);
  EXPECT_LE(report.deviation, options.tolerance);
  EXPECT_LE(report.edgeTolerance, 1e-6);
  EXPECT_TRUE(judged_.valid);
  EXPECT_LE(judged_.blockError, 1e-6);
  // One edge is 2e-7 mm off its face, 1e-11 mm more than its B-rep tolerance.
  EXPECT_EQ(judged_.faults.count("SelfIntersect"), 0u);
  EXPECT_LE(judged_.faults.size(), 1u);
}

TEST_F(BodySolid, BoxAlongABrokenLine) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {14, 3, 2}, {16, 19, 11}}, none_);
  expectFacesOfTheSweep();
  EXPECT_EQ(kinds_["plane"], 18);
}

TEST_F(BodySolid, BoxThatTurnsAboutAnAxisBesideIt) {
  readBodyOf(boxMesh(12, 8, 5));
  pivot_ = {-20, -7, -6};
  sweep({{0, 0, 0}, {0, 0, 0}},
        Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized())));
  expectFacesOfTheSweep();
  EXPECT_EQ(kinds_["plane"] + kinds_["cone"] + kinds_["revolution"] + kinds_["cylinder"],
            judged_.faces);
}

TEST_F(BodySolid, BoxThatTurnsWhileItMoves) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {7, 4, 9}}, turned(0.4, {1, 2, 3}));
  expectExactFaces();
  EXPECT_EQ(kinds_["plane"], 6);
  EXPECT_EQ(kinds_["sheet"], judged_.faces - 6);
}

// Faces of the first step end at faces of the second one, and faces graze the envelope.
TEST_F(BodySolid, BoxAlongThreeKeysThatTurn) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {11, 4, 9}, {13, 19, 7}}, turned(0.9, {-1, 2, 1}));
  motion_.poses[1].rotation = turned(0.5, {1, 0.3, 2});
  compute();
  expectExactFaces();
  EXPECT_LE(judged_.faces, 35);
}

TEST_F(BodySolid, BodyWithAConcaveEdgeThatTurnsAboutAPivot) {
  readBodyOf(voxelMesh([](int x, int y, int) { return x < 4 || y < 3; }, 12, 9, 5, 1.0));
  pivot_ = {3, -2, 1};
  sweep({{0, 0, 0}, {3, 14, 6}}, turned(0.6, {2, -1, 1}));
  expectExactFaces();
}

TEST_F(BodySolid, BoxAlongAScrewWithARest) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {0, 0, 0}, {9, 3, 14}}, turned(0.7, {1, 2, 5}));
  motion_.interpolation = Interpolation::Screw;
  compute();
  expectExactFaces();
}

TEST_F(BodySolid, ConesAndToriOfATurningBody) {
  const std::string file = folder_.file("rod.brep");
  writeRodWithChamferAndFillet(kRadius, kLength, file);
  resolution_ = 48;
  readBodyFrom(file);
  sweep({{0, 0, 0}, {9, 13, 8}}, turned(0.6, {1, 2, 1}));
  expectExactFaces();
  EXPECT_GE(kinds_["cone"], 1);
  EXPECT_GE(kinds_["torus"], 1);
  EXPECT_LE(judged_.faces, 30);
}

// Where the path of a corner leaves a contact curve, two curves of intersection begin side by side.
TEST_F(BodySolid, ABlockWithRoundEdgesAlongThreeKeys) {
  const std::string file = folder_.file("block.brep");
  writeBlockWithRoundTop(20, 14, 8, 2, file);
  readBodyFrom(file);
  turnSomewhat();
  expectFacesWithoutFacets(60);
}

// What its bottom edge sweeps passes through itself.
TEST_F(BodySolid, AConeThatTurnsFarAlongThreeKeys) {
  const std::string file = folder_.file("cone.brep");
  writeCone(8, 3, 14, file);
  readBodyFrom(file);
  turnFar();
  expectFacesWithoutFacets(45);
}

// At some moments, whole circles of the pipe touch the envelope.
TEST_F(BodySolid, AnElbowThatTurnsFarAlongThreeKeys) {
  const std::string file = folder_.file("elbow.brep");
  writeElbow(15, 3, file);
  readBodyFrom(file);
  turnFar();
  expectFacesWithoutFacets(45);
}

// At the second key, faces of the first step and of the second are only 0.005 mm apart at the rim.
TEST_F(BodySolid, ASteppedRodAlongThreeKeys) {
  const std::string file = folder_.file("rod.brep");
  writeSteppedRod(12, 5, file);
  readBodyFrom(file);
  turnSomewhat();
  expectFacesWithoutFacets(60);
}

// The direction in which it moves turns by 136 degrees, seen from the body.
TEST_F(BodySolid, HalfABallThatTurnsFarAlongThreeKeys) {
  const std::string file = folder_.file("half.brep");
  writeHalfBall(9, file);
  readBodyFrom(file);
  turnFar();
  expectFacesWithoutFacets(35);
}

// Contact curves run all around the ball and the ring.
TEST_F(BodySolid, ABallThatTurnsAboutAPointOutsideOfIt) {
  const std::string file = folder_.file("ball.brep");
  writeBall(6, file);
  readBodyFrom(file);
  pivot_ = {11, 4, -3};
  sweep({{0, 0, 0}, {9, 13, 8}}, turned(0.6, {1, 2, 1}));
  expectExactFaces();
  EXPECT_GE(kinds_["sphere"], 2);
  EXPECT_LE(judged_.faces, 6);
}

TEST_F(BodySolid, ARingThatTurnsWhileItMoves) {
  const std::string file = folder_.file("ring.brep");
  writeRing(9, 3, file);
  readBodyFrom(file);
  sweep({{0, 0, 0}, {9, 13, 8}}, turned(0.6, {1, 2, 1}));
  expectExactFaces();
  EXPECT_GE(kinds_["torus"], 2);
  EXPECT_LE(judged_.faces, 20);
}

// It touches the envelope along two whole circles, and other contact curves cross them.
TEST_F(BodySolid, ARingThatMovesAcrossItsAxis) {
  const std::string file = folder_.file("ring.brep");
  writeRing(9, 3, file);
  readBodyFrom(file);
  for (const Vector3d& travel : {Vector3d(20, 0, 0), Vector3d(12, 16, 0)}) {
    sweep({{0, 0, 0}, travel}, none_);
    const WrittenSolid report = write(optionsWithOrigin());
    EXPECT_EQ(kinds_["facet"], 0);
    EXPECT_EQ(kinds_["torus"], 4);
    EXPECT_LE(judged_.faces, 12);
    EXPECT_LE(report.deviation, 2e-3);
    EXPECT_LE(report.edgeTolerance, 1e-6);
    EXPECT_TRUE(judged_.valid);
    EXPECT_LE(judged_.blockError, 1e-6);
    // The curve in which the inner surfaces meet is 1e-7 mm off one of them.
    EXPECT_EQ(judged_.faults.count("SelfIntersect"), 0u);
    EXPECT_LE(judged_.faults.size(), 1u);
  }
}

// The wall is neither a plane nor a surface of revolution: what it grazes becomes facets.
TEST_F(BodySolid, OtherSurfacesOfATurningBodyLeaveFacets) {
  const std::string file = folder_.file("rod.brep");
  writeEllipticRod(8, 5, kLength, file);
  readBodyFrom(file);
  sweep({{0, 0, 0}, {9, 13, 8}}, turned(0.6, {1, 2, 1}));
  const SolidOptions options = optionsWithOrigin();
  const WrittenSolid report = write(options);
  EXPECT_GE(kinds_["sheet"] + kinds_["extrusion"], 4);
  EXPECT_TRUE(judged_.valid);
  EXPECT_EQ(judged_.solids, 1);
  EXPECT_LE(judged_.blockError, 1e-6);
  EXPECT_LE(report.deviation, options.tolerance);
}

// Two surfaces of this sweep are nearly tangent along a curve that the program does not find.
TEST_F(BodySolid, AMissedSectionLeavesFewFacets) {
  resolution_ = 64;
  readBodyOf(boxMesh(8, 5, 3, 5.0));
  sweep({{0, 0, 0}, {-21.379538241026982, 1.9561691991603278, 33.918176841362786}},
        Eigen::Quaterniond(0.89550238579677066, 0.07373450560868261, -0.31273825653145593,
                           -0.30795045480823685));
  SolidOptions options = optionsWithOrigin();
  options.tolerance = 0.1;
  const WrittenSolid report = write(options);
  EXPECT_LE(judged_.faces, 60);
  EXPECT_LE(kinds_["facet"], 20);
  EXPECT_GE(kinds_["sheet"], 10);
  EXPECT_TRUE(judged_.valid);
  EXPECT_EQ(judged_.solids, 1);
  EXPECT_EQ(judged_.faults.count("SelfIntersect"), 0u);
  EXPECT_LE(judged_.edgeTolerance, 1e-5);
  EXPECT_LE(judged_.blockError, 1e-9);
  EXPECT_LE(report.deviation, options.tolerance);
}

TEST_F(BodySolid, RodThatTurnsWhileItMoves) {
  const std::string file = folder_.file("rod.brep");
  writeRod(kRadius, kLength, file);
  readBodyFrom(file);
  sweep({{0, 0, 0}, {9, 13, 8}}, turned(0.6, {1, 2, 1}));
  expectExactFaces();
  EXPECT_LE(kinds_["cylinder"], 4);
  EXPECT_LE(judged_.faces, 20);
}

// Motions of tests/tools/turning_suite.py along which a rod or a cone of these sizes has surfaces
// that are difficult to make, or are nearly tangent.
class DifficultBodySolid : public BodySolid {
 protected:
  void sweepTo(const Vector3d& travel, const Eigen::Quaterniond& turn, int mostFaces) {
    resolution_ = 64;
    readBodyFrom(file_);
    sweep({{0, 0, 0}, travel}, turn);
    SolidOptions options = optionsWithOrigin();
    options.tolerance = 0.1;
    // The test for faces that intersect takes a minute for these.
    const WrittenSolid report =
        writeSolid(result_.mesh, folder_.file("envelope.brep"), options, run_);
    for (const auto& [kind, count] : report.facesByKind) EXPECT_NE(kind, "facet");
    EXPECT_LE(report.faces, mostFaces);
    EXPECT_LE(report.deviation, 0.01);
    EXPECT_NEAR(report.volume, report.meshVolume, 1e-2 * report.volume);
  }

  static constexpr double kBase = 12, kHeight = 30;
  const std::string file_ = folder_.file("difficult.brep");
};

// An edge of regression and two sections end at one point, and have the same tangent there.
TEST_F(DifficultBodySolid, SectionsThatAreTangentAtTheirEnds) {
  writeRodWithChamfers(kBase, kHeight, 3, file_);
  sweepTo({-14.754223565800425, 4.4783098763700178, -35.300709608090315},
          {0.98647555524629249, 0.13620330758046251, -0.062318911479026406, -0.066565690695207444},
          16);
}

// Some sections are shorter than the error of the triangles of the body.
TEST_F(DifficultBodySolid, SectionsThatNoSamplesCanJudge) {
  writeCone(kBase, 6, kHeight, file_);
  sweepTo({15.487276024159758, 44.027159230950758, -17.20897395650227},
          {0.89206899632907188, -0.32576480511693651, 0.046342243198321947, -0.30974601535921975},
          30);
}

// Close to one moment, the points of contact run around the cylinder.
TEST_F(DifficultBodySolid, ARodThatNearlyMovesAlongItsAxis) {
  writeRodWithChamfers(kBase, kHeight, 3, file_);
  sweepTo({-21.379538241026982, 1.9561691991603278, 33.918176841362786},
          {0.89550238579677066, 0.07373450560868261, -0.31273825653145593, -0.30795045480823685},
          20);
}

// Sections end at edges of regression, at which the steps of Newton's method are too long.
TEST_F(DifficultBodySolid, SectionsThatEndWhereAFaceTurnsBack) {
  writeRod(kBase, kHeight, file_);
  sweepTo({1.42237410836425, 10.147214389488878, -56.197743076000556},
          {0.97435828822892034, 0.22122737463456302, 0.038934205502342126, 0.012980851813670334},
          14);
}

// Two faces slide within their planes.
TEST_F(BodySolid, BoxThatTurnsWithinAPlane) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {17, 4, 0}}, turned(0.4, {0, 0, 1}));
  expectExactFaces();
  EXPECT_EQ(kinds_["sheet"], judged_.faces - kinds_["plane"]);
  EXPECT_LE(judged_.faces, 14);
}

// Edges, but no faces, stay in planes. Along the longest of them, both faces at the edge touch the
// envelope at the same time.
TEST_F(BodySolid, EdgesThatTurnWithinAPlane) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {0, 17, 4}}, turned(0.4, {1, 0, 0}) * turned(0.7, {0, 0, 1}));
  motion_.poses[0].rotation = turned(0.7, {0, 0, 1});
  compute();
  expectExactFaces();
}

// Faces slide along the first two steps. In the third, the faces at the start lie in their planes.
TEST_F(BodySolid, StraightStepsBeforeATurn) {
  readBodyOf(voxelMesh([](int x, int y, int) { return x < 4 || y < 3; }, 12, 9, 5, 1.0));
  sweep({{0, 0, 0}, {0, 0, 7}, {9, 0, 7}, {14, 8, 11}}, turned(0.5, {2, -1, 1}));
  expectExactFaces();
}

// The cylinder slides along its axis, then its planes slide. A disc that moves along a line sweeps
// the same area, however it turns.
TEST_F(BodySolid, RodAlongItsAxisThenAcross) {
  const std::string file = folder_.file("rod.brep");
  writeRod(kRadius, kLength, file);
  readBodyFrom(file);
  sweep({{0, 0, 0}, {0, 0, 9}, {17, 0, 9}}, turned(0.4, {0, 0, 1}));
  expectExact(M_PI * kRadius * kRadius * (kLength + 9) + 2 * kRadius * kLength * 17);
  EXPECT_LE(kinds_["cylinder"], 4);
}

// The cylinder touches the envelope along two of its lines, and at times along a whole circle. Its
// surfaces are recognised in the mesh.
TEST_F(BodySolid, ARodThatTurnsWithinAPlaneIsNoError) {
  const std::string file = folder_.file("rod.brep");
  writeRod(kRadius, kLength, file);
  readBodyFrom(file);
  sweep({{0, 0, 0}, {17, 0, 4}}, turned(0.4, {0, 1, 0}));
  const SolidOptions options = optionsWithOrigin();
  const WrittenSolid report = write(options);
  EXPECT_TRUE(judged_.valid);
  EXPECT_LE(report.edgeTolerance, options.tolerance);
  EXPECT_NEAR(report.volume, report.meshVolume, 1e-2 * report.meshVolume);
}

TEST_F(BodySolid, AnEstimateHasItsFacesAndSize) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {7, 4, 9}}, none_);
  const SolidOptions options = optionsWithOrigin();
  const SolidEstimate estimate = trySolid(result_.mesh, options, SolidFormat::Step, run_);
  const WrittenSolid report = write(options);
  EXPECT_EQ(estimate.faces, report.faces);
  EXPECT_NEAR(1e6 * estimate.megabytes, static_cast<double>(report.fileBytes), 100);
  EXPECT_GT(estimate.seconds, estimate.trialSeconds);
}

TEST_F(BodySolid, RefusesABodyWithoutFaces) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {7, 4, 9}}, none_);
  SolidOptions options = optionsWithOrigin();
  options.origin = std::make_shared<const SolidOrigin>(SolidOrigin{motion_, nullptr});
  try {
    writeSolid(result_.mesh, folder_.file("x.step"), options, run_);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "BadOption");
  }
  EXPECT_EQ(folder_.count(), 1u) << "only the body";
}

// Some vertices of the mesh are off by more than the tolerance, but the solid is right.
TEST_F(BodySolid, ACoarseMeshDoesNotRefuseIt) {
  const std::string file = folder_.file("rod.brep");
  writeRod(kRadius, kLength, file);
  readBodyFrom(file);
  resolution_ = 32;
  sweep({{0, 0, 0}, {9, 3, 11}}, none_);
  SolidOptions options = optionsWithOrigin();
  options.tolerance = 0.03;
  const WrittenSolid report = write(options);
  EXPECT_EQ(kinds_["facet"], 0);
  EXPECT_LE(report.deviation, options.tolerance);
}

// Parts with fillets: sections that begin where a face runs along the move, cusps of contact
// curves, and slivers between faces that are nearly tangent.
TEST_F(BodySolid, PartsOfRealMachinesAlongALine) {
  for (const auto& [name, faces] :
       {std::pair("printer_extruder_idler", 170), std::pair("robot_lower_leg_fork", 200)}) {
    const std::string part = std::string(SWEPT_SHARED_DATA "/cad/") + name + ".step";
    if (!std::filesystem::exists(part)) GTEST_SKIP() << "shared test data not found: " << part;
    readBodyFrom(part);
    sweep({{0, 0, 0}, {19.573170447598564, 10.73367411642502, 52.405585391957445}}, none_);
    const std::string file = folder_.file("envelope.brep");
    const WrittenSolid report = writeSolid(result_.mesh, file, optionsWithOrigin(), run_);
    for (const auto& [kind, count] : report.facesByKind) EXPECT_NE(kind, "facet") << name;
    EXPECT_LE(report.faces, faces) << name;
    EXPECT_LE(report.deviation, 0.02) << name;
    EXPECT_LE(report.edgeTolerance, 1e-3) << name;
  }
}

// A solid of another motion is found out: its surfaces are then recognised in the mesh.
TEST_F(BodySolid, AnotherMotionIsRefused) {
  readBodyOf(boxMesh(12, 8, 5));
  sweep({{0, 0, 0}, {7, 4, 9}}, none_);
  motion_.poses.back().translation += Vector3d(0.5, -0.2, 0);
  const SolidOptions options = optionsWithOrigin();
  const WrittenSolid report = write(options);
  EXPECT_NEAR(report.volume, report.meshVolume, 1e-3 * report.meshVolume);
}

}  // namespace
}  // namespace swept
