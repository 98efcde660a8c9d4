// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <vector>

namespace swept {
namespace {

// Two tasks fail at once. The loops of all other tasks still do all of their work.
TEST(Parallel, AFailureCutsNoLoopOfOtherTasksShort) {
  constexpr std::size_t kTasks = 16, kItems = 2000;
  for (int round = 0; round < 50; ++round) {
    std::vector<std::size_t> done(kTasks, kItems);
    const auto work = [&](std::size_t task) {
      if (task == 7) throw std::runtime_error("seven");
      if (task == 9) throw std::runtime_error("nine");
      std::vector<int> marks(kItems, 0);
      parallelFor(kItems, [&](std::size_t i) { marks[i] = 1; });
      done[task] = static_cast<std::size_t>(std::accumulate(marks.begin(), marks.end(), 0));
    };
    try {
      parallelFor(kTasks, work);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "seven");  // the failing task with the lowest index
    }
    for (std::size_t task = 0; task < kTasks; ++task) EXPECT_EQ(done[task], kItems) << task;
  }
}

}  // namespace
}  // namespace swept
