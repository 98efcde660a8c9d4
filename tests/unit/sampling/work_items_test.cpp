// The number of tasks into which the CPU sampler divides a union of copies.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/cpu/work_items.h"

#include <gtest/gtest.h>

#include "geometry/body_topology.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

std::vector<WorkItem> itemsOf(const TriMesh& body, std::size_t placements) {
  const BodyTopology topology = buildTopology(body);
  Motion motion;
  motion.placements.resize(placements);
  const GridPlan grid;
  return workItems({body, topology, motion, grid});
}

// Each item keeps a list of the layers of the grid: 73,000 items once took more memory than all
// else.
TEST(WorkItems, UnionsOfAnySizeHaveSomeThousandAtMost) {
  for (const TriMesh& body : {makeBox({0, 0, 0}, {1, 1, 1}), makeTorus(20, 8, 250, 200)}) {
    for (const std::size_t placements : {1u, 300u, 3000u, 5000u, 60000u}) {
      SCOPED_TRACE(placements);
      const std::vector<WorkItem> items = itemsOf(body, placements);
      EXPECT_LE(items.size(), 10000u);
      const bool many = placements * body.triangles.size() > 100000;
      EXPECT_GE(items.size(), many ? 12u : 1u);
      std::size_t copies = 0;
      for (const WorkItem& item : items)
        copies += (item.end - item.begin) * (item.faceEnd - item.faceBegin);
      EXPECT_EQ(copies, placements * body.triangles.size());
    }
  }
}

}  // namespace
}  // namespace swept::test
