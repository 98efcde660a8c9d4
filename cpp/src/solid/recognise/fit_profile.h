// Fits a smooth curve to unordered points of a plane, and finds the direction or axis that maps
// points in space to such a curve.
// In: points (mm), outward unit normals. Out: surface of kind Extrusion or Revolution with its
// profile and `reversed`; nothing if no smooth curve fits the points. Units: mm. Cost: O(points x
// nodes of the profile).
// Source: axes as in fit.h (Pottmann and Randrup 1998); cubic splines by least squares.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/recognise/fit.h"

namespace swept::step {

/// What a profile is fitted to.
struct Cloud {
  std::vector<Eigen::Vector2d> points, normals;
};

/// exact: mm; spans are halved until their points are this near, or until halving does not help.
std::optional<Profile> fitProfile(const Cloud& cloud, double exact);

/// Direction or axis alone, from the normals: perpendicular to all of them, or meeting all their
/// lines. `spread` receives how far the normals are from that (sine, root mean square).
std::optional<Carrier> guessAxis(CarrierKind kind, const Samples& samples, double& spread);

/// Fits the profile and improves the axis in turns.
bool fitAlong(const Samples& samples, double exact, Carrier& surface);

}  // namespace swept::step
