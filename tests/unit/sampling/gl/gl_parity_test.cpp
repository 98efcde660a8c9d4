// The GPU sampler against the CPU sampler on a real OpenGL (Mesa's software rasteriser will do):
// the same marks, fractions and elements, hence the same mesh to the last bit.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "input/body_check.h"
#include "sampling/gl/gl_backend.h"
#include "sampling/gl/gl_verify.h"
#include "support/sampled.h"
#include "swept/compute.h"
#include "swept/io.h"
#include "unit/sampling/gl/scene.h"

namespace swept::test {
namespace {

/// Returns a device, or null and the reason.
std::shared_ptr<gl::GlDevice> anyDevice(std::string& why) {
  RunContext run;
  try {
    return gl::openTested(gl::currentSetup(), run);
  } catch (const Error& error) {
    why = error.what();
    return nullptr;
  }
}
#define NEED_DEVICE(device)                   \
  std::string whyNoDevice;                    \
  const auto device = anyDevice(whyNoDevice); \
  if (!device) GTEST_SKIP() << whyNoDevice

/// Runs both samplers. `settings` say how the work of the GPU is divided.
Difference expectSame(const std::shared_ptr<gl::GlDevice>& device, const Scene& scene,
                      const gl::GlSettings& settings = {}) {
  RunContext run;
  const SamplerInput input = scene.input();
  const MarkedEdges truth = sampleCpu(input, run);
  gl::GlSampler sampler(
      input, [&] { return device; }, settings);
  MarkedEdges marked = sampler.mark(run);
  const SignRuns signs = findOutside(marked, scene.grid, run);
  sampler.resolve(marked, signs, run);
  Difference d = compare(scene, marked, truth, signs);
  d.longestDispatch = sampler.passes().longestDispatchSeconds();
  EXPECT_EQ(d.edges, 0);  // the signs agree at every lattice point
  EXPECT_EQ(d.elements, 0);
  EXPECT_LE(d.largestFraction, 1e-6);
  EXPECT_GT(d.contributing, 100);
  if (d.fractions != 0) {
    std::printf("  %lld of %lld fractions differ, by at most %g\n",
                static_cast<long long>(d.fractions), static_cast<long long>(d.contributing),
                d.largestFraction);
  }
  return d;
}

TEST(GlParity, EveryKindOfMotion) {
  NEED_DEVICE(device);
  for (const auto interpolation : {Interpolation::None, Interpolation::Linear}) {
    for (const bool cull : {true, false}) {
      Scene scene(makeTorus(3, 1, 32, 16), turningPath(3, interpolation), 40);
      scene.cull = cull;
      expectSame(device, scene);
    }
  }
}

/// Faces lie on grid planes and vertices on grid lines, so that every decision is a tie.
TEST(GlParity, TiesOnTheLattice) {
  NEED_DEVICE(device);
  Trajectory path;
  path.poses.resize(1);
  Scene scene(makeBox({0, 0, 0}, {1, 1, 1}), path, 20);
  scene.grid.cell = 0.125;
  scene.grid.points = {20, 20, 20};
  // Coordinates of snapped vertices are odd: vertices miss the lattice by half a unit. Edges run
  // exactly between lattice points.
  for (const double shift : {0.0, 0.125 * 0x1p-17, 0.0625}) {
    scene.grid.origin = Eigen::Vector3d(-0.5, -0.5 + shift, -0.5 - 2 * shift);
    expectSame(device, scene);
  }
  Scene slanted(makeBall({0, 0, 0}, 1, 0), path, 20);  // large faces with lattice points on edges
  for (auto& v : slanted.body.vertices) v = (v * 4).array().round().matrix() / 4;
  slanted.topology = buildTopology(slanted.body);
  slanted.grid.cell = 0.25;
  slanted.grid.points = {14, 14, 14};
  slanted.grid.origin.setConstant(-1.625);
  expectSame(device, slanted);
}

TEST(GlParity, SlabsBatchesAndChunksChangeNothing) {
  NEED_DEVICE(device);
  for (const auto interpolation : {Interpolation::None, Interpolation::Linear}) {
    const Scene scene(makeTorus(3, 1, 24, 12), turningPath(3, interpolation), 28);
    for (const std::uint64_t budget : {3'000u, 12'000u, 60'000u}) {
      gl::GlSettings settings;
      settings.budgetBytes = budget;
      settings.adaptBatch = false;
      if (budget == 60'000) settings.epochElements = 1;  // every chunk an epoch of its own
      settings.firstBatch = budget < 4000 ? 1 << 20 : 700;
      settings.chunkBytes = budget < 4000 ? 1 << 20 : 4096;
      expectSame(device, scene, settings);
    }
  }
}

TEST(GlParity, EnvelopeIsTheSameToTheLastBit) {
  NEED_DEVICE(device);
  const TriMesh body = makeTorus(3, 1, 48, 24);
  for (const auto method :
       {ComponentMethod::DualContouring, ComponentMethod::DualMarchingCubes,
        ComponentMethod::Equivalence, ComponentMethod::Greedy, ComponentMethod::Consistent}) {
    Options options;
    options.resolution = 48;
    options.components = method;
    RunContext run;
    const Trajectory path = turningPath(3, Interpolation::Linear);
    const Result cpu = compute(body, path, options, run);
    options.backend = Backend::Gpu;
    const Result gpu = compute(body, path, options, run);
    ASSERT_EQ(gpu.report.status, cpu.report.status) << gpu.report.message;
    EXPECT_EQ(gpu.report.backend, "gpu");
    EXPECT_EQ(gpu.mesh.vertices, cpu.mesh.vertices);
    EXPECT_EQ(gpu.mesh.triangles, cpu.mesh.triangles);
    EXPECT_EQ(gpu.contactTime, cpu.contactTime);
  }
}

TEST(GlParity, ACapsuleHasItsVolume) {
  NEED_DEVICE(device);
  Trajectory path;
  path.poses.push_back(poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})));
  path.poses.push_back(poseOf(1, placement({0, 0, 1}, 0, {3, 1, 2})));
  Options options;
  options.resolution = 64;
  options.backend = Backend::Gpu;
  RunContext run;
  const Result result = compute(makeBall({0, 0, 0}, 1, 4), path, options, run);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  EXPECT_TRUE(result.report.check.passes());
  const double length = std::sqrt(14.0), truth = M_PI * length + 4.0 / 3 * M_PI;
  EXPECT_NEAR(result.report.check.volume, truth, 0.02 * truth);
}

/// Shared meshes x 3 motions; all meshes only with SWEPT_LONG_TESTS=1. SWEPT_PARITY_RESOLUTION sets
/// the resolution (default: 64). SWEPT_PARITY_ONLY selects the meshes whose name contains it.
TEST(GlParity, SharedMeshes) {
  const std::filesystem::path data = SWEPT_SHARED_DATA;
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no " << data;
  NEED_DEVICE(device);
  const char* setting = std::getenv("SWEPT_PARITY_RESOLUTION");
  const int resolution = setting ? std::atoi(setting) : 64;
  std::vector<std::string> names = {"fandisk_13k", "tooth_crown_4k", "beam_joint_part2_5k"};
  if (longRun()) {
    names.insert(
        names.end(),
        {"beam_joint_part0_7k", "beam_joint_part6_25k", "differential_pinion_15k",
         "differential_side_gear_12k", "differential_ring_gear_58k", "gripper_robotiq_2f140_30k",
         "ship_propeller_37k", "space_station_skylab_36k_open", "bunny_stanford_70k",
         "armadillo_stanford_86k", "robot_leg_shell_base_72k_thin"});
  }
  const Trajectory keys = readTrajectoryCsv(
      (data / "motions/keyposes_16_from_tum_fr2_desk.csv").string(), 1, Interpolation::Linear);
  const char* only = std::getenv("SWEPT_PARITY_ONLY");
  for (const std::string& name : names) {
    if (only && name.find(only) == std::string::npos) continue;
    const TriMesh mesh = readMesh((data / "meshes" / (name + ".ply")).string());
    RunContext run;
    CheckedBody body = checkBody(mesh, Options{}, run);
    Eigen::AlignedBox3d box;
    for (const auto& v : body.mesh.vertices) box.extend(v);
    for (auto& v : body.mesh.vertices) v = (v - box.center()) / box.diagonal().norm();
    for (const int kind : {0, 1, 2}) {
      Trajectory path;
      path.interpolation = kind == 1 ? Interpolation::Linear : Interpolation::None;
      const std::size_t poses = kind == 0 ? 1 : kind == 1 ? 3 : 8;
      path.poses.assign(keys.poses.begin(),
                        keys.poses.begin() + static_cast<std::ptrdiff_t>(poses));
      SCOPED_TRACE(name + " motion " + std::to_string(kind));
      Scene scene(body.mesh, path, resolution);
      scene.orientable = body.orientable;
      const Difference d = expectSame(device, scene);
      std::printf(
          "  %s, motion %d, %d: %lld crossings, %lld edges, %lld fractions, %lld elements "
          "differ; longest dispatch %.0f ms\n",
          name.c_str(), kind, resolution, static_cast<long long>(d.contributing),
          static_cast<long long>(d.edges), static_cast<long long>(d.fractions),
          static_cast<long long>(d.elements), 1000 * d.longestDispatch);
      std::fflush(stdout);
    }
  }
}

TEST(GlParity, DispatchesStayShort) {
  NEED_DEVICE(device);
  const Scene scene(makeTorus(3, 1, 96, 48), turningPath(5, Interpolation::None), 64);
  RunContext run;
  const SamplerInput input = scene.input();
  gl::GlSampler sampler(input, [&] { return device; }, {});
  sampler.mark(run);
  RecordProperty("longest_dispatch_ms",
                 static_cast<int>(1000 * sampler.passes().longestDispatchSeconds()));
  std::printf("  longest of %llu dispatches: %.1f ms\n",
              static_cast<unsigned long long>(sampler.passes().dispatches()),
              1000 * sampler.passes().longestDispatchSeconds());
  EXPECT_GE(sampler.passes().dispatches(), 2u);
}

}  // namespace
}  // namespace swept::test
