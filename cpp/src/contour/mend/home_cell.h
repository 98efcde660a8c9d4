// The cell that a component's vertex belongs to, once it may have left it.
// Units: grid coordinates.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include "contour/cell.h"

namespace swept {

/// Low corner of the cell of a vertex that stands at `now`: a vertex may have escaped from its
/// cell, the mass point of its crossings never does.
inline Eigen::Vector3d homeCell(const Eigen::Vector3d& now, const Eigen::Vector3d& mass) {
  const Eigen::Vector3d cell = now.array().floor();
  const bool escaped =
      (mass.array() < cell.array()).any() || (mass.array() > cell.array() + 1).any();
  return escaped ? Eigen::Vector3d(mass.array().floor()) : cell;
}

/// The nearest place in the cell that keeps the margin.
inline Eigen::Vector3d intoCell(const Eigen::Vector3d& x, const Eigen::Vector3d& cell) {
  return x.cwiseMax((cell.array() + kCellMargin).matrix())
      .cwiseMin((cell.array() + 1 - kCellMargin).matrix());
}

}  // namespace swept
