// Lets the test program use more threads than there are cores: it raises the limit of the
// process, which the library never changes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <memory>

namespace swept::test {
namespace {

/// Largest number of threads that a test of determinism uses.
constexpr std::size_t kMaxTestThreads = 8;

class MoreThreads : public testing::Environment {
 public:
  void SetUp() override {
    control_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     kMaxTestThreads);
  }
  void TearDown() override { control_.reset(); }

 private:
  std::unique_ptr<tbb::global_control> control_;
};

// Owned by the framework.
[[maybe_unused]] const testing::Environment* const environment =
    testing::AddGlobalTestEnvironment(new MoreThreads);

}  // namespace
}  // namespace swept::test
