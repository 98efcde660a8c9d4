// Finds the cell to which a component's vertex belongs, even if the vertex has left it.
// Units: grid coordinates.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include "contour/cell.h"

namespace swept {

/// Returns the low corner of the cell to which the vertex at `now` belongs. The vertex may have
/// left the cell, but the mass point `mass` of its crossings always lies in the cell.
inline Eigen::Vector3d homeCell(const Eigen::Vector3d& now, const Eigen::Vector3d& mass) {
  const Eigen::Vector3d cell = now.array().floor();
  const bool escaped =
      (mass.array() < cell.array()).any() || (mass.array() > cell.array() + 1).any();
  return escaped ? Eigen::Vector3d(mass.array().floor()) : cell;
}

/// Returns the point of the cell nearest to x that keeps kCellMargin from the walls.
inline Eigen::Vector3d intoCell(const Eigen::Vector3d& x, const Eigen::Vector3d& cell) {
  return x.cwiseMax((cell.array() + kCellMargin).matrix())
      .cwiseMin((cell.array() + 1 - kCellMargin).matrix());
}

}  // namespace swept
