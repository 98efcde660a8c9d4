// Union-find, compared with a simple relabelling. Sets are joined in any order, by any number of
// threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/union_find.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "base/parallel.h"

namespace swept::test {
namespace {

template <class Number>
class UnionFind : public ::testing::Test {};
using Numbers = ::testing::Types<std::int32_t, std::uint32_t>;
TYPED_TEST_SUITE(UnionFind, Numbers);

TYPED_TEST(UnionFind, RootsAreTheSmallestMembersForAnyNumberOfThreads) {
  using Number = TypeParam;
  for (const std::size_t members : {1, 10, 3000}) {
    for (const std::size_t joins : {members / 3, members, 2 * members}) {
      std::mt19937 random(static_cast<unsigned>(members + joins));
      std::uniform_int_distribution<Number> pick(0, static_cast<Number>(members) - 1);
      std::vector<std::pair<Number, Number>> pairs;
      for (std::size_t n = 0; n < joins; ++n) pairs.emplace_back(pick(random), pick(random));
      std::vector<Number> expected = singleSets<Number>(members);
      for (const auto& [a, b] : pairs) {
        const auto [low, high] = std::minmax(expected[a], expected[b]);
        std::replace(expected.begin(), expected.end(), Number{high}, Number{low});
      }
      for (const int threads : {1, 2, 3, 8}) {
        std::shuffle(pairs.begin(), pairs.end(), random);
        std::vector<Number> parent = singleSets<Number>(members);
        tbb::task_arena(threads).execute([&] {
          parallelBlocks(pairs.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
              unite(parent, pairs[n].first, pairs[n].second);
            }
          });
        });
        for (std::size_t i = 0; i < members; ++i) {
          EXPECT_EQ(findRoot(parent, static_cast<Number>(i)), expected[i]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace swept::test
