// Sweeps whose envelope is known in closed form.
// A Truth consists of the moving body, its motion, the distance of any point to the true envelope,
// points on the envelope and on its creases, and the volume and area of the envelope. Units mm.
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
  double thickness = 0;  ///< thinnest wall of the envelope, in cases of thin walls
};

/// Returns all cases: ball along a line, box along a line in general direction, box turning about
/// an edge, cylinder along its axis, ball on a circle for more than a turn, square ring along its
/// axis and across it (two cases), ball on a helix, motion with two equal keys, body with a sealed
/// cavity.
std::vector<Truth> allTruths();
/// Returns sweeps of plates of this thickness: moved in their plane, moved across it, and turned in
/// it.
std::vector<Truth> thinPlates(double thickness);

/// Returns the same sweep in another coordinate system.
Truth placed(Truth truth, const Eigen::Isometry3d& frame);

}  // namespace swept::test
