// Rows 28 to 33 of docs/bad_input.md: each fault is provoked on a simulated device.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "base/checkpoint_hook.h"
#include "sampling/gl/gl_backend.h"
#include "sampling/gl/gl_verify.h"
#include "swept/compute.h"
#include "unit/sampling/gl/fake_gl.h"
#include "unit/sampling/gl/scene.h"

namespace swept::test {
namespace {

constexpr double kLongRun = 1e6;  // s; a run so long that `auto` uses a GPU

class GlFault : public testing::Test {
 protected:
  GlFault() : scene_(makeTorus(3, 1, 24, 12), turningPath(4, Interpolation::Linear), 32) {
    RunContext run;
    truth_ = sampleCpu(scene_.input(), run);
    settings_.adaptBatch = false;  // the number of fences must not depend on the time
    settings_.firstBatch = 8192;
  }
  ~GlFault() override {
    gl::setSetupForTests(nullptr);
    EXPECT_EQ(fakeCounts().alive, 0) << "contexts left behind";
    EXPECT_EQ(fakeCounts().buffers, 0);
    EXPECT_EQ(fakeCounts().programs, 0);
  }

  void use(const FakeFaults& faults) {
    gl::GlSetup setup;
    setup.loader = makeFakeGl(faults);
    setup.settings = settings_;
    setup.assumedRatio = 0.5;
    gl::setSetupForTests(&setup);
  }
  SampledSurface sample(Backend backend) {
    const SamplerInput input = scene_.input();
    return sampleSurface(
        input, backend, kLongRun,
        [&](const MarkedEdges& marked) {
          RunContext run;
          return findOutside(marked, scene_.grid, run);
        },
        run_);
  }
  void expectTruth(const SampledSurface& got) {
    const Difference d = compare(scene_, got.marked, truth_, got.signs);
    EXPECT_EQ(d.edges, 0);
    EXPECT_EQ(d.fractions, 0);
    EXPECT_EQ(d.elements, 0);
    EXPECT_GT(d.contributing, 1000);
  }
  /// Tests both backends with this fault. With gpu, the run must fail with this status and a text
  /// that contains `part`. With auto, it must continue on the CPU, with a finding.
  void expectFallback(const FakeFaults& faults, Status status, const std::string& part) {
    use(faults);
    try {
      sample(Backend::Gpu);
      ADD_FAILURE() << "no failure";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), status) << error.what();
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    use(faults);
    const SampledSurface out = sample(Backend::Auto);
    EXPECT_EQ(out.backend, "cpu");
    ASSERT_EQ(out.notes.size(), 1u);
    EXPECT_EQ(out.notes[0].code, "CpuSampler");
    EXPECT_NE(out.notes[0].text.find(part), std::string::npos) << out.notes[0].text;
    expectTruth(out);
  }

