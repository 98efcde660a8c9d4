// Runs each fuzzed function with the inputs that once showed a fault in it (tests/fuzz/cases), and
// with the inputs from which fuzzing starts (tests/fuzz/seeds).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz/targets.h"

namespace swept::test {
namespace {

using Target = void (*)(const std::uint8_t*, std::size_t);

void runAll(const std::string& name, Target target) {
  const std::filesystem::path folder = std::filesystem::path(SWEPT_SOURCE_DIR) / "tests/fuzz";
  int count = 0;
  for (const char* kind : {"cases", "seeds"}) {
    if (!std::filesystem::exists(folder / kind / name)) continue;  // nothing found there so far
    for (const auto& entry : std::filesystem::directory_iterator(folder / kind / name)) {
      SCOPED_TRACE(entry.path().filename().string());
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
      EXPECT_NO_THROW(target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
      ++count;
    }
  }
  EXPECT_GT(count, 0) << "no case in " << folder;
}

TEST(FuzzCases, Envelope) { runAll("envelope", fuzz::envelope); }
TEST(FuzzCases, Preview) { runAll("preview", fuzz::preview); }
TEST(FuzzCases, MotionFile) { runAll("motionFile", fuzz::motionFile); }
TEST(FuzzCases, MeshFile) { runAll("meshFile", fuzz::meshFile); }
TEST(FuzzCases, Clearance) { runAll("clearance", fuzz::clearance); }
#ifdef HAVE_SWEPT_SOLID
TEST(FuzzCases, Solid) { runAll("solid", fuzz::solid); }
#endif

}  // namespace
}  // namespace swept::test
