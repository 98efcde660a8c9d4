// The rows of docs/bad_input.md through compute(): each run ends as the row says.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "base/checkpoint_hook.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TriMesh unitBox() { return makeBox({0, 0, 0}, {3, 2, 1}); }

Trajectory still() {
  Trajectory motion;
  motion.poses.push_back(poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})));
  return motion;
}

Trajectory shift(const Eigen::Vector3d& travel = {2, 1, 0.5}) {
  Trajectory motion = still();
  motion.poses.push_back(poseOf(1, placement({0, 0, 1}, 0, travel)));
  return motion;
}

Options coarse() {
  Options options;
  options.resolution = 32;
  return options;
}

Result run(const TriMesh& body, const Trajectory& motion, const Options& options = coarse()) {
  RunContext context;
  return compute(body, motion, options, context);
}

bool warns(const Result& result, const std::string& code) {
  for (const auto& finding : result.report.warnings) {
    if (finding.code == code) return finding.count > 0 && !finding.text.empty();
  }
  return false;
}

void expectGoodResult(const Result& result) {
  ASSERT_EQ(result.report.status, Status::Ok)
      << result.report.code << ": " << result.report.message;
  EXPECT_TRUE(result.report.check.passes());
  EXPECT_FALSE(result.mesh.triangles.empty());
  EXPECT_TRUE(result.report.message.empty());
}

/// Tests that a run failed with this status and code, and left nothing that looks like a result.
void expectFailure(const Result& result, Status status, const std::string& code) {
  EXPECT_EQ(result.report.status, status) << result.report.message;
  EXPECT_EQ(result.report.code, code) << result.report.message;
  EXPECT_FALSE(result.report.message.empty());
  EXPECT_TRUE(result.mesh.vertices.empty());
  EXPECT_TRUE(result.mesh.triangles.empty());
  EXPECT_TRUE(result.contactTime.empty());
}

void expectRefused(const Result& result, const std::string& code) {
  expectFailure(result, Status::InvalidInput, code);
}

TEST(BadInput, bad_input_01_empty_mesh) { expectRefused(run({}, shift()), "EmptyMesh"); }

TEST(BadInput, bad_input_02_bad_index) {
  TriMesh body = unitBox();
  body.triangles[3][0] = 1000000;
  expectRefused(run(body, shift()), "BadIndex");
  body.triangles[3][0] = -7;
  expectRefused(run(body, shift()), "BadIndex");
}

TEST(BadInput, bad_input_03_not_a_number) {
  TriMesh body = unitBox();
  body.vertices[1].x() = kNan;
  expectRefused(run(body, shift()), "NonFiniteVertex");
}

TEST(BadInput, bad_input_04_degenerate_triangles) {
  TriMesh body = unitBox();
  body.triangles.push_back({0, 0, 1});
  const Result result = run(body, shift());
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "DegenerateTriangles"));
  TriMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  expectRefused(run(flat, shift()), "NoVolume");
}

TEST(BadInput, bad_input_05_soup) {
  const Result whole = run(unitBox(), shift());
  const Result welded = run(soup(unitBox()), shift());
  expectGoodResult(welded);
  EXPECT_TRUE(warns(welded, "Welded"));
  EXPECT_EQ(whole.report.check.volume, welded.report.check.volume);
}

TEST(BadInput, bad_input_06_open_mesh) {
  TriMesh body = unitBox();
  body.triangles.resize(10);  // one side missing
  expectRefused(run(body, still()), "OpenMesh");
  // A sheet moves across its own plane: its prisms are closed.
  TriMesh sheet;
  sheet.vertices = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Result result = run(sheet, shift({0.3, 0.2, 2}));
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "OpenEdges"));
  EXPECT_NEAR(result.report.check.volume, 18, 0.05 * 45 * result.report.cellSize);
}

TEST(BadInput, bad_input_07_inward_normals) {
  const Result right = run(unitBox(), shift());
  const Result wrong = run(inverted(unitBox()), shift());
  expectGoodResult(wrong);
  EXPECT_TRUE(warns(wrong, "Flipped"));
  EXPECT_NEAR(right.report.check.volume, wrong.report.check.volume, 1e-9);
}

TEST(BadInput, bad_input_08_mixed_orientation) {
  TriMesh body = unitBox();
  for (const std::size_t t : {1u, 4u, 6u}) std::swap(body.triangles[t][0], body.triangles[t][1]);
  const Result result = run(body, shift());
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "MixedOrientation"));
  EXPECT_NEAR(result.report.check.volume, run(unitBox(), shift()).report.check.volume, 1e-9);
}

TEST(BadInput, bad_input_09_non_manifold_edge) {
  TriMesh body = makeBox({0, 0, 0}, {1, 1, 1});
  append(body, makeBox({1, 1, 0}, {2, 2, 1}));
  const Result result = run(body, shift({0, 0, 2}));
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "NonManifoldEdges"));
}

TEST(BadInput, bad_input_10_overlapping_bodies) {
  TriMesh body = makeBox({0, 0, 0}, {2, 2, 2});
  append(body, makeBox({1, 1, 1}, {3, 3, 3}));
  const Result result = run(body, still());
  expectGoodResult(result);
  EXPECT_NEAR(result.report.check.volume, 15, 0.05 * 42 * result.report.cellSize);
}