  Scene scene_;
  MarkedEdges truth_;
  gl::GlSettings settings_;
  RunContext run_;
};

TEST_F(GlFault, a_sound_device_gives_the_truth) {
  use({});
  const SampledSurface out = sample(Backend::Gpu);
  EXPECT_EQ(out.backend, "gpu");
  EXPECT_NE(out.device.find("Imaginary 9000"), std::string::npos);
  EXPECT_TRUE(out.notes.empty());
  expectTruth(out);
  use({});
  EXPECT_EQ(sample(Backend::Auto).backend, "gpu");
}

TEST_F(GlFault, cpu_never_touches_gl) {
  use({});
  EXPECT_EQ(sample(Backend::Cpu).backend, "cpu");
  EXPECT_EQ(fakeCounts().contexts, 0);
}

TEST_F(GlFault, auto_keeps_to_the_cpu_where_that_is_faster) {
  gl::GlSetup setup;
  setup.loader = makeFakeGl({});
  setup.assumedRatio = 1.7;
  gl::setSetupForTests(&setup);
  const SampledSurface out = sample(Backend::Auto);
  EXPECT_EQ(out.backend, "cpu");
  ASSERT_EQ(out.notes.size(), 1u);
  EXPECT_NE(out.notes[0].text.find("1.7 times"), std::string::npos) << out.notes[0].text;
}

TEST_F(GlFault, bad_input_28_no_library) {
  FakeFaults f;
  f.noLibrary = true;
  expectFallback(f, Status::DeviceUnavailable, "libEGL.so.1");
}
TEST_F(GlFault, bad_input_28_no_context) {
  FakeFaults f;
  f.noContext = true;
  expectFallback(f, Status::DeviceUnavailable, "no OpenGL 4.5 core context");
}
TEST_F(GlFault, bad_input_28_old_gl) {
  FakeFaults f;
  f.minor = 3;
  expectFallback(f, Status::DeviceUnavailable, "older than OpenGL 4.5");
}
TEST_F(GlFault, bad_input_28_missing_function) {
  FakeFaults f;
  f.missingFunction = "glFenceSync";
  expectFallback(f, Status::DeviceUnavailable, "glFenceSync");
}

TEST_F(GlFault, bad_input_29_software_only) {
  FakeFaults f;
  f.renderer = "llvmpipe (imaginary)";
  use(f);
  const SampledSurface demanded = sample(Backend::Gpu);
  EXPECT_NE(demanded.device.find("llvmpipe"), std::string::npos);
  expectTruth(demanded);
  use(f);
  const SampledSurface chosen = sample(Backend::Auto);
  EXPECT_EQ(chosen.backend, "cpu");
  ASSERT_EQ(chosen.notes.size(), 1u);
  EXPECT_NE(chosen.notes[0].text.find("software rasteriser"), std::string::npos);
}

TEST_F(GlFault, bad_input_30_small_limits_mean_more_bricks) {
  scene_ = Scene(makeTorus(3, 1, 8, 6), turningPath(4, Interpolation::Linear), 64);
  truth_ = sampleCpu(scene_.input(), run_);
  FakeFaults f;
  f.storageBytes = 4096;
  use(f);
  const SampledSurface out = sample(Backend::Gpu);
  EXPECT_GT(fakeCounts().markReadbacks, 20);
  expectTruth(out);
}
TEST_F(GlFault, bad_input_30_below_the_minimum) {
  FakeFaults f;
  f.storageBlocks = 7;
  expectFallback(f, Status::DeviceUnavailable, "storage blocks in a compute shader");
  f = {};
  f.storageBytes = 2048;
  expectFallback(f, Status::DeviceUnavailable, "bytes in a storage block");
}

TEST_F(GlFault, bad_input_31_lost_once_at_any_fence_is_mended) {
  use({});
  sample(Backend::Gpu);
  const int fences = fakeCounts().fences;
  ASSERT_GT(fences, 4);
  int mended = 0;
  for (int n = 1; n <= fences; ++n) {
    FakeFaults f;
    f.resetFromFence = n;
    f.faultyContexts = 1;
    use(f);
    try {
      const SampledSurface out = sample(Backend::Gpu);
      expectTruth(out);
      ASSERT_EQ(out.notes.size(), 1u);
      EXPECT_EQ(out.notes[0].code, "DeviceReopened");
      EXPECT_EQ(fakeCounts().contexts, 2);
      ++mended;
    } catch (const Error& error) {
      // A device that is lost in its self-test is not used at all.
      EXPECT_EQ(error.status(), Status::DeviceLost);
      EXPECT_EQ(mended, 0) << "fence " << n << ": " << error.what();
    }
  }
  EXPECT_GE(mended, 3);
}
TEST_F(GlFault, bad_input_31_lost_for_good) {
  use({});
  sample(Backend::Gpu);
  const int fences = fakeCounts().fences;
  for (int n = 1; n <= fences; ++n) {
    FakeFaults f;
    f.resetFromFence = n;
    expectFallback(f, Status::DeviceLost, "reset status 0x8253");
  }
}
TEST_F(GlFault, bad_input_31_fence_never_signals) {
  settings_.fenceTimeoutSeconds = 0.01;
  for (const int n : {1, 12}) {
    FakeFaults f;
    f.silentFromFence = n;
    expectFallback(f, Status::DeviceLost, "no answer within 0.01 s");
  }
}

TEST_F(GlFault, bad_input_32_garbage_in_the_self_test) {
  FakeFaults f;
  f.setOneBitAtReadback = 1;
  expectFallback(f, Status::DeviceLost, "self-test");
  f = {};
  f.setBitsFromReadback = 1;
  expectFallback(f, Status::DeviceLost, "an edge beyond the grid");
  f = {};
  f.clearBitsFromReadback = 1;
  expectFallback(f, Status::DeviceLost, "Imaginary 9000");
  f = {};
  f.wrongWinnerFromReadback = 1;
  expectFallback(f, Status::DeviceLost, "wrong result");
}
TEST_F(GlFault, bad_input_32_garbage_after_the_self_test) {
  use({});
  gl::openTested(gl::currentSetup(), run_);
  const int marks = fakeCounts().markReadbacks, winners = fakeCounts().winnerReadbacks;
  ASSERT_GT(marks, 1);
  ASSERT_GT(winners, 0);
  FakeFaults f;
  f.setBitsFromReadback = marks + 1;
  expectFallback(f, Status::DeviceLost, "an edge beyond the grid");
  f = {};
  f.setOneBitAtReadback = marks + 1;
  expectFallback(f, Status::DeviceLost, "no surface on an edge");
  f = {};
  f.clearBitsFromReadback = marks + 1;
  expectFallback(f, Status::DeviceLost, "no mark on lattice edge");
  f = {};
  f.wrongWinnerFromReadback = winners + 1;
  expectFallback(f, Status::DeviceLost, "that does not cross it");
}

TEST_F(GlFault, bad_input_33_shader_does_not_compile_or_link) {
  FakeFaults f;
  f.brokenShader = "atomicOr";
  expectFallback(f, Status::DeviceUnavailable, "mark.glsl + sample.comp does not compile");
  f.brokenShader = "atomicMin";
  expectFallback(f, Status::DeviceUnavailable, "0:7: unexpected identifier");
  f = {};
  f.linkFails = true;
  expectFallback(f, Status::DeviceUnavailable, "does not link");
}

TEST_F(GlFault, bad_input_24_cancel_at_every_checkpoint) {
  use({});
  sample(Backend::Gpu);
  const std::uint64_t checkpoints = CheckpointHook::passed(run_);
  ASSERT_GT(checkpoints, 5u);
  const SamplerInput input = scene_.input();
  const std::uint64_t stride = checkpoints / 24 + 1;
  for (std::uint64_t n = 1; n < checkpoints; n += stride) {
    for (const Backend backend : {Backend::Gpu, Backend::Auto}) {
      use({});
      RunContext run;
      CheckpointHook::cancelAt(run, n);
      try {
        sampleSurface(
            input, backend, kLongRun,
            [&](const MarkedEdges& marked) { return findOutside(marked, scene_.grid, run); }, run);
        // Parallel loops reach their checkpoints in any order; only the total number is fixed.
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::Cancelled) << error.what();
        EXPECT_EQ(fakeCounts().alive, 0);
        continue;
      }
      ADD_FAILURE() << "checkpoint " << n << " of " << checkpoints << " did not cancel";
    }
  }
}

