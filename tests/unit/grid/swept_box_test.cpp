// The bounding box of a sweep, against the vertices at all placements.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "grid/plan_grid.h"
#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

TEST(SweptBox, IsThatOfAllVerticesAtAllPlacementsToTheLastBit) {
  Random random(5);
  TriMesh point;
  point.vertices = {{3, 4, 5}};
  for (const TriMesh& body : {makeBall({30, -2, 7}, 4, 3), makeCylinder(2, -8, 9, 40), point}) {
    for (const int placements : {1, 7, 3000}) {
      Motion motion;
      Eigen::AlignedBox3d expected;
      for (int k = 0; k < placements; ++k) {
        Placement p;
        const Eigen::Vector3d axis = random.point(1);
        p.rotation =
            Eigen::AngleAxisd(random.number(0, 0.01 * k), axis.normalized()).toRotationMatrix();
        p.translation = random.point(20);
        motion.placements.push_back(p);
        for (const Eigen::Vector3d& v : body.vertices) expected.extend(p.apply(v));
      }
      RunContext run;
      const Eigen::AlignedBox3d box = sweptBox(body, motion, run);
      EXPECT_EQ(box.min(), expected.min());
      EXPECT_EQ(box.max(), expected.max());
    }
  }
}

}  // namespace
}  // namespace swept::test
