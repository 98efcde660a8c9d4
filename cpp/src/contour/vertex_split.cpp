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
      ambiguous |= pairs.count > 1;  // such faces get an extra vertex, see surface.h
    }
  }
  if (folds.size() == 2 && !ambiguous) return;
  folds.clear();
  foldFaces.clear();
}

Eigen::Vector3d VertexSplit::alongCrease(const Qef& planes, const Eigen::Vector3d& best) const {
  /// Limits of the eigenvalues of the mean normal tensor on a crease. The smallest one (along the
  /// crease) is at most kMaxAlong, the other two are at least kMinAcross.
  constexpr double kMaxAlong = 0.01, kMinAcross = 0.03;
  // Limit (cells) of the additional root mean square distance of the planes from the new point.
  constexpr double kMaxExtraMiss = 0.02;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(planes.matrix() / planes.count());
  if (eigen.eigenvalues()[0] > kMaxAlong || eigen.eigenvalues()[1] < kMinAcross) return best;
  const Eigen::Vector3d direction = eigen.eigenvectors().col(0);
  // Finds the range of the crease between the walls of the cell.
  double from = -std::numeric_limits<double>::max(), to = -from;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < kCellMargin) continue;
    const double low = (kCellMargin - best[axis]) / direction[axis];
    const double high = (1 - kCellMargin - best[axis]) / direction[axis];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  const Eigen::Vector3d start = best + from * direction, end = best + to * direction;
  double fraction = 0.5;
  if (seen) fraction = (start - *seen).norm() < (end - *seen).norm() ? 0.75 : 0.25;
  const Eigen::Vector3d point = (1 - fraction) * start + fraction * end;
  const double missed = planes.error(point) - planes.error(best);
  return missed > kMaxExtraMiss * kMaxExtraMiss * planes.count() ? best : point;
}

}  // namespace swept
