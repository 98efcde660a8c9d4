// The methods of division into components that serve comparisons (dual marching cubes, equivalence,
// greedy): all configurations of a cell, and cells in which the methods differ.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/methods/methods.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace swept::test {
namespace {

/// Returns a cell with these outside corners and doubly crossed edges.
Cell cellOf(std::uint32_t outside, std::uint32_t walls = 0) {
  Cell cell;
  std::uint32_t next = 0;
  for (int edge = 0; edge < kEdges; ++edge) {
    const bool low = outside >> cornerOf(edge, 0) & 1u, high = outside >> cornerOf(edge, 1) & 1u;
    std::uint32_t sides = 0;
    if (low != high) sides = low ? 1 : 2;
    if (low && high && (walls >> edge & 1u)) sides = 3;
    cell.first[edge] = next;
    cell.mask |= sides << (2 * edge);
    next += static_cast<std::uint32_t>(std::popcount(sides));
  }
  return cell;
}

int used(const Components& c) {
  int n = 0;
  for (const std::int8_t of : c.of) n += of >= 0;
  return n;
}

}  // namespace

TEST(WalkTable, EveryConfigurationHasEachEndOfEachCrossedEdgeOnce) {
  for (std::uint32_t crossed = 0; crossed < 4096; ++crossed) {
    const WalkTable::Entry& entry = walkTable().entries[crossed];
    std::uint32_t all = 0;
    int bits = 0;
    for (int k = 0; k < entry.count; ++k) {
      all |= entry.stops[k];
      bits += std::popcount(entry.stops[k]);
    }
    ASSERT_EQ(bits, 2 * std::popcount(crossed));
    ASSERT_EQ(std::popcount(all), bits);
  }
  EXPECT_EQ(walkTable().entries[0].count, 1);
  EXPECT_EQ(walkTable().entries[4095].count, 8);
}

TEST(DualMarchingCubes, UpToFourComponentsAndEveryCrossing) {
  int most = 0;
  for (std::uint32_t outside = 1; outside < 255; ++outside) {
    const Cell cell = cellOf(outside);
    Components c;
    findDualMarchingCubes(cell, c);
    EXPECT_EQ(used(c), std::popcount(cell.mask));
    most = std::max(most, c.count);
  }
  EXPECT_EQ(most, 4);
}

TEST(DualMarchingCubes, LosesAWallThinnerThanACell) {
  // Four parallel edges, both ends outside, each crossed twice: a thin plate.
  const Cell cell = cellOf(255, 0xf);
  Components c;
  findDualMarchingCubes(cell, c);
  EXPECT_EQ(c.count, 0);
  findEquivalence(cell, c);
  EXPECT_EQ(c.count, 2);  // its two sides
  EXPECT_EQ(used(c), 8);
}

TEST(Equivalence, JoinsTwoCornersThatAWalkConnects) {
  // Two inside corners on a diagonal of the cell: the walk over the outside joins all crossings.
  const Cell cell = cellOf(0xffu & ~(1u << 0 | 1u << 7));
  Components c;
  findEquivalence(cell, c);
  EXPECT_EQ(c.count, 1);
  findDualMarchingCubes(cell, c);
  EXPECT_EQ(c.count, 2);
}

TEST(Greedy, TakesTheInsideWalkWhereItsNormalsAgree) {
  const Cell cell = cellOf(0xffu & ~(1u << 0 | 1u << 7));
  // Around corner 0 the normals point along (1,1,1), around corner 7 along -(1,1,1).
  std::vector<Crossing> crossings(6);
  for (int slot = 0; slot < kSlots; ++slot) {
    if (!cell.has(slot)) continue;
    const bool atZero = cornerOf(slot >> 1, 0) == 0;
    const float s = atZero ? 0.57735f : -0.57735f;
    crossings[cell.crossing(slot)].normal = {s, s, s};
  }
  Components c;
  findGreedy(cell, crossings.data(), c);
  EXPECT_EQ(c.count, 2);
  EXPECT_EQ(used(c), 6);
  for (int slot = 0; slot < kSlots; ++slot) {
    for (int other = 0; other < kSlots; ++other) {
      if (!cell.has(slot) || !cell.has(other)) continue;
      const bool same = (cornerOf(slot >> 1, 0) == 0) == (cornerOf(other >> 1, 0) == 0);
      EXPECT_EQ(c.of[slot] == c.of[other], same);
    }
  }
}

TEST(Greedy, EveryConfigurationIsPartitioned) {
  std::vector<Crossing> crossings(kSlots);
  for (int n = 0; n < kSlots; ++n) {
    crossings[n].normal =
        Eigen::Vector3f(static_cast<float>(n % 5) - 2, static_cast<float>(n % 7) - 3,
                        static_cast<float>(n % 3) - 0.5f)
            .normalized();
  }
  for (std::uint32_t outside = 1; outside < 256; ++outside) {
    for (std::uint32_t walls = 0; walls < 4096; walls += 7) {
      const Cell cell = cellOf(outside, walls);
      Components c;
      findGreedy(cell, crossings.data(), c);
      ASSERT_EQ(used(c), std::popcount(cell.mask));
      ASSERT_LE(c.count, kSlots / 2);
    }
  }
}

}  // namespace swept::test
