// Sweeps whose envelope is known in closed form.
// A Truth consists of the moving body, its motion, the distance of any point to the true envelope,
// points on it and on its creases, its volume and its area. Units mm.
//
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "swept/types.h"

namespace swept::test {

struct Truth {
  std::string name;
  TriMesh body;
  Trajectory motion;
  std::function<double(const Eigen::Vector3d&)> distance;  ///< unsigned, to the envelope
  std::vector<Eigen::Vector3d> surface;                    ///< points on the envelope
  std::vector<Eigen::Vector3d> creases;                    ///< points on its sharp edges
  double volume = 0;
  double area = 0;
  double thickness = 0;  ///< thinnest wall of the envelope, where that is what the case is about
};

/// Returns all cases: ball along a line, box along a line in general direction, box turning about
/// an edge, cylinder along its axis, ball on a circle for more than a turn, square ring along its
/// axis and across it (two cases), ball on a helix, motion with two equal keys, body with a sealed
/// cavity.
std::vector<Truth> allTruths();
/// Plates of the given thickness: moved in their plane, across it, and turned in their plane.
std::vector<Truth> thinPlates(double thickness);

/// Returns the same sweep in another coordinate system.
Truth placed(Truth truth, const Eigen::Isometry3d& frame);

}  // namespace swept::test
