// A way along points of a plane that lie about a smooth curve, in no order.
// In: points (mm) with unit normals to one side. Out: a polyline in small steps, closed where it
// comes back to its start; nothing where the points lie about no curve. Units: mm.
// Cost: O(points x points within a step).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace swept::step {

struct Trace {
  std::vector<Eigen::Vector2d> points, normals;
  std::vector<double> along;  ///< mm, from the first point
  double turn = 0;            ///< rad, without sign
  double reach = 0;           ///< mm: how far from it points may lie
  bool closed = false;        ///< the first point stands once more at the end

  /// Where a point with this normal lies along it; -1: it does not.
  double placeOf(const Eigen::Vector2d& p, const Eigen::Vector2d& normal) const;
};

std::optional<Trace> tracePoints(const std::vector<Eigen::Vector2d>& points,
                                 const std::vector<Eigen::Vector2d>& normals);

}  // namespace swept::step