TEST(BadInput, bad_input_11_duplicate_faces) {
  TriMesh body = unitBox();
  body.triangles.push_back(body.triangles[0]);
  const Result result = run(body, shift());
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "DuplicateTriangles"));
}

TEST(BadInput, bad_input_12_cavity) {
  TriMesh body = makeBox({0, 0, 0}, {4, 4, 4});
  append(body, inverted(makeBox({1, 1, 1}, {3, 3, 3})));
  const Result filled = run(body, still());
  expectGoodResult(filled);
  EXPECT_TRUE(warns(filled, "Cavities"));
  EXPECT_NEAR(filled.report.check.volume, 64, 0.05 * 96 * filled.report.cellSize);
  EXPECT_EQ(filled.report.check.shells, 1);
}

TEST(BadInput, bad_input_13_thin_wall) {
  const TriMesh body = makeBox({0, 0, 0}, {3, 3, 0.01});  // a tenth of a cell thick
  const Result result = run(body, shift({0.5, 0, 0}));
  expectGoodResult(result);
}

TEST(BadInput, bad_input_14_far_from_origin) {
  TriMesh body = unitBox();
  for (auto& v : body.vertices) v += Eigen::Vector3d(1e6, -2e6, 3e6);
  const Result result = run(body, shift());
  expectGoodResult(result);
  EXPECT_NEAR(result.report.check.volume, run(unitBox(), shift()).report.check.volume, 0.01);
  for (auto& v : body.vertices) v.x() += 3e9;
  expectRefused(run(body, shift()), "OutOfRange");
  // So far away that there is no number between the lattice points.
  TriMesh tiny = makeBox({5e8, 5e8, 5e8}, {5e8 + 1e-6, 5e8 + 1e-6, 5e8 + 1e-6});
  const Result coarseNumbers = run(tiny, still());
  EXPECT_EQ(coarseNumbers.report.status, Status::InvalidInput);
  EXPECT_TRUE(coarseNumbers.mesh.triangles.empty());
}

TEST(BadInput, bad_input_15_cell_against_body) {
  Options options;
  options.cellSize = 10;
  expectRefused(run(unitBox(), still(), options), "CellTooLarge");
  options.cellSize = 1e-6;
  expectFailure(run(unitBox(), still(), options), Status::ResourceLimit, "ResourceLimit");
  // The run fails before it splits the edges of a turning body for such a cell.
  Trajectory turn = still();
  turn.poses.push_back(poseOf(1, placement({1, 2, 3}, 100, {2, 0, 1})));
  RunContext context;
  CheckpointHook::cancelAt(context, 50);
  expectFailure(compute(unitBox(), turn, options, context), Status::ResourceLimit, "ResourceLimit");
}

TEST(BadInput, bad_input_16_bad_option) {
  Options options;
  options.cellSize = -1;
  expectRefused(run(unitBox(), shift(), options), "BadOption");
  options = {};
  options.cellSize = kNan;
  expectRefused(run(unitBox(), shift(), options), "BadOption");
  options = {};
  options.resolution = 0;
  expectRefused(run(unitBox(), shift(), options), "BadOption");
  for (const int threads : {0, -1, 4097}) {
    RunContext context;
    context.threads = threads;
    expectRefused(compute(unitBox(), shift(), {}, context), "BadOption");
  }
  RunContext none;
  none.memoryLimitBytes = 0;
  expectRefused(compute(unitBox(), shift(), {}, none), "BadOption");
}

TEST(BadInput, bad_input_17_no_poses) { expectRefused(run(unitBox(), {}), "EmptyTrajectory"); }

TEST(BadInput, bad_input_18_one_pose) {
  const Result result = run(unitBox(), still());
  expectGoodResult(result);
  EXPECT_NEAR(result.report.check.volume, 6, 0.05 * 22 * result.report.cellSize);
}

TEST(BadInput, bad_input_19_repeated_poses) {
  Trajectory motion = shift();
  motion.poses.push_back(motion.poses.back());
  motion.poses.back().timeSeconds = 2;
  const Result result = run(unitBox(), motion);
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "RepeatedPoses"));
}

TEST(BadInput, bad_input_20_small_drift) {
  Trajectory motion = shift();
  motion.poses[1].rotation.coeffs() *= 1 + 3e-5;
  const Result result = run(unitBox(), motion);
  expectGoodResult(result);
  EXPECT_TRUE(warns(result, "RotationMended"));
}

TEST(BadInput, bad_input_21_not_rigid) {
  Trajectory motion = shift();
  motion.poses[1].rotation.coeffs() *= 1.5;
  expectRefused(run(unitBox(), motion), "NotRigid");
  motion.poses[1].rotation.coeffs().setZero();
  expectRefused(run(unitBox(), motion), "NotRigid");
}

TEST(BadInput, bad_input_22_bad_pose) {
  Trajectory motion = shift();
  motion.poses[1].translation.z() = kNan;
  expectRefused(run(unitBox(), motion), "BadPose");
  motion = shift();
  motion.poses[1].timeSeconds = -1;
  expectRefused(run(unitBox(), motion), "BadPose");
}

