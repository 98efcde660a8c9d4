// Lets each allocation, each checkpoint and each write of small runs fail once. Each time, the run
// must end with the right status, free all memory, and not affect the next run. With
// SWEPT_FAULTS=all, all of them fail in turn; otherwise a sample of them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "base/checkpoint_hook.h"
#include "base/parallel.h"
#include "fault/failing_new.h"
#include "support/process.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "swept/clearance.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::test {
namespace {

/// Returns the step from one fault to the next with which about `sample` of `total` are tried.
std::int64_t strideFor(std::int64_t total, std::int64_t sample) {
  const char* setting = std::getenv("SWEPT_FAULTS");
  if (setting != nullptr && std::string(setting) == "all") return 1;
  return std::max<std::int64_t>(1, total / sample);
}

/// Counts faults of one kind, and prints their number at the end.
struct Injected {
  const char* what;
  std::int64_t count = 0;
  ~Injected() { std::printf("injected: %lld %s\n", static_cast<long long>(count), what); }
};

Trajectory shift() {
  Trajectory motion;
  motion.poses.push_back(poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})));
  motion.poses.push_back(poseOf(1, placement({0, 1, 1}, 30, {2, 1, 0.5})));
  return motion;
}

struct Case {
  const char* name;
  TriMesh body;
  Trajectory motion;
  Options options;
  int threads = 1;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  Options options;
  options.resolution = 12;
  options.backend = Backend::Cpu;
  all.push_back({"box", makeBox({0, 0, 0}, {3, 2, 1}), shift(), options, 1});
  all.push_back({"box on three threads", makeBox({0, 0, 0}, {3, 2, 1}), shift(), options, 3});
  TriMesh dirty = soup(makeBox({0, 0, 0}, {3, 2, 1}));
  append(dirty, inverted(makeBox({1, 1, 0}, {2, 3, 1})));
  options.tolerance = 0.1;
  all.push_back({"dirty body, simplified", dirty, shift(), options, 1});
  Trajectory twisted = shift();
  twisted.interpolation = Interpolation::Screw;
  options.components = ComponentMethod::DualMarchingCubes;
  options.tolerance = 0;
  options.keepCavities = true;
  all.push_back({"torus, other method", makeTorus(2, 0.7, 12, 8), twisted, options, 1});
  return all;
}

Result compute(const Case& c, RunContext& run) {
  run.threads = c.threads;
  return swept::compute(c.body, c.motion, c.options, run);
}

std::uint64_t fingerprint(const Result& result) {
  std::uint64_t hash = 1469598103934665603ull;
  const auto eat = [&](const void* data, std::size_t bytes) {
    const auto* p = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) hash = (hash ^ p[i]) * 1099511628211ull;
  };
  for (const auto& v : result.mesh.vertices) eat(v.data(), sizeof(double) * 3);
  for (const auto& t : result.mesh.triangles) eat(t.data(), sizeof(std::int32_t) * 3);
  return hash;
}

void expectNothing(const Result& result) {
  EXPECT_FALSE(result.report.code.empty());
  EXPECT_FALSE(result.report.message.empty());
  EXPECT_TRUE(result.mesh.vertices.empty() && result.mesh.triangles.empty());
  EXPECT_TRUE(result.contactTime.empty() && result.featureEdges.empty() && !result.kept);
}

class EveryAllocation : public testing::TestWithParam<bool> {};

TEST_P(EveryAllocation, bad_input_27_out_of_memory) {
  const bool andAllLater = GetParam();
  Injected injected{andAllLater ? "failing allocations with all later ones"
                                : "failing allocations"};
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    std::uint64_t expected = 0;
    // The first run sets up what lasts as long as the process.
    for (int warm = 0; warm < 2; ++warm) {
      RunContext run;
      const Result result = compute(c, run);
      ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
      expected = fingerprint(result);
    }
    fault::arm(0);
    {
      RunContext run;
      compute(c, run);
    }
    const std::int64_t total = fault::allocations();
    ASSERT_GT(total, 100);
    const std::int64_t stride = strideFor(total, c.threads == 1 ? 250 : 100);
    std::int64_t failed = 0;
    for (std::int64_t n = 1; n <= total; n += stride) {
      const std::int64_t before = fault::outstandingBytes();
      {
        RunContext run;
        fault::arm(n, andAllLater);
        const Result result = compute(c, run);
        fault::disarm();
        if (result.report.status == Status::Ok) {
          // The sort can do without its buffer, or the run never came to this allocation.
          ASSERT_EQ(fingerprint(result), expected) << "allocation " << n << " of " << total;
        } else {
          ASSERT_EQ(statusName(result.report.status), std::string("OutOfMemory")) << n;
          expectNothing(result);
          ++failed;
          ++injected.count;
        }
      }
      ASSERT_EQ(fault::outstandingBytes(), before) << "allocation " << n << " of " << total;
    }
    EXPECT_GT(failed, 50);
    RunContext run;
    EXPECT_EQ(fingerprint(compute(c, run)), expected) << "the run after the failures";
  }
}

INSTANTIATE_TEST_SUITE_P(Fault, EveryAllocation, testing::Bool(),
                         [](const auto& which) { return which.param ? "andAllLater" : "once"; });

