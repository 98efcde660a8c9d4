// Tests the consistent components with every configuration: the mesh is closed, edge- and
// vertex-manifold. Blocks of lattice points stand in a large grid, each in a shell of outside
// points, so that one run of contouring tests thousands of configurations.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <set>

#include "contour/components.h"
#include "contour/surface.h"
#include "support/sampled.h"
#include "unit/contour/synthetic_grid.h"

namespace swept::test {
namespace {

using Geometry = SyntheticGrid::Geometry;

Faults contourFaults(const SyntheticGrid& synthetic, Geometry geometry, std::uint64_t seed) {
  RunContext run;
  return findFaults(contourUniform(synthetic.build(geometry, seed), Options{}, run).mesh);
}

/// A block of bx x by x bz lattice points with its doubly crossed edges.
struct Block {
  std::uint64_t insideBits = 0;  ///< point (i, j, k) has bit (i * by + j) * bz + k
  std::uint64_t wallBits = 0;    ///< in the order of blockEdges()
};

struct BlockShape {
  std::int32_t bx, by, bz;
  int pointCount() const { return bx * by * bz; }
};

struct BlockEdge {
  int axis;
  std::int32_t i, j, k;
  int low, high;  ///< bit numbers of both ends in insideBits
};

std::vector<BlockEdge> blockEdges(const BlockShape& s) {
  std::vector<BlockEdge> edges;
  const auto bit = [&](int i, int j, int k) { return (i * s.by + j) * s.bz + k; };
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i + (axis == 0) < s.bx; ++i) {
      for (int j = 0; j + (axis == 1) < s.by; ++j) {
        for (int k = 0; k + (axis == 2) < s.bz; ++k) {
          edges.push_back({axis, i, j, k, bit(i, j, k),
                           bit(i + (axis == 0), j + (axis == 1), k + (axis == 2))});
        }
      }
    }
  }
  return edges;
}

/// Puts blocks into a cubic grid, and contours the grid whenever it is full.
class BlockTester {
 public:
  BlockTester(BlockShape shape, Geometry geometry, std::uint64_t seed)
      : shape_(shape), geometry_(geometry), seed_(seed), edges_(blockEdges(shape)) {
    clear();
  }

  void add(const Block& block) {
    const std::int32_t n = static_cast<std::int32_t>(blocks_.size());
    const std::int32_t oi = 1 + n / (kSide * kSide) * (shape_.bx + 1);
    const std::int32_t oj = 1 + n / kSide % kSide * (shape_.by + 1);
    const std::int32_t ok = 1 + n % kSide * (shape_.bz + 1);
    for (int p = 0; p < shape_.pointCount(); ++p) {
      if (!(block.insideBits >> p & 1u)) continue;
      grid_->setInside(oi + p / (shape_.by * shape_.bz), oj + p / shape_.bz % shape_.by,
                       ok + p % shape_.bz);
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!(block.wallBits >> e & 1u)) continue;
      grid_->setWall(edges_[e].axis, oi + edges_[e].i, oj + edges_[e].j, ok + edges_[e].k);
    }
    blocks_.push_back(block);
    if (blocks_.size() == static_cast<std::size_t>(kSide) * kSide * kSide) flush();
  }

  void flush() {
    if (blocks_.empty()) return;
    const Faults faults = contourFaults(*grid_, geometry_, seed_);
    tested_ += static_cast<std::int64_t>(blocks_.size());
    total_.openEdges += faults.openEdges;
    total_.nonManifoldEdges += faults.nonManifoldEdges;
    total_.badVertices += faults.badVertices;
    total_.degenerate += faults.degenerate;
    if (faults.any()) {
      const auto at = [&](int axis, int size) {
        return static_cast<std::size_t>((faults.first[axis] - 0.5) / (size + 1));
      };
      const std::size_t n =
          (at(0, shape_.bx) * kSide + at(1, shape_.by)) * kSide + at(2, shape_.bz);
      const Block& bad = blocks_.at(std::min(n, blocks_.size() - 1));
      ADD_FAILURE() << "near block: inside bits 0x" << std::hex << bad.insideBits
                    << ", wall bits 0x" << bad.wallBits << ", seed " << std::dec << seed_;
    }
    clear();
  }

  void expectNone(std::int64_t configurations) {
    flush();
    EXPECT_EQ(tested_, configurations);
    EXPECT_EQ(total_.openEdges, 0);
    EXPECT_EQ(total_.nonManifoldEdges, 0);
    EXPECT_EQ(total_.badVertices, 0);
    EXPECT_EQ(total_.degenerate, 0);
  }
  const std::vector<BlockEdge>& edges() const { return edges_; }

 private:
  static constexpr std::int32_t kSide = 20;
  void clear() {
    blocks_.clear();
    grid_ = std::make_unique<SyntheticGrid>(
        kSide * (shape_.bx + 1) + 1, kSide * (shape_.by + 1) + 1, kSide * (shape_.bz + 1) + 1);
  }

  BlockShape shape_;
  Geometry geometry_;
  std::uint64_t seed_;
  std::vector<BlockEdge> edges_;
  std::unique_ptr<SyntheticGrid> grid_;
  std::vector<Block> blocks_;
  std::int64_t tested_ = 0;
  Faults total_;
};

