// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid/crossing_records.h"

#include <gtest/gtest.h>

#include <random>

namespace swept {
namespace {

// Returns many crossings of few lattice edges, some at the same position, as if faces slid within
// themselves.
std::vector<RecordChunk> crowdedChunks(const GridPlan& grid) {
  std::mt19937 random(7);
  std::vector<RecordChunk> chunks(3);
  for (RecordChunk& chunk : chunks) {
    chunk.elements.resize(40);
    for (int n = 0; n < 20000; ++n) {
      const auto axis = static_cast<int>(random() % 3);
      const auto i = static_cast<std::int32_t>(random() % grid.points[0]);
      const auto j = static_cast<std::int32_t>(random() % grid.points[1]);
      const auto k = static_cast<std::int32_t>(random() % grid.points[2]);
      const double fraction = static_cast<double>(random() % 8) / 8;
      chunk.records.push_back(
          CrossingRecord::make(axis, i, j, k, fraction, static_cast<std::uint32_t>(random() % 40)));
    }
  }
  return chunks;
}

TEST(CrossingRecords, ThinnedChunksGiveTheSameEdges) {
  GridPlan grid;
  grid.points = {5, 7, 70};
  RunContext run;
  std::vector<RecordChunk> whole = crowdedChunks(grid), thinned = whole;
  for (RecordChunk& chunk : thinned) {
    keepEnds(chunk.records, grid);
    EXPECT_LE(chunk.records.size(), 2U * 3 * 5 * 7 * 70);
    EXPECT_GT(chunk.records.size(), 3U * 5 * 7 * 70);
  }
  const MarkedEdges a = sortRecords(whole, grid, run), b = sortRecords(thinned, grid, run);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  EXPECT_EQ(a.elements.size(), b.elements.size());
  for (std::size_t layer = 0; layer < a.layers.size(); ++layer) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(a.layers[layer].columnStart[axis], b.layers[layer].columnStart[axis]);
      const auto &one = a.layers[layer].edges[axis], &other = b.layers[layer].edges[axis];
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t n = 0; n < one.size(); ++n) {
        EXPECT_EQ(one[n].k, other[n].k);
        EXPECT_EQ(one[n].lowFraction, other[n].lowFraction);
        EXPECT_EQ(one[n].highFraction, other[n].highFraction);
        EXPECT_EQ(one[n].lowElement, other[n].lowElement);
        EXPECT_EQ(one[n].highElement, other[n].highElement);
      }
    }
  }
}

}  // namespace
}  // namespace swept
