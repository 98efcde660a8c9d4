// Chains of edges modulo 2: which pieces close a surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/chains.h"

#include <gtest/gtest.h>

namespace swept::step {
namespace {

TEST(Chains, CommonEdgesCancelOut) {
  EXPECT_EQ(sumOf({1, 3, 5}, {2, 3, 6}), (Chain{1, 2, 5, 6}));
  EXPECT_TRUE(sumOf({4, 7}, {4, 7}).empty());
}

// Three faces in a row, each with two edges; the second and third together replace a fourth.
TEST(Chains, FindsThePiecesThatCloseASurface) {
  ChainBasis basis;
  EXPECT_TRUE(basis.add({1, 2}, 10).empty());
  EXPECT_TRUE(basis.add({2, 3}, 11).empty());
  EXPECT_TRUE(basis.add({3, 4}, 12).empty());
  EXPECT_EQ(basis.add({2, 4}, 13), (std::vector<int>{11, 12}));
  Chain open{1, 4};
  EXPECT_EQ(basis.reduce(open), (std::vector<int>{10, 11, 12}));
  EXPECT_TRUE(open.empty());
}

TEST(Chains, AnOpenEdgeThatNoPieceHasStaysOpen) {
  ChainBasis basis;
  basis.add({1, 2}, 10);
  Chain open{1, 5};
  basis.reduce(open);
  EXPECT_FALSE(open.empty());
}

}  // namespace
}  // namespace swept::step
