// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/cpu/deep_inside.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "geometry/mesh_parts.h"
#include "sampling/exact_element.h"

namespace swept {
namespace {

/// The number of whole copies is the number of placements divided by kPlacementsPerCopy, but at
/// most kMaxWholeCopies. A motion with merged steps has few placements for the length of its path,
/// so the divisor is kMergedPerCopy. With 128 instead of 32, sampling two wheels along 124,992
/// poses, of which 2,153 remain after merging, takes 1.6 times as long. If the number of copies is
/// below kMinCopies, none are sampled. If it is kWithExtreme or more, the copies include the
/// placements farthest along many directions.
constexpr std::size_t kPlacementsPerCopy = 128, kMergedPerCopy = 32, kMinCopies = 8,
                      kWithExtreme = 176, kMaxWholeCopies = 256;
/// The map is used only if it hides at least this fraction of the crossings of kTrials other
/// copies. For thin parts that travel far, the map hides little, and its queries take time.
constexpr double kMinHidden = 0.5;
constexpr std::size_t kTrials = 8;

bool hidesEnough(const SamplerInput& input, const InsideMap& inside) {
  const std::size_t placements = input.motion.placements.size();
  std::size_t all = 0, hidden = 0;
  for (std::size_t n = 0; n < kTrials; ++n) {
    const auto k = static_cast<std::uint32_t>((2 * n + 1) * placements / (2 * kTrials));
    for (std::uint32_t f = 0; f < input.body.triangles.size(); ++f) {
      elementCrossings(
          input, {f, k},
          [&](int axis, std::int32_t i, std::int32_t j, std::int32_t at, double fraction) {
            ++all;
            hidden += inside.hides(axis, i, j, at, fraction);
          });
    }
  }
  return static_cast<double>(hidden) >= kMinHidden * static_cast<double>(all);
}

/// The positions of four points of the body at every placement. They suffice to compare placements.
class PointPositions {
 public:
  PointPositions(const SamplerInput& input) {
    const Eigen::AlignedBox3d box = boxOf(input.body);
    const Eigen::Vector3d half = box.sizes() / 2;
    at_.resize(input.motion.placements.size());
    parallelBlocks(at_.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const Placement& p = input.motion.placements[k];
        at_[k][0] = p.apply(box.center()).cast<float>();
        for (int axis = 0; axis < 3; ++axis) {
          at_[k][1 + axis] = at_[k][0] + (p.rotation.col(axis) * half[axis]).cast<float>();
        }
      }
    });
  }

  /// For each of some directions, adds the placements that carry a point of the body farthest in
  /// this direction. The body at these placements touches the surface of the sweep, or comes close
  /// to it.
  void addExtreme(std::vector<std::size_t>& chosen) const {
    constexpr int kFine = 2;
    for (int x = -kFine; x <= kFine; ++x) {
      for (int y = -kFine; y <= kFine; ++y) {
        for (int z = -kFine; z <= kFine; ++z) {
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) != kFine) continue;
          const Eigen::Vector3f direction = Eigen::Vector3d(x, y, z).normalized().cast<float>();
          const bool coarse = (x | y | z) % kFine == 0;
          for (int point = 0; point < (coarse ? 4 : 1); ++point) {
            chosen.push_back(farthestAlong(direction, point));
          }
        }
      }
    }
    sortUnique(chosen);
  }

  /// Adds placements until there are `count`. Each time, adds the placement that is farthest from
  /// those chosen so far.
  void addSpread(std::vector<std::size_t>& chosen, std::size_t count) const {
    std::vector<float> distance(at_.size(), std::numeric_limits<float>::max());
    const auto updateDistances = [&](std::size_t from) {
      for (std::size_t k = 0; k < at_.size(); ++k) {
        float square = 0;
        for (int point = 0; point < 4; ++point) {
          square = std::max(square, (at_[k][point] - at_[from][point]).squaredNorm());
        }
        distance[k] = std::min(distance[k], square);
      }
    };
    for (const std::size_t k : chosen) updateDistances(k);
    while (chosen.size() < count) {
      const auto next = static_cast<std::size_t>(
          std::max_element(distance.begin(), distance.end()) - distance.begin());
      if (!(distance[next] > 0)) return;
      chosen.push_back(next);
      updateDistances(next);
    }
  }

 private:
  std::size_t farthestAlong(const Eigen::Vector3f& direction, int point) const {
    std::size_t best = 0;
    float most = -std::numeric_limits<float>::max();
    for (std::size_t k = 0; k < at_.size(); ++k) {
      const float along = direction.dot(at_[k][point]);
      if (along > most) {
        most = along;
        best = k;
      }
    }
    return best;
  }

  std::vector<std::array<Eigen::Vector3f, 4>> at_;
};

}  // namespace

std::optional<InsideMap> findDeepInside(const SamplerInput& input, RunContext& run) {
  const std::size_t placements = input.motion.placements.size();
  const std::size_t perCopy = input.motion.mergeError > 0 ? kMergedPerCopy : kPlacementsPerCopy;
  const std::size_t count = std::min(kMaxWholeCopies, placements / perCopy);
  // With a cache, nothing may be hidden: the next run may reuse the crossings of one part of the
  // motion, although other parts, which would have hidden some crossings, have changed.
  const bool mayHide = input.cull && input.orientable && input.fillsHollows && !input.cache;
  if (count < kMinCopies || !mayHide) {
    return std::nullopt;
  }
  const PointPositions positions(input);
  std::vector<std::size_t> chosen;
  if (count >= kWithExtreme) positions.addExtreme(chosen);
  positions.addSpread(chosen, count);
  Motion copies;
  for (const std::size_t k : chosen) copies.placements.push_back(input.motion.placements[k]);
  SamplerInput some{input.body, input.topology, copies, input.grid, false, input.orientable};
  some.crossings = input.crossings;
  const MarkedEdges marked = sampleCpu(some, run);
  InsideMap inside(marked, findOutside(marked, input.grid, run), input.grid);
  if (!inside.hasFronts() || hidesEnough(input, inside)) return inside;
  return std::nullopt;
}

}  // namespace swept