TEST(Fault, bad_input_24_cancel_at_every_checkpoint_gives_all_back) {
  Injected injected{"cancels"};
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    RunContext whole;
    const std::uint64_t expected = fingerprint(compute(c, whole));
    const auto total = static_cast<std::int64_t>(CheckpointHook::passed(whole));
    ASSERT_GT(total, 10);
    const std::int64_t stride = strideFor(total, 150);
    for (std::int64_t n = 1; n <= total; n += stride) {
      const std::int64_t before = fault::outstandingBytes();
      {
        RunContext run;
        CheckpointHook::cancelAt(run, static_cast<std::uint64_t>(n));
        const Result result = compute(c, run);
        ASSERT_EQ(result.report.status, Status::Cancelled) << n << " of " << total;
        expectNothing(result);
        ++injected.count;
      }
      EXPECT_EQ(fault::outstandingBytes(), before) << "checkpoint " << n << " of " << total;
    }
    RunContext run;
    EXPECT_EQ(fingerprint(compute(c, run)), expected);
  }
}

/// Calls `work` with each of its allocations failing in turn, or with a sample of them. `work`
/// returns whether its result is right. It must end with std::bad_alloc or Error, or return the
/// right result all the same. After the next successful call, no more memory may be in use than
/// before (OpenMesh's readers keep what they read last).
template <class Work>
void failEveryAllocation(const std::string& name, const Work& work) {
  SCOPED_TRACE(name);
  ASSERT_TRUE(work());
  fault::arm(0);
  ASSERT_TRUE(work());
  const std::int64_t total = fault::allocations();
  const std::int64_t stride = strideFor(total, 300);
  const std::int64_t before = fault::outstandingBytes();
  Injected injected{"failing allocations of files, checks and estimates"};
  for (std::int64_t n = 1; n <= total; n += stride) {
    bool right = false, thrown = false;
    ++injected.count;
    fault::arm(n);
    try {
      right = work();
    } catch (const std::bad_alloc&) {
      thrown = true;
    } catch (const Error& error) {
      fault::disarm();
      thrown = error.status() != Status::InternalError;
    }
    fault::disarm();
    ASSERT_TRUE(thrown || right) << "allocation " << n << " of " << total << " is not noticed";
    ASSERT_TRUE(work());
    ASSERT_EQ(fault::outstandingBytes(), before) << "allocation " << n << " of " << total;
  }
}

TEST(Fault, FilesGiveAllMemoryBackAndLeaveNoTemporary) {
  const TemporaryFolder folder;
  const TriMesh body = makeBox({0, 0, 0}, {3, 2, 1});
  const std::string table =
      folder.write("m.csv", "t,tx,ty,tz,qx,qy,qz,qw\n0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0.6,0.8\n");
  failEveryAllocation("motion", [&] {
    return readTrajectoryCsv(table, 1, Interpolation::Linear).poses.size() == 2;
  });
  for (const std::string suffix : {"ply", "stl", "obj", "off"}) {
    const std::string path = folder.file("b." + suffix);
    failEveryAllocation("write " + suffix, [&] {
      writeMesh(body, path);
      return std::filesystem::file_size(path) > 150;
    });
    const TriMesh expected = readMesh(path);
    failEveryAllocation("read " + suffix, [&] {
      const TriMesh mesh = readMesh(path);
      return mesh.vertices == expected.vertices && mesh.triangles == expected.triangles;
    });
  }
  EXPECT_EQ(folder.count(), 5u) << "a temporary is left";
}

TEST(Fault, CheckAndEstimateGiveAllMemoryBack) {
  const TriMesh body = makeTorus(2, 0.7, 12, 8);
  failEveryAllocation("check", [&] {
    RunContext run;
    return checkMesh(body, run).passes();
  });
  failEveryAllocation("estimate", [&] { return estimate(body, shift(), {}).triangles > 0; });
}

TEST(Fault, bad_input_36_every_written_byte) {
  if (!FileSizeLimit::available()) GTEST_SKIP() << "this system does not limit files";
  const TemporaryFolder folder;
  const TriMesh body = makeBox({0, 0, 0}, {3, 2, 1});
  Injected injected{"failing writes"};
  for (const char* suffix : {"ply", "stl", "obj", "off"}) {
    const std::string path = folder.write(std::string("b.") + suffix, "old");
    writeMesh(body, folder.file(std::string("whole.") + suffix));
    const auto size = std::filesystem::file_size(folder.file(std::string("whole.") + suffix));
    for (std::uint64_t bytes = 0; bytes < size; bytes += 1 + bytes / 100) {
      std::string code;
      try {
        const FileSizeLimit limit(bytes);
        writeMesh(body, path);
      } catch (const Error& error) {
        code = statusName(error.status()) + ("/" + error.code());
      }
      ++injected.count;
      ASSERT_EQ(code, "ExportFailed/WriteFailed") << suffix << " after " << bytes << " bytes";
      ASSERT_EQ(TemporaryFolder::read(path), "old");
    }
    writeMesh(body, path);
    EXPECT_EQ(readMesh(path).triangles.size(), body.triangles.size());
  }
  EXPECT_EQ(folder.count(), 8u) << "a temporary is left";
}

TEST(Fault, OneExceptionOfAnyWorkerArrives) {
  Injected injected{"exceptions in workers"};
  for (const int threads : {1, 2, 8}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    for (const std::size_t bad : {0u, 1u, 499u, 998u, 999u}) {
      std::atomic<int> inside{0};
      std::string text;
      try {
        parallelFor(1000, [&](std::size_t i) {
          ++inside;
          if (i >= bad) {
            --inside;
            throw Error(Status::InternalError, "Planted", "item failed");
          }
          --inside;
        });
      } catch (const Error& error) {
        text = error.what();
      }
      ++injected.count;
      EXPECT_EQ(text, "item failed");
      EXPECT_EQ(inside, 0) << "an item still runs";
    }
  }
}

}  // namespace
}  // namespace swept::test
