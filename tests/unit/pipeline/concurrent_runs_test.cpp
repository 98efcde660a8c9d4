// Several runs at the same time in one process: each gives the same bytes and report as it does
// alone.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include "base/memory.h"
#include "support/process.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

struct Case {
  TriMesh body;
  Trajectory motion;
  Options options;
  int threads;
};

Trajectory turning(double degrees, Interpolation interpolation) {
  return {{poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
           poseOf(1, placement({1, 2, 3}, degrees, {4, -3, 2}))},
          interpolation};
}

std::vector<Case> cases() {
  Options plain;
  plain.resolution = 48;
  plain.backend = Backend::Cpu;
  Options simplified = plain;
  simplified.tolerance = 0.05;
  Options grown = plain;
  grown.offset = 0.3;
  return {{makeTorus(3, 1, 32, 16), turning(70, Interpolation::Linear), plain, 1},
          {makeBall({1, 2, 3}, 2, 4), turning(20, Interpolation::Screw), simplified, 2},
          {makeBox({-3, -2, -1}, {3, 2, 1}), turning(110, Interpolation::Linear), grown, 3}};
}

/// The part of a result that must be the same in two runs of one case: all but times and memory,
/// which are measured.
struct Outcome {
  std::string bytes, report;
  bool operator==(const Outcome&) const = default;
};

Outcome outcomeOf(const Case& c) {
  RunContext run;
  run.threads = c.threads;
  Result result = compute(c.body, c.motion, c.options, run);
  Outcome outcome;
  const auto add = [&](const void* data, std::size_t size) {
    outcome.bytes.append(static_cast<const char*>(data), size);
  };
  for (const auto& v : result.mesh.vertices) add(v.data(), 3 * sizeof(double));
  for (const auto& t : result.mesh.triangles) add(t.data(), 3 * sizeof(std::int32_t));
  for (const double time : result.contactTime) add(&time, sizeof time);
  for (StageSeconds& stage : result.report.seconds) stage.seconds = 0;
  result.report.peakMemoryBytes = 0;
  outcome.report = toJson(result.report);
  return outcome;
}

TEST(ConcurrentRuns, GiveTheBytesAndReportsThatTheyGiveAlone) {
  const std::vector<Case> all = cases();
  std::vector<Outcome> alone;
  for (const Case& c : all) alone.push_back(outcomeOf(c));
  constexpr int kRounds = 3;
  // Two threads run each case several times. All threads run at once.
  std::vector<std::thread> threads;
  std::atomic<int> same{0};
  for (int copy = 0; copy < 2; ++copy) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      threads.emplace_back([&, i] {
        for (int round = 0; round < kRounds; ++round) same += outcomeOf(all[i]) == alone[i];
      });
    }
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(same, 2 * kRounds * static_cast<int>(all.size()));
}

TEST(ConcurrentRuns, AFailureOrCancellationStaysWithItsRun) {
  const std::vector<Case> all = cases();
  const Outcome alone = outcomeOf(all[0]);
  std::atomic<bool> stop{false};
  std::atomic<int> refused{0}, cancelled{0};
  std::thread failing([&] {
    while (!stop) {
      RunContext run;
      refused += compute(TriMesh{}, all[1].motion, all[1].options, run).report.code == "EmptyMesh";
    }
  });
  std::thread cancelling([&] {
    while (!stop) {
      RunContext run;
      run.cancel();
      cancelled += compute(all[2].body, all[2].motion, all[2].options, run).report.status ==
                   Status::Cancelled;
    }
  });
  for (int round = 0; round < 3; ++round) EXPECT_EQ(outcomeOf(all[0]), alone);
  stop = true;
  failing.join();
  cancelling.join();
  EXPECT_GT(refused, 0);
  EXPECT_GT(cancelled, 0);
}

/// A run that is limited to one thread does not limit other work of the process.
TEST(ConcurrentRuns, LeaveTheProcessAsItIs) {
  using Control = tbb::global_control;
  const std::size_t before = Control::active_value(Control::max_allowed_parallelism);
  const Case c = cases()[0];
  std::atomic<bool> done{false};
  std::thread running([&] {
    outcomeOf(c);
    done = true;
  });
  std::size_t least = before;
  while (!done) {
    least = std::min(least, Control::active_value(Control::max_allowed_parallelism));
  }
  running.join();
  EXPECT_EQ(least, before);
}

TEST(ConcurrentRuns, PeakMemoryIsSeenWhereTheProcessWasLargerBefore) {
  if (residentMemoryBytes() == 0) GTEST_SKIP() << "this system does not say";
  constexpr std::size_t kLarge = 400'000'000, kSmall = 100'000'000;
  { const ResidentPages large(kLarge); }
  returnFreeMemory();
  const MemoryWatch watch;
  const std::uint64_t before = residentMemoryBytes();
  {
    const ResidentPages small(kSmall);
    std::this_thread::sleep_for(std::chrono::milliseconds(100 * kMemoryMilliseconds));
  }
  EXPECT_GE(watch.peakBytes(), before + kSmall * 9 / 10);
  EXPECT_LT(watch.peakBytes(), before + kLarge * 9 / 10);
}

}  // namespace
}  // namespace swept::test