TEST_F(GlFault, a_whole_run_ends_with_the_named_status) {
  FakeFaults f;
  f.resetFromFence = 3;
  use(f);
  Options options;
  options.resolution = 32;
  options.backend = Backend::Gpu;
  RunContext run;
  Result result = compute(scene_.body, turningPath(4, Interpolation::Linear), options, run);
  EXPECT_EQ(result.report.status, Status::DeviceLost);
  EXPECT_EQ(result.report.code, "DeviceLost");
  EXPECT_TRUE(result.mesh.triangles.empty());
  use({});
  result = compute(scene_.body, turningPath(4, Interpolation::Linear), options, run);
  EXPECT_EQ(result.report.status, Status::Ok) << result.report.message;
  EXPECT_EQ(result.report.backend, "gpu");
  EXPECT_TRUE(result.report.check.passes());
}

/// A missing mark is found by tests inside the body, however rare it is.
TEST_F(GlFault, signs_that_leak_into_the_body_are_noticed) {
  MarkedEdges leaking = truth_;
  for (auto& start : leaking.layers[scene_.grid.points[0] / 2].columnStart) {
    std::fill(start.begin(), start.end(), 0u);
  }
  for (auto& edges : leaking.layers[scene_.grid.points[0] / 2].edges) edges.clear();
  const SignRuns sound = findOutside(truth_, scene_.grid, run_);
  gl::verifySigns(scene_.input(), truth_, sound, "test");
  const SignRuns signs = findOutside(leaking, scene_.grid, run_);
  EXPECT_THROW(gl::verifySigns(scene_.input(), leaking, signs, "test"), Error);
}

}  // namespace
}  // namespace swept::test
