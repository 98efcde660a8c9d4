// Cells whose triangles are replaced so that none intersect: every pattern of one cell, and
// random grids in which nearly every cell has to be rebuilt.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/rebuild.h"

#include <gtest/gtest.h>

#include <set>

#include "contour/mend/cell_patch.h"
#include "geometry/self_intersections.h"
#include "unit/contour/synthetic_grid.h"

namespace swept::test {
namespace {

double unit(std::uint64_t seed) { return static_cast<double>(mix(seed) >> 11) * 0x1p-53; }

/// A cell with given signs at its corners and given doubly crossed edges. Its crossings are random.
struct DrawnCell {
  Cell cell;
  std::vector<Crossing> crossings;

  DrawnCell(std::uint32_t insideCorners, std::uint32_t walls, std::uint64_t seed) {
    const auto add = [&](int slot, double fraction) {
      cell.mask |= 1u << slot;
      Crossing crossing;
      crossing.fraction = static_cast<float>(fraction);
      for (int n = 0; n < 3; ++n)
        crossing.normal[n] = static_cast<float>(unit(seed + 31 * crossings.size() + n) - 0.5);
      crossing.normal.normalize();
      crossings.push_back(crossing);
    };
    for (int edge = 0; edge < kEdges; ++edge) {
      const bool low = (insideCorners >> cornerOf(edge, 0) & 1u) != 0,
                 high = (insideCorners >> cornerOf(edge, 1) & 1u) != 0;
      cell.first[edge] = static_cast<std::uint32_t>(crossings.size());
      // Nearly every third crossing lies at an end of the edge, or at the other crossing.
      const double first = unit(seed + 1000 + edge), second = unit(seed + 2000 + edge);
      const double from = first < 0.15 ? 0 : first * second,
                   to = second < 0.15 ? from : from + (1 - from) * second;
      if (low != high) add(2 * edge + (low ? 1 : 0), first < 0.15 ? (second < 0.5 ? 0 : 1) : first);
      if (low || high || (walls >> edge & 1u) == 0) continue;
      add(2 * edge, from);
      add(2 * edge + 1, to);
    }
  }
};

/// Returns what is wrong with a patch: empty if it fills all rings, stays in the cell, and no
/// triangles intersect.
std::string faultsOf(const DrawnCell& drawn, bool layered) {
  const Crossing* crossings = drawn.crossings.data();
  const CellBox place{{12.5, -3, 1000}, 0.7};
  const std::vector<CellRing> rings = ringsOf(drawn.cell, crossings);
  std::vector<PatchRing> points;
  TriMesh mesh;
  std::set<std::pair<std::int32_t, std::int32_t>> border;
  for (const CellRing& ring : rings) {
    PatchRing to;
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    Eigen::Vector3d mass = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < ring.slots.size(); ++n) {
      const int slot = ring.slots[n], next = ring.slots[(n + 1) % ring.slots.size()];
      to.points.push_back(place.toWorld(apartPosition(drawn.cell, slot, crossings)));
      to.points.push_back(
          place.toWorld(chordPoint(drawn.cell, ring.faces[n], slot, next, crossings)));
      mass += to.points.back();
    }
    if (!layered) to.vertices = {mass / static_cast<double>(ring.slots.size())};
    mesh.vertices.insert(mesh.vertices.end(), to.points.begin(), to.points.end());
    const auto count = static_cast<std::int32_t>(to.points.size());
    for (std::int32_t k = 0; k < count; ++k) border.emplace(first + k, first + (k + 1) % count);
    points.push_back(std::move(to));
  }
  const CellPatch patch = patchOf(drawn.cell, crossings, rings, points, place);
  if (layered && !patch.layered) return "not layered";
  mesh.vertices.insert(mesh.vertices.end(), patch.added.begin(), patch.added.end());
  mesh.triangles = patch.triangles;
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const auto& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      if (!edges.emplace(t[c], t[(c + 1) % 3]).second) return "an edge is passed twice";
    }
  }
  for (const auto& [a, b] : edges) {
    if (border.contains({a, b}) == edges.contains({b, a})) return "open, or no border of its ring";
  }
  for (const auto& side : border) {
    if (!edges.contains(side)) return "a ring is not filled";
  }
  for (const Eigen::Vector3d& p : patch.added) {
    const Eigen::Vector3d local = place.toLocal(p);
    if (local.minCoeff() <= 0 || local.maxCoeff() >= 1) return "outside the cell";
  }
  RunContext run;
  const SelfIntersections found = findSelfIntersections(mesh, {}, run);
  return found.count == 0 ? "" : std::to_string(found.count) + " pairs meet";
}

