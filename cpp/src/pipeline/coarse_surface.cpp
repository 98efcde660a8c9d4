// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/coarse_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace swept {
namespace {

/// Coarse cells along the longest side: 40^3 of them are flooded in less than a millisecond.
constexpr double kCoarseCells = 40;
constexpr std::size_t kMaxBalls = 1u << 19;

/// Boxes of cells, with a rim of empty cells around them.
class Occupied {
 public:
  explicit Occupied(const std::array<int, 3>& cells)
      : size_{cells[0] + 2, cells[1] + 2, cells[2] + 2},
        cell_(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], kEmpty) {}

  void add(const Eigen::Vector3d& centre, double radius) {
    std::array<int, 3> low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const auto inside = [&](double x) {
        return std::clamp(static_cast<int>(std::floor(x)) + 1, 1, size_[axis] - 2);
      };
      low[axis] = inside(centre[axis] - radius);
      high[axis] = inside(centre[axis] + radius);
    }
    for (int i = low[0]; i <= high[0]; ++i) {
      for (int j = low[1]; j <= high[1]; ++j) {
        const std::size_t row = at(i, j, 0);
        std::fill(cell_.begin() + static_cast<std::ptrdiff_t>(row) + low[2],
                  cell_.begin() + static_cast<std::ptrdiff_t>(row) + high[2] + 1, kFull);
      }
    }
  }

  /// Faces between full cells and those that are reached from the rim.
  std::size_t outerFaces() {
    std::size_t faces = 0;
    std::vector<std::size_t> waiting{0};
    cell_[0] = kReached;
    const std::array<std::size_t, 3> stride{at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)};
    while (!waiting.empty()) {
      const std::size_t here = waiting.back();
      waiting.pop_back();
      for (int axis = 0; axis < 3; ++axis) {
        const auto along = static_cast<int>(here / stride[axis]) % size_[axis];
        for (const int way : {-1, 1}) {
          if (along + way < 0 || along + way >= size_[axis]) continue;
          const std::size_t next = way < 0 ? here - stride[axis] : here + stride[axis];
          faces += cell_[next] == kFull;
          if (cell_[next] != kEmpty) continue;
          cell_[next] = kReached;
          waiting.push_back(next);
        }
      }
    }
    return faces;
  }

 private:
  enum State : std::uint8_t { kEmpty, kFull, kReached };
  std::size_t at(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * size_[1] + j) * size_[2] + k;
  }

  std::array<int, 3> size_;
  std::vector<State> cell_;
};

}  // namespace

// A surface crosses as many lattice edges as its projections along the three axes have cells, and
// the faces of the coarse cells are such projections.
double guessCrossings(const FaceClusters& clusters, const Motion& motion, const GridPlan& grid) {
  const auto cells = grid.cells();
  const double longest = static_cast<double>(*std::max_element(cells.begin(), cells.end()));
  const double ratio = std::max(1.0, longest / kCoarseCells);
  std::array<int, 3> coarse;
  for (int axis = 0; axis < 3; ++axis) {
    coarse[axis] = static_cast<int>(std::ceil(static_cast<double>(cells[axis]) / ratio));
  }
  Occupied occupied(coarse);
  const std::size_t count = motion.placements.size();
  const std::size_t used = std::clamp<std::size_t>(
      kMaxBalls / std::max<std::size_t>(1, clusters.clusters.size()), 1, count);
  for (std::size_t n = 0; n < used; ++n) {
    const Placement p =
        grid.toGrid(motion.placements[n * (count - 1) / std::max<std::size_t>(1, used - 1)]);
    for (const FaceCluster& cluster : clusters.clusters) {
      occupied.add(p.apply(cluster.centre) / ratio, cluster.radius / grid.cell / ratio);
    }
  }
  return static_cast<double>(occupied.outerFaces()) * ratio * ratio;
}

}  // namespace swept