TEST(BadInput, bad_input_23_jump_between_poses) {
  Options options;
  options.cellSize = 0.25;
  const Result far = run(unitBox(), shift({200, 0, 0}), options);
  expectGoodResult(far);
  EXPECT_NEAR(far.report.check.volume, 6 + 200 * 2, 0.05 * 1222 * far.report.cellSize);
  Trajectory turn = still();
  turn.poses.push_back(poseOf(1, placement({0, 0, 1}, 180, {0, 0, 0})));
  expectRefused(run(unitBox(), turn), "AmbiguousTurn");
}

TEST(BadInput, bad_input_24_cancel_at_every_checkpoint) {
  RunContext whole;
  whole.threads = 1;
  const TriMesh body = makeBall({0, 0, 0}, 2, 2);
  ASSERT_EQ(compute(body, shift(), coarse(), whole).report.status, Status::Ok);
  ASSERT_GT(CheckpointHook::passed(whole), 20u);
  const std::uint64_t step = std::max<std::uint64_t>(1, CheckpointHook::passed(whole) / 300);
  for (std::uint64_t n = 1; n <= CheckpointHook::passed(whole); n += step) {
    RunContext context;
    context.threads = 1;
    CheckpointHook::cancelAt(context, n);
    const Result result = compute(body, shift(), coarse(), context);
    SCOPED_TRACE("checkpoint " + std::to_string(n));
    expectFailure(result, Status::Cancelled, "Cancelled");
  }
  expectGoodResult(run(body, shift()));  // the next run works
}

TEST(BadInput, bad_input_24_cancel_within_a_quarter_second) {
  const TriMesh body = makeBall({0, 0, 0}, 2, 5);
  Options options;
  options.resolution = 400;
  Trajectory motion = shift();
  motion.poses.push_back(poseOf(2, placement({1, 2, 3}, 80, {4, 4, 4})));
  for (const int milliseconds : {20, 100, 250, 500, 900}) {
    RunContext context;
    Result result;
    std::atomic<bool> done{false};
    std::thread worker([&] {
      result = compute(body, motion, options, context);
      done = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    const bool finishedFirst = done;
    const auto begin = std::chrono::steady_clock::now();
    context.cancel();
    worker.join();
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
    if (finishedFirst) break;  // the run ended before cancel()
    // Twice the limit: other processes may use the same cores.
    EXPECT_LT(waited.count(), 0.5) << "cancelled after " << milliseconds << " ms";
    if (result.report.status != Status::Ok) {
      expectFailure(result, Status::Cancelled, "Cancelled");
    }
  }
}

TEST(BadInput, bad_input_25_cancel_before_and_after) {
  RunContext before;
  before.cancel();
  before.cancel();
  expectFailure(compute(unitBox(), shift(), coarse(), before), Status::Cancelled, "Cancelled");
  RunContext after;
  const Result result = compute(unitBox(), shift(), coarse(), after);
  after.cancel();
  expectGoodResult(result);
}

TEST(BadInput, bad_input_26_above_the_memory_budget) {
  RunContext context;
  context.memoryLimitBytes = 1 << 20;
  Options options;
  options.resolution = 512;
  const Result result = compute(makeBall({0, 0, 0}, 2, 3), shift(), options, context);
  expectFailure(result, Status::ResourceLimit, "ResourceLimit");
  EXPECT_NE(result.report.message.find("MB"), std::string::npos);
}

TEST(BadInput, bad_input_28_no_gpu) {
  Options options = coarse();
  options.backend = Backend::Auto;
  expectGoodResult(run(unitBox(), shift(), options));
}

TEST(BadInput, bad_input_45_thinner_than_the_cell_everywhere) {
  Options options;
  options.cellSize = 1;
  // A needle that no line of the grid meets.
  const TriMesh needle = makeBox({0.4, 0.4, 0.4}, {0.41, 0.41, 3.6});
  const Result result = run(needle, still(), options);
  expectRefused(result, "CellTooLarge");
  // The cell size that the message proposes works.
  const std::string& text = result.report.message;
  ASSERT_NE(text.find("try "), std::string::npos) << text;
  options.cellSize = std::stod(text.substr(text.find("try ") + 4));
  EXPECT_EQ(run(needle, still(), options).report.status, Status::Ok) << text;
}

TEST(BadInput, ProgressNeverFalls) {
  RunContext context;
  std::atomic<bool> done{false};
  double last = 0;
  bool fell = false;
  std::thread watcher([&] {
    while (!done) {
      const double now = context.progress();
      fell = fell || now < last;
      last = now;
      std::this_thread::yield();
    }
  });
  Options options;
  options.resolution = 128;
  const Result result = compute(makeBall({0, 0, 0}, 2, 4), shift(), options, context);
  done = true;
  watcher.join();
  expectGoodResult(result);
  EXPECT_FALSE(fell);
  EXPECT_EQ(context.phase(), Phase::Done);
}

}  // namespace
}  // namespace swept::test
