// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/culling/inside_map.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/parallel.h"
#include "signs/contributing_edges.h"

namespace swept {
namespace {

constexpr std::uint8_t kDeepest = 255;

/// Computes for each block the distance to the nearest block that holds 0. A step to any of the 26
/// neighbours counts as one. A forward pass considers half of the neighbours, a backward pass the
/// others. Blocks at the border of the lattice hold 0, because the border lies outside.
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
  /// Processes one row of blocks. `direction` -1: uses the values of the preceding rows and, within
  /// the row, of the preceding block. 1: uses those of the following ones.
  void pass(std::size_t row, int direction) {
    const auto i = static_cast<std::ptrdiff_t>(row / blocks_[1]);
    const auto j = static_cast<std::ptrdiff_t>(row % blocks_[1]);
    std::fill(near_.begin(), near_.end(), kDeepest);
    for (int dj = -1; dj <= 1; ++dj) takeMinimum(i + direction, j + dj);
    takeMinimum(i, j + direction);
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
      if (direction < 0) limit(k, values[k - 1]);
      if (direction > 0) limit(n - 1 - k, values[n - k]);
    }
  }
  /// Replaces each value of near_ by the value of the row (i, j) if that is smaller.
  void takeMinimum(std::ptrdiff_t i, std::ptrdiff_t j) {
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
  // The eight cells around an outside point are not deep inside.
  const std::int32_t edge = std::int32_t{1} << shift_;
  parallelFor(blocks_[0], [&](std::size_t slab) {
    const std::int32_t begin = static_cast<std::int32_t>(slab) * edge;
    for (std::int32_t i = begin; i <= std::min(begin + edge, grid.points[0] - 1); ++i) {
      for (std::int32_t j = 0; j < grid.points[1]; ++j) {
        forOutsideRuns(
            marked, signs, grid.points[2], i, j, [&](std::int32_t first, std::int32_t last) {
              for (std::int32_t j0 = std::max(j - 1, 0); j0 <= j; ++j0) {
                std::uint8_t* row =
                    depth_.data() +
                    (slab * blocks_[1] + static_cast<std::size_t>(j0 >> shift_)) * blocks_[2];
                std::fill(row + (std::max(first - 1, 0) >> shift_), row + (last >> shift_) + 1,
                          std::uint8_t{0});
              }
            });
      }
    }
  });
  Distances(depth_, blocks_).find();
  if (shift_ == 0) findFronts(marked, signs, grid);
}

void InsideMap::findFronts(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid) {
  /// A crossing is hidden only if it lies at least this far (in units of 1 / kParts of an edge)
  /// behind a known one. This distance is well above the precision of crossings, so a crossing at
  /// the same position is never hidden.
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

/// The part of hides() for lines along the axis W. Returns true if all possible crossings of the
/// triangle with such lines are hidden.
template <int W>
bool InsideMap::hidesAlong(const std::array<Eigen::Vector3d, 3>& corner,
                           const Eigen::Vector3d& normal, const Eigen::Array3d& low,
                           const Eigen::Array3d& high, double reach) const {
  constexpr int U = W == 0 ? 1 : 0, V = W == 2 ? 1 : 2;
  /// If the sine of the angle between the plane of the triangle and the lines is below this, the
  /// plane does not narrow the range of possible crossings.
  constexpr double kMinSlope = 1e-3;
  constexpr double kMargin = 1e-9;  ///< cells; covers rounding
  const double across = std::abs(normal[W]);
  const bool steep = across < kMinSlope * normal.norm();
  const double slack =
      steep ? 0 : reach * (1 + (std::abs(normal[U]) + std::abs(normal[V])) / across) + kMargin;
  // Orientation of the triangle in the (U, V) plane: the sign of normal[W], reversed if U x V is
  // -W.
  const double turn = (normal[W] > 0) == (W != 1) ? 1 : -1;
  std::array<std::int32_t, 3> p;
  for (p[U] = static_cast<std::int32_t>(low[U]) + 1; p[U] <= high[U]; ++p[U]) {
    // The lines of this row that pass the triangle. Each side of the triangle limits them.
    double first = std::floor(low[V]) + 1, last = std::floor(high[V]);
    for (std::size_t n = 0; n < 3 && !steep; ++n) {
      const Eigen::Vector3d &a = corner[n], &b = corner[(n + 1) % 3];
      const double du = turn * (b[U] - a[U]), dv = turn * (b[V] - a[V]);
      // A line at v lies beside the triangle if du * v < limit.
      const double limit =
          du * a[V] + dv * (p[U] - a[U]) - (reach + kMargin) * (std::abs(du) + std::abs(dv));
      if (du > 0) {
        first = std::max(first, std::ceil(limit / du - kMargin));
      } else if (du < 0) {
        last = std::min(last, std::floor(limit / du + kMargin));
      } else if (limit > 0) {
        last = first - 1;
      }
    }
    if (first > last) continue;
    const auto end = static_cast<std::int32_t>(last);
    for (p[V] = static_cast<std::int32_t>(first); p[V] <= end; ++p[V]) {
      double from = low[W], to = high[W];
      if (!steep) {
        const Eigen::Vector3d& a = corner[0];
        const double plane =
            a[W] - (normal[U] * (p[U] - a[U]) + normal[V] * (p[V] - a[V])) / normal[W];
        from = std::max(from, plane - slack);
        to = std::min(to, plane + slack);
      }
      for (p[W] = static_cast<std::int32_t>(from); p[W] <= to; ++p[W]) {
        const Front front = fronts_[W][pointOf(p[0], p[1], p[2])];
        if (std::max(from - p[W], 0.0) * kParts < front.from ||
            std::min(to - p[W], 1.0) * kParts > front.to) {
          return false;
        }
      }
    }
  }
  return true;
}

bool InsideMap::hides(const std::array<Eigen::Vector3d, 3>& corner, double reach) const {
  const auto& [a, b, c] = corner;
  const Eigen::Array3d low = a.cwiseMin(b).cwiseMin(c).array() - reach,
                       high = a.cwiseMax(b).cwiseMax(c).array() + reach;
  if (hides(low, high)) return true;
  if (!hasFronts() || (low < 0).any() || (high >= limit_).any()) return false;
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  return hidesAlong<0>(corner, normal, low, high, reach) &&
         hidesAlong<1>(corner, normal, low, high, reach) &&
         hidesAlong<2>(corner, normal, low, high, reach);
}

}  // namespace swept
