// Parts of the GPU backend that need no device: bricks, chunks and the embedded shaders.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "sampling/gl/brick_plan.h"
#include "sampling/gl/shader_sources.h"
#include "unit/sampling/gl/scene.h"

namespace swept::test {
namespace {

using gl::Brick;

gl::Limits limits(std::int64_t storageBytes) {
  gl::Limits l;
  l.storageBytes = storageBytes;
  return l;
}

TEST(GlPlan, BricksCoverEveryLatticePointOnceWithinAllLimits) {
  const std::array<std::int32_t, 3> sizes[] = {
      {5, 7, 9}, {33, 64, 65}, {130, 40, 300}, {1, 1, 1}, {8191, 3, 40}};
  for (const auto& points : sizes) {
    for (const std::uint64_t budget : {12u, 400u, 20'000u, 1u << 20}) {
      for (const std::int64_t storage : {12, 4096, 1 << 27}) {
        GridPlan grid;
        grid.points = points;
        const auto bricks = gl::planBricks(grid, limits(storage), budget);
        std::uint64_t covered = 0;
        for (std::size_t n = 0; n < bricks.size(); ++n) {
          const Brick& b = bricks[n];
          EXPECT_LE(b.markWords() * 4, budget);
          EXPECT_LE(b.markWords() * 4, static_cast<std::uint64_t>(storage));
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(b.low[axis], 0);
            EXPECT_LE(b.low[axis] + b.size[axis], points[axis]);
          }
          covered += std::uint64_t{1} * b.size[0] * b.size[1] * b.size[2];
          if (n > 0) {
            EXPECT_LT(bricks[n - 1].low, b.low);  // distinct, in ascending order
          }
        }
        EXPECT_EQ(covered, std::uint64_t{1} * points[0] * points[1] * points[2]);
      }
    }
  }
}

TEST(GlPlan, TheLargestGridFitsTheLeastLimitsOfOpenGl45) {
  GridPlan grid;
  grid.points = {8191, 8191, 8191};
  const auto bricks = gl::planBricks(grid, limits(1 << 27), 96 << 20);
  for (const Brick& b : bricks) EXPECT_LE(b.markWords(), std::uint64_t{24} << 20);
  EXPECT_LT(bricks.size(), 20'000u);
}

TEST(GlPlan, LimitsBelowTheLeastAreRefused) {
  GridPlan grid;
  grid.points = {8, 8, 8};
  EXPECT_THROW(gl::planBricks(grid, limits(8), 1000), Error);
  EXPECT_THROW(gl::planBricks(grid, limits(1 << 27), 8), Error);
}

TEST(GlPlan, ChunksHoldEveryElementOnceAndThePlacementsItNeeds) {
  for (const bool cull : {true, false}) {
    for (const auto interpolation : {Interpolation::None, Interpolation::Linear}) {
      Scene scene(makeTorus(3, 1, 12, 8), turningPath(5, interpolation), 24);
      scene.cull = cull;
      const SamplerInput input = scene.input();
      const auto source = gl::planElements(input);
      EXPECT_EQ(source.culling != gl::ElementSource::kNone, cull && scene.motion.continuous);
      for (const std::uint64_t bytes : {1u, 500u, 3000u, 1u << 20}) {
        std::uint64_t next = 0;
        for (const auto& chunk : gl::planChunks(source, bytes)) {
          EXPECT_EQ(chunk.first, next);
          next += chunk.count;
          for (std::uint64_t n = chunk.first; n < next; ++n) {
            const SweptElement element = source.at(n);
            EXPECT_GE(element.placement, chunk.placementBase);
            if (element.isSidePatch() && element.placement + 1 == source.placements) continue;
            EXPECT_LT(element.placement + (element.isSidePatch() ? 1 : 0),
                      chunk.placementBase + chunk.placementCount);
          }
        }
        EXPECT_EQ(next, source.count());
      }
    }
  }
}

TEST(GlPlan, EmbeddedShadersAreTheFiles) {
  for (const char* name :
       {"common.glsl", "element.glsl", "exact.glsl", "mark.glsl", "winner.glsl", "sample.comp"}) {
    std::ifstream file(std::string(SWEPT_SOURCE_DIR) + "/shaders/" + name);
    std::stringstream text;
    text << file.rdbuf();
    ASSERT_FALSE(text.str().empty()) << name;
    ASSERT_NE(gl::shaderSource(name), nullptr) << name;
    EXPECT_EQ(text.str(), gl::shaderSource(name));
  }
  EXPECT_EQ(gl::shaderSource("no such file"), nullptr);
}

}  // namespace
}  // namespace swept::test
