// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/culling/inside_map.h"

#include <algorithm>

#include "base/parallel.h"
#include "signs/contributing_edges.h"

namespace swept {
namespace {

constexpr std::uint8_t kDeepest = 255;

/// Distances of blocks from those that hold 0, where a step to any of the 26 neighbours counts as
/// one: one pass forwards over half of the neighbours and one back over the others. The rim of the
/// lattice holds 0.
class Distances {
 public:
  Distances(std::vector<std::uint8_t>& depth, const std::array<std::size_t, 3>& blocks)
      : depth_(depth), blocks_(blocks), near_(blocks[2]) {}

  void find() {
    const std::size_t rows = blocks_[0] * blocks_[1];
    for (std::size_t row = 0; row < rows; ++row) pass(row, -1);
    for (std::size_t row = rows; row-- > 0;) pass(row, 1);
  }

 private:
  /// way: -1 looks at the rows and the block before, 1 at those behind.
  void pass(std::size_t row, int way) {
    const auto i = static_cast<std::ptrdiff_t>(row / blocks_[1]);
    const auto j = static_cast<std::ptrdiff_t>(row % blocks_[1]);
    std::fill(near_.begin(), near_.end(), kDeepest);
    for (int dj = -1; dj <= 1; ++dj) take(i + way, j + dj);
    take(i, j + way);
    std::uint8_t* values = depth_.data() + row * blocks_[2];
    const std::size_t n = blocks_[2];
    const auto limit = [&](std::size_t k, std::uint8_t beside) {
      if (beside < kDeepest) {
        values[k] = std::min(values[k], static_cast<std::uint8_t>(beside + 1));
      }
    };
    for (std::size_t k = 0; k < n; ++k) {
      limit(k, near_[k]);
      if (k > 0) limit(k, near_[k - 1]);
      if (k + 1 < n) limit(k, near_[k + 1]);
    }
    for (std::size_t k = 1; k < n; ++k) {
      if (way < 0) limit(k, values[k - 1]);
      if (way > 0) limit(n - 1 - k, values[n - k]);
    }
  }
  /// Keeps the smallest of what the rows hold.
  void take(std::ptrdiff_t i, std::ptrdiff_t j) {
    if (i < 0 || j < 0 || i >= static_cast<std::ptrdiff_t>(blocks_[0]) ||
        j >= static_cast<std::ptrdiff_t>(blocks_[1])) {
      return;
    }
    const std::uint8_t* row =
        depth_.data() +
        (static_cast<std::size_t>(i) * blocks_[1] + static_cast<std::size_t>(j)) * blocks_[2];
    for (std::size_t k = 0; k < near_.size(); ++k) near_[k] = std::min(near_[k], row[k]);
  }

  std::vector<std::uint8_t>& depth_;
  const std::array<std::size_t, 3>& blocks_;
  std::vector<std::uint8_t> near_;
};

}  // namespace

InsideMap::InsideMap(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid) {
  const auto count = [&] {
    std::size_t all = 1;
    for (int axis = 0; axis < 3; ++axis) {
      blocks_[axis] = (static_cast<std::size_t>(grid.points[axis]) >> shift_) + 1;
      all *= blocks_[axis];
    }
    return all;
  };
  while (count() > kMaxBlocks) ++shift_;
  for (int axis = 0; axis < 3; ++axis) limit_[axis] = grid.points[axis] - 1;
  depth_.assign(count(), kDeepest);
  const auto clear = [&](std::int32_t i, std::int32_t j, std::int32_t k) {
    depth_[(static_cast<std::size_t>(i >> shift_) * blocks_[1] +
            static_cast<std::size_t>(j >> shift_)) *
               blocks_[2] +
           static_cast<std::size_t>(k >> shift_)] = 0;
  };
  for (std::int32_t i = 0; i < grid.points[0]; ++i) {
    for (std::int32_t j = 0; j < grid.points[1]; ++j) {
      LineReader line(marked, signs, i, j);
      for (std::int32_t k = 0; k < grid.points[2]; ++k) {
        if (!line.outside(k)) continue;
        // The eight cells at this point.
        for (std::int32_t i0 = std::max(i - 1, 0); i0 <= i; ++i0) {
          for (std::int32_t j0 = std::max(j - 1, 0); j0 <= j; ++j0) {
            clear(i0, j0, std::max(k - 1, 0));
            clear(i0, j0, k);
          }
        }
      }
    }
  }
  Distances(depth_, blocks_).find();
  if (shift_ == 0) findFronts(marked, signs, grid);
}

void InsideMap::findFronts(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid) {
  /// Part of an edge: well above the precision of crossings, so that none counts as equal.
  constexpr float kApart = 0.01f;
  for (auto& fronts : fronts_) fronts.resize(depth_.size());
  parallelFor(static_cast<std::size_t>(grid.points[0]), [&](std::size_t layer) {
    const auto i = static_cast<std::int32_t>(layer);
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t di = axis == 0 ? 1 : 0, dj = axis == 1 ? 1 : 0, dk = axis == 2 ? 1 : 0;
      if (i + di == grid.points[0]) continue;
      for (std::int32_t j = 0; j + dj < grid.points[1]; ++j) {
        Front* row =
            fronts_[axis].data() + (layer * blocks_[1] + static_cast<std::size_t>(j)) * blocks_[2];
        LineReader low(marked, signs, i, j), high(marked, signs, i + di, j + dj);
        for (std::int32_t k = 0; k + dk < grid.points[2]; ++k) {
          const bool lowOut = low.outside(k), highOut = high.outside(k + dk);
          if (!lowOut && !highOut) row[k] = {0, kParts};
        }
      }
      forContributing(
          marked, signs, grid, i, axis,
          [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t sides) {
            Front front{0, kParts};
            if (sides & HermiteEdge::kLow) {
              const float behind = edge.lowFraction * kParts + kApart;
              front.from = static_cast<std::uint8_t>(std::min(behind + 1, 255.0f));
            }
            if (sides & HermiteEdge::kHigh) {
              const float before = edge.highFraction * kParts - kApart;
              front.to = static_cast<std::uint8_t>(std::max(before, 0.0f));
            }
            fronts_[axis][(layer * blocks_[1] + static_cast<std::size_t>(j)) * blocks_[2] +
                          edge.k] = front;
          });
    }
  });
}

bool InsideMap::behindFronts(const Eigen::Array3d& low, const Eigen::Array3d& high,
                             const std::array<std::int32_t, 3>& first,
                             const std::array<std::int32_t, 3>& last) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<std::int32_t, 3> p;
    // Lattice lines in the box: those at whole numbers. A corner never lies on one.
    for (p[u] = first[u] + 1; p[u] <= last[u]; ++p[u]) {
      for (p[v] = first[v] + 1; p[v] <= last[v]; ++p[v]) {
        for (p[axis] = first[axis]; p[axis] <= last[axis]; ++p[axis]) {
          const Front front = fronts_[axis][(static_cast<std::size_t>(p[0]) * blocks_[1] +
                                             static_cast<std::size_t>(p[1])) *
                                                blocks_[2] +
                                            static_cast<std::size_t>(p[2])];
          const double from = std::max(low[axis] - p[axis], 0.0) * kParts,
                       to = std::min(high[axis] - p[axis], 1.0) * kParts;
          if (from < front.from || to > front.to) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace swept