/// Returns the edges of a block with both ends outside: these may be doubly crossed.
std::vector<int> crossableEdges(const std::vector<BlockEdge>& edges, std::uint64_t inside) {
  std::vector<int> positions;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!(inside >> edges[e].low & 1u) && !(inside >> edges[e].high & 1u)) {
      positions.push_back(static_cast<int>(e));
    }
  }
  return positions;
}

std::uint64_t spread(std::uint64_t bits, const std::vector<int>& positions) {
  std::uint64_t out = 0;
  for (std::size_t p = 0; p < positions.size(); ++p) {
    if (bits >> p & 1u) out |= 1ull << positions[p];
  }
  return out;
}

/// Calls use() with single cells: all patterns of signs, each with all choices of doubly crossed
/// edges. They include all 2^12 sets of crossed edges. Returns the number of cells.
std::int64_t everyCell(const std::function<void(const Block&)>& use) {
  const auto edges = blockEdges({2, 2, 2});
  std::int64_t count = 0;
  for (std::uint64_t inside = 0; inside < 256; ++inside) {
    const auto positions = crossableEdges(edges, inside);
    for (std::uint64_t bits = 0; bits < 1ull << positions.size(); ++bits, ++count) {
      use({inside, spread(bits, positions)});
    }
  }
  return count;
}

}  // namespace

TEST(ComponentsExhaustive, EveryCellConfigurationIsReached) {
  // Crossed edges as a 12-bit number: those with one crossing and those with two.
  const auto edges = blockEdges({2, 2, 2});
  std::set<std::uint64_t> configurations;
  everyCell([&](const Block& block) {
    std::uint64_t bits = block.wallBits;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const bool low = block.insideBits >> edges[e].low & 1u;
      const bool high = block.insideBits >> edges[e].high & 1u;
      if (low != high) bits |= 1ull << e;
    }
    configurations.insert(bits);
  });
  EXPECT_EQ(configurations.size(), 4096u);
}

TEST(ComponentsExhaustive, EveryCell) {
  for (int seed = 0; seed < sampled(5, 4); ++seed) {
    BlockTester tester({2, 2, 2}, seed == 0 ? Geometry::Regular : Geometry::Random,
                       static_cast<std::uint64_t>(seed));
    const std::int64_t count = everyCell([&](const Block& block) { tester.add(block); });
    tester.expectNone(count);
  }
}