/// Calls use() for all patterns of signs with all choices of doubly crossed edges.
template <class Use>
void forAllCells(const Use& use) {
  for (std::uint32_t corners = 0; corners < 256; ++corners) {
    std::uint32_t free = 0;  // edges with both ends outside, which may be doubly crossed
    for (int edge = 0; edge < kEdges; ++edge) {
      if ((corners >> cornerOf(edge, 0) & 1u) == 0 && (corners >> cornerOf(edge, 1) & 1u) == 0)
        free |= 1u << edge;
    }
    for (std::uint32_t walls = free;; walls = (walls - 1) & free) {
      if ((corners != 0 && corners != 255) || walls != 0) use(corners, walls);
      if (walls == 0) break;
    }
  }
}

TEST(CellPatch, EveryConfigurationIsFilledWithoutPairs) {
  std::int64_t cells = 0, failed = 0;
  forAllCells([&](std::uint32_t corners, std::uint32_t walls) {
    for (const bool layered : {true, false}) {
      const std::uint64_t seed = mix(corners * 4096ull + walls);
      ++cells;
      const std::string fault = faultsOf(DrawnCell(corners, walls, seed), layered);
      if (fault.empty() || ++failed > 5) continue;
      ADD_FAILURE() << "corners " << corners << ", walls " << walls
                    << (layered ? ", layered: " : ": ") << fault;
    }
  });
  EXPECT_EQ(failed, 0) << "of " << cells;
}

TEST(CellRings, RunFromFaceToFace) {
  forAllCells([&](std::uint32_t corners, std::uint32_t walls) {
    const DrawnCell drawn(corners, walls, mix(corners + 77ull * walls));
    std::uint32_t seen = 0;
    for (const CellRing& ring : ringsOf(drawn.cell, drawn.crossings.data())) {
      for (std::size_t n = 0; n < ring.slots.size(); ++n) {
        EXPECT_NE(ring.faces[n], ring.faces[(n + 1) % ring.slots.size()]);
        EXPECT_EQ(seen >> ring.slots[n] & 1u, 0u);
        seen |= 1u << ring.slots[n];
      }
    }
    ASSERT_EQ(seen, drawn.cell.mask) << corners << " " << walls;
  });
}

TEST(RebuildCells, GridsOfChanceAreFreeOfPairs) {
  RunContext run;
  std::int64_t before = 0;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    constexpr std::int32_t kPoints = 12;
    SyntheticGrid synthetic(kPoints, kPoints, kPoints);
    for (std::int32_t i = 1; i + 1 < kPoints; ++i) {
      for (std::int32_t j = 1; j + 1 < kPoints; ++j) {
        for (std::int32_t k = 1; k + 1 < kPoints; ++k) {
          const std::uint64_t draw =
              mix(seed << 32 | static_cast<std::uint64_t>(i << 16 | j << 8 | k));
          if (draw % 100 < 10 * (seed % 4)) synthetic.setInside(i, j, k);
          for (int axis = 0; axis < 3; ++axis) {
            if ((draw >> (8 + 8 * axis) & 255u) < 40 + 30 * (seed / 4))
              synthetic.setWall(axis, i, j, k);
          }
        }
      }
    }
    const HermiteGrid grid = synthetic.build(SyntheticGrid::Geometry::Random, seed);
    Surface surface = contourUniform(grid, Options{}, run);
    const SelfIntersections found = findSelfIntersections(surface.mesh, {}, run);
    before += found.count;
    const SelfIntersections left = rebuildCells(surface, grid, found, run);
    EXPECT_EQ(left.count, 0) << "grid " << seed;
    EXPECT_EQ(findSelfIntersections(surface.mesh, {}, run).count, 0) << "grid " << seed;
    EXPECT_FALSE(findFaults(surface.mesh).any()) << "grid " << seed;
    EXPECT_EQ(surface.contactTime.size(), surface.mesh.vertices.size());
    EXPECT_EQ(surface.crossingOf.size(), surface.mesh.triangles.size());
  }
  EXPECT_GT(before, 10000) << "the grids test nothing";
}

}  // namespace
}  // namespace swept::test
