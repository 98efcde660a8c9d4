// Searches in a tree of boxes, compared with a test of every box.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/box_tree.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cstring>
#include <set>

#include "support/random_numbers.h"

namespace swept::test {
namespace {

using Bounds = BoxTree::Bounds;
using Eigen::Vector3d;

enum class Kind { Even, Points, Flat, Same, ManySizes, FarAway };

std::vector<Bounds> makeBoxes(Random& random, Kind kind, std::size_t count) {
  std::vector<Bounds> boxes(count);
  for (std::size_t i = 0; i < count; ++i) {
    Vector3d centre = random.point(10), half = random.point(0.3).cwiseAbs();
    if (kind == Kind::Points) half.setZero();
    if (kind == Kind::Flat) centre.z() = half.z() = 0;
    if (kind == Kind::Same && i > 0) {
      boxes[i] = boxes[0];
      continue;
    }
    if (kind == Kind::ManySizes) half *= std::pow(10.0, random.number(-5, 1.5));
    if (kind == Kind::FarAway) centre += Vector3d(1e9, -1e9, 1e6);
    boxes[i] = {centre - half, centre + half};
  }
  return boxes;
}

BoxTree treeOf(const std::vector<Bounds>& boxes, BoxTree::Order order) {
  return BoxTree(
      boxes.size(), [&](std::size_t i) { return boxes[i]; }, order);
}

double distanceTo(const Vector3d& p, const Bounds& box) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).norm();
}

bool meet(const Bounds& a, const Bounds& b, double rounding) {
  return (a.low.array() <= b.high.array() + rounding).all() &&
         (b.low.array() <= a.high.array() + rounding).all();
}

using Order = BoxTree::Order;

class BoxTrees : public testing::TestWithParam<std::tuple<Kind, Order>> {
 protected:
  static Kind kind() { return std::get<0>(GetParam()); }
  static Order order() { return std::get<1>(GetParam()); }

  /// Calls use(random, boxes, tree, size of the rounding) for trees of many sizes.
  template <class Use>
  void forTrees(const Use& use) {
    Random random(31);
    for (const std::size_t count : {0, 1, 2, 3, 4, 5, 15, 16, 17, 65, 300, 5000}) {
      SCOPED_TRACE(count);
      const std::vector<Bounds> boxes = makeBoxes(random, kind(), count);
      const BoxTree tree = treeOf(boxes, order());
      const double extent = count > 0 ? (tree.bounds().high - tree.bounds().low).maxCoeff() : 0.0;
      use(random, boxes, tree, 1e-6 * extent);
    }
  }
  Vector3d somewhere(Random& random, const BoxTree& tree) {
    const Vector3d extent = tree.bounds().high - tree.bounds().low + Vector3d::Constant(1e-3);
    // Some points are so far away that their rounding error exceeds the distances between the
    // boxes.
    const double size = random.number(0, 1) < 0.6 ? 0.6 : std::pow(10.0, random.number(0, 6));
    return tree.middle() + random.point(size).cwiseProduct(extent);
  }
};

TEST_P(BoxTrees, HoldEveryItemOnceAndEveryBoxInItsParents) {
  forTrees([&](Random&, const std::vector<Bounds>& boxes, const BoxTree& tree, double rounding) {
    ASSERT_EQ(tree.size(), boxes.size());
    if (boxes.empty()) return;
    std::set<std::int32_t> seen;
    for (std::size_t place = 0; place < tree.size(); ++place) {
      seen.insert(tree.item(place));
      const Bounds& box = boxes[tree.item(place)];
      for (std::int32_t level = 0; level <= tree.root().level; ++level) {
        const auto index = static_cast<std::uint32_t>(place >> (2 * level));
        const BoxTree::Group& group = tree.groupOf({level, index});
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_LE(group.low[axis][index % 4], box.low[axis] - tree.middle()[axis]);
          ASSERT_GE(group.high[axis][index % 4], box.high[axis] - tree.middle()[axis]);
          if (level > 0) continue;
          ASSERT_NEAR(group.low[axis][index % 4], box.low[axis] - tree.middle()[axis],
                      rounding + 1e-30);
        }
      }
    }
    ASSERT_EQ(seen.size(), boxes.size());
    ASSERT_EQ(*seen.rbegin() + 1, static_cast<std::int32_t>(boxes.size()));
  });
}

TEST_P(BoxTrees, FindAllThatMeetABox) {
  forTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoxTree& tree,
               double rounding) {
    for (int n = 0; n < 50; ++n) {
      const Vector3d p = somewhere(random, tree);
      const Vector3d half = (n % 3 == 0 ? 0.0 : 0.2) * (p - tree.middle()).cwiseAbs();
      const Bounds query{p - half, p + half};
      std::set<std::int32_t> found;
      tree.forBox(query.low, query.high,
                  [&](std::uint32_t place) { EXPECT_TRUE(found.insert(tree.item(place)).second); });
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool isFound = found.count(static_cast<std::int32_t>(i)) > 0;
        if (meet(boxes[i], query, 0)) {
          EXPECT_TRUE(isFound);
        }
        if (isFound) {
          EXPECT_TRUE(meet(boxes[i], query, rounding + 1e-6 * (p - tree.middle()).norm()));
        }
      }
    }
  });
}

TEST_P(BoxTrees, FindTheNearest) {
  forTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoxTree& tree, double) {
    for (int n = 0; n < 300; ++n) {
      const Vector3d p = somewhere(random, tree);
      double expected = n % 4 == 0 ? 0.3 : HUGE_VAL;
      double best = expected;
      for (const Bounds& box : boxes) expected = std::min(expected, distanceTo(p, box));
      tree.searchNear(p, best, [&](std::uint32_t place, double& reach) {
        best = std::min(best, distanceTo(p, boxes[tree.item(place)]));
        reach = best;
        return true;
      });
      EXPECT_EQ(best, expected);
    }
  });
}

TEST_P(BoxTrees, EndASearchWhenTold) {
  forTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoxTree& tree, double) {
    int looks = 0;
    tree.searchNear(somewhere(random, tree), HUGE_VAL, [&](std::uint32_t, double&) {
      ++looks;
      return false;
    });
    EXPECT_EQ(looks, boxes.empty() ? 0 : 1);
  });
}

TEST_P(BoxTrees, AreTheSameForAnyNumberOfThreads) {
  Random random(7);
  const std::vector<Bounds> boxes = makeBoxes(random, kind(), 30000);
  const BoxTree first = treeOf(boxes, order());
  for (const int threads : {1, 2, 3, 8}) {
    tbb::task_arena arena(threads);
    const BoxTree tree = arena.execute([&] { return treeOf(boxes, order()); });
    for (std::size_t place = 0; place < boxes.size(); ++place) {
      ASSERT_EQ(tree.item(place), first.item(place));
    }
    for (std::int32_t level = 0; level <= tree.root().level; ++level) {
      for (std::uint32_t i = 0; i < tree.count(level); i += 4) {
        ASSERT_EQ(std::memcmp(&tree.groupOf({level, i}), &first.groupOf({level, i}),
                              sizeof(BoxTree::Group)),
                  0);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, BoxTrees,
                         testing::Combine(testing::Values(Kind::Even, Kind::Points, Kind::Flat,
                                                          Kind::Same, Kind::ManySizes,
                                                          Kind::FarAway),
                                          testing::Values(Order::Curve, Order::Medians)));

}  // namespace
}  // namespace swept::test