/// Every pairing of every cell closes to loops; a loop is one component.
TEST(ComponentsExhaustive, ComponentsAreSingleLoops) {
  std::vector<Crossing> crossings(kSlots);
  std::int64_t ambiguous = 0;
  std::uint64_t seed = 1;
  everyCell([&](const Block& block) {
    // No crossings.
    if (block.insideBits == 255 || (block.insideBits | block.wallBits) == 0) return;
    Cell cell;
    const auto bit = [](int a, int b, int c, int axis) {
      int p[3];
      p[axis] = a;
      p[(axis + 1) % 3] = b;
      p[(axis + 2) % 3] = c;
      return (p[0] * 2 + p[1]) * 2 + p[2];
    };
    std::uint32_t next = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int place = 0; place < 4; ++place) {
        const int ob = place & 1, oc = place >> 1;
        const int edge = edgeOf(axis, ob, oc);
        const int low = bit(0, ob, oc, axis), high = bit(1, ob, oc, axis);
        const bool lowIn = block.insideBits >> low & 1u, highIn = block.insideBits >> high & 1u;
        const auto edges = blockEdges({2, 2, 2});
        bool wall = false;
        for (std::size_t e = 0; e < edges.size(); ++e) {
          wall |= edges[e].low == low && edges[e].high == high && (block.wallBits >> e & 1u);
        }
        cell.first[edge] = next;
        std::uint32_t sides = wall ? 3u : lowIn != highIn ? (lowIn ? 2u : 1u) : 0u;
        cell.mask |= sides << (2 * edge);
        next += static_cast<std::uint32_t>(std::popcount(sides));
      }
    }
    for (Crossing& c : crossings) {
      seed = mix(seed);
      c.fraction = static_cast<float>(seed % 997) / 997.0f;
      c.normal = Eigen::Vector3d(static_cast<double>(seed >> 10 & 1023) - 511.5,
                                 static_cast<double>(seed >> 20 & 1023) - 511.5,
                                 static_cast<double>(seed >> 30 & 1023) - 511.5)
                     .normalized()
                     .cast<float>();
    }
    int degree[kSlots] = {};
    std::array<int, kSlots> parent;
    for (int s = 0; s < kSlots; ++s) parent[s] = s;
    const auto root = [&](int s) {
      while (parent[s] != s) s = parent[s];
      return s;
    };
    for (int face = 0; face < kFaces; ++face) {
      const FacePairs pairs = pairFace(cell, face, crossings.data());
      ASSERT_EQ(2 * pairs.count, faceCrossings(cell.mask, face));
      ambiguous += pairs.count > 1;
      for (int p = 0; p < pairs.count; ++p) {
        for (const int slot : pairs.slots[p]) ++degree[slot];
        parent[root(pairs.slots[p][0])] = root(pairs.slots[p][1]);
      }
    }
    ComponentFinder finder(ComponentMethod::Consistent);
    Components found;
    finder.find(cell, crossings.data(), found);
    std::set<int> roots;
    for (int s = 0; s < kSlots; ++s) {
      ASSERT_EQ(found.of[s] >= 0, cell.has(s));
      if (!cell.has(s)) continue;
      ASSERT_EQ(degree[s], 2);  // so each linked set of slots is a single loop
      roots.insert(root(s));
      for (int r = 0; r < s; ++r) {
        ASSERT_TRUE(!cell.has(r) || (found.of[r] == found.of[s]) == (root(r) == root(s)));
      }
    }
    ASSERT_EQ(static_cast<int>(roots.size()), found.count);
  });
  EXPECT_GT(ambiguous, 10000);
}

TEST(ComponentsExhaustive, EveryFacePair) {
  const BlockShape shapes[] = {{3, 2, 2}, {2, 3, 2}, {2, 2, 3}};
  for (int seed = 0; seed < sampled(9, 3); ++seed) {
    BlockTester tester(shapes[seed % 3], seed == 0 ? Geometry::Regular : Geometry::Random,
                       static_cast<std::uint64_t>(seed));
    for (std::uint64_t inside = 0; inside < 4096; ++inside) tester.add({inside, 0});
    tester.expectNone(4096);
  }
}

/// Choices of doubly crossed edges in two cells whose corners all lie outside: all 2^20 in a long
/// run, otherwise a sample.
TEST(ComponentsExhaustive, FacePairsOfWalls) {
  BlockTester tester({2, 2, 3}, Geometry::Random, 5);
  const std::uint64_t stride = longRun() ? 1 : kUnderSanitizer ? 293 : 31;
  std::int64_t count = 0;
  for (std::uint64_t walls = 0; walls < 1u << 20; walls += stride, ++count) tester.add({0, walls});
  tester.expectNone(count);
}

