// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/vertex_split.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace swept {

void VertexSplit::findFolds(const Cell& cell, const Components& components, int component,
                            const Crossing* crossings) {
  folds.clear();
  foldFaces.clear();
  for (int slot = 0; slot < kSlots; ++slot) {
    if (components.of[slot] == component && part[slot] < 0) return;
  }
  bool ambiguous = false;
  for (int face = 0; face < kFaces; ++face) {
    const FacePairs pairs = pairFace(cell, face, crossings);
    for (int p = 0; p < pairs.count; ++p) {
      const auto [x, y] = pairs.slots[p];
      if (components.of[x] != component || part[x] == part[y]) continue;
      folds.push_back(pairs.slots[p]);
      foldFaces.push_back(static_cast<std::int8_t>(face));
      ambiguous |= pairs.count > 1;  // joined otherwise, see surface.h
    }
  }
  if (folds.size() == 2 && !ambiguous) return;
  folds.clear();
  foldFaces.clear();
}

Eigen::Vector3d VertexSplit::alongCrease(const Qef& planes, const Eigen::Vector3d& best) const {
  constexpr double kNone = 0.01, kSome = 0.03;  // of the planes' normals along and across a crease
  constexpr double kStraight = 0.02;            // cells: the planes may miss it by so much more
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(planes.matrix() / planes.count());
  if (eigen.eigenvalues()[0] > kNone || eigen.eigenvalues()[1] < kSome) return best;
  const Eigen::Vector3d way = eigen.eigenvectors().col(0);
  double from = -std::numeric_limits<double>::max(), to = -from;  // between the cell's walls
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(way[axis]) < kCellMargin) continue;
    const double low = (kCellMargin - best[axis]) / way[axis];
    const double high = (1 - kCellMargin - best[axis]) / way[axis];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  const Eigen::Vector3d start = best + from * way, end = best + to * way;
  double share = 0.5;
  if (seen) share = (start - *seen).norm() < (end - *seen).norm() ? 0.75 : 0.25;
  const Eigen::Vector3d place = (1 - share) * start + share * end;
  const double missed = planes.error(place) - planes.error(best);
  return missed > kStraight * kStraight * planes.count() ? best : place;
}

}  // namespace swept
