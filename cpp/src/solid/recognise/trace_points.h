// Traces a path along unordered points of a plane that lie near a smooth curve.
// In:      points with unit normals to one side.
// Out:     a polyline in small steps, closed if it comes back to its start; nothing if the points
//          do not lie near a curve.
// Units:   mm, rad.
// Cost:    O(points x points within a step).
// Source:  moving least squares (Levin 1998), curve reconstruction as in Lee 2000.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace swept::step {

struct Trace {
  std::vector<Eigen::Vector2d> points, normals;
  std::vector<double> along;  ///< mm, path length from the first point
  double turn = 0;            ///< rad, sum of the absolute turning angles
  double reach = 0;           ///< mm, how far a point may lie from the path
  bool closed = false;        ///< the first point is repeated at the end

  /// Returns the path length from the first point to a point with this normal; -1 if the point does
  /// not lie on the path.
  double parameterOf(const Eigen::Vector2d& p, const Eigen::Vector2d& normal) const;
};

std::optional<Trace> tracePoints(const std::vector<Eigen::Vector2d>& points,
                                 const std::vector<Eigen::Vector2d>& normals);

}  // namespace swept::step