TEST(ComponentsExhaustive, EveryFourCellsRoundAnEdge) {
  const BlockShape shapes[] = {{3, 3, 2}, {2, 3, 3}, {3, 2, 3}};
  for (std::uint64_t turn = 0; turn < (longRun() ? 3 : 1); ++turn) {
    BlockTester tester(shapes[turn], Geometry::Random, 11 + turn);
    const std::uint64_t stride = longRun() ? 1 : kUnderSanitizer ? 61 : 13;
    std::int64_t count = 0;
    for (std::uint64_t inside = 0; inside < 1u << 18; inside += stride, ++count) {
      tester.add({inside, 0});
    }
    tester.expectNone(count);
  }
}

/// Random signs of 3 x 3 x 3 points (2^27 patterns), and such blocks with doubly crossed edges.
TEST(ComponentsExhaustive, BlocksOfEightCellsSampled) {
  const int count = longRun() ? 4'000'000 : sampled(8'000, 8);
  BlockTester signs({3, 3, 3}, Geometry::Random, 21), walls({3, 3, 3}, Geometry::Random, 22);
  for (int n = 0; n < count; ++n) {
    const auto draw = static_cast<std::uint64_t>(n);
    signs.add({mix(draw) & 0x7ffffffu, 0});
    const std::uint64_t sparse = mix(draw + 1'000'000'007) & mix(draw + 2'000'000'011);
    walls.add({sparse & 0x7ffffffu, mix(draw + 3'000'000'019)});
  }
  signs.expectNone(count);
  walls.expectNone(count);
}

TEST(ComponentsExhaustive, RandomGrids) {
  const double densities[] = {0.1, 0.3, 0.5, 0.7, 0.9};
  for (std::uint64_t n = 0; n < 120; ++n) {
    SyntheticGrid grid(11, 11, 11);
    const double density = densities[n % 5], wallDensity = static_cast<double>(n % 4) * 0.25;
    for (std::int32_t p = 0; p < 11 * 11 * 11; ++p) {
      const std::int32_t i = p / 121, j = p / 11 % 11, k = p % 11;
      const auto chance = [&](std::uint64_t what) {
        return static_cast<double>(mix(n << 32 | static_cast<std::uint64_t>(p) << 3 | what) >> 11) *
               0x1p-53;
      };
      const auto inner = [](std::int32_t x) { return x > 0 && x < 10; };
      if (!inner(i) || !inner(j) || !inner(k)) continue;
      if (chance(0) < density) grid.setInside(i, j, k);
      for (int axis = 0; axis < 3; ++axis) {
        const bool last = (axis == 0 ? i : axis == 1 ? j : k) == 9;
        if (!last && chance(1 + static_cast<std::uint64_t>(axis)) < wallDensity)
          grid.setWall(axis, i, j, k);
      }
    }
    const Faults faults = contourFaults(grid, Geometry::Random, n);
    EXPECT_FALSE(faults.any()) << "grid " << n << ": open " << faults.openEdges << ", non-manifold "
                               << faults.nonManifoldEdges << ", vertices " << faults.badVertices;
  }
}

/// findFaults() can fail: one vertex per cell makes non-manifold edges in such a grid.
TEST(ComponentsExhaustive, PlainDualContouringHasFaults) {
  SyntheticGrid grid(9, 9, 9);
  for (std::int32_t p = 0; p < 343; ++p) {
    if (mix(static_cast<std::uint64_t>(p)) & 1u)
      grid.setInside(1 + p / 49, 1 + p / 7 % 7, 1 + p % 7);
  }
  Options options;
  options.components = ComponentMethod::DualContouring;
  RunContext run;
  const Faults faults =
      findFaults(contourUniform(grid.build(Geometry::Random, 1), options, run).mesh);
  EXPECT_GT(faults.nonManifoldEdges, 0);
}

}  // namespace swept::test
