// Fits a smooth curve to unordered points of a plane. Also finds the direction or axis that maps
// points in space to such a curve.
// In:      points, outward unit normals.
// Out:     a surface of kind Extrusion or Revolution with its profile and `reversed`; nothing if no
//          smooth curve fits the points.
// Units:   mm.
// Cost:    O(points x nodes of the profile).
// Source:  axes as in fit.h (Pottmann and Randrup 1998); cubic splines by least squares.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/recognise/fit.h"

namespace swept::step {

/// Points and normals to which a profile is fitted.
struct Cloud {
  std::vector<Eigen::Vector2d> points, normals;
};

/// Fits a profile. `exact`: mm; spans are halved until their points are this near, or halving does
/// not help.
std::optional<Profile> fitProfile(const Cloud& cloud, double exact);

/// Finds only the direction of an extrusion, which is perpendicular to all normals, or the axis of
/// a revolution, which meets the lines of all normals. `spread` receives the root mean square of
/// the sines of their deviation.
std::optional<Carrier> guessAxis(CarrierKind kind, const Samples& samples, double& spread);

/// Fits the profile and improves the axis in turn. Returns false if no profile fits.
bool fitAlong(const Samples& samples, double exact, Carrier& surface);

}  // namespace swept::step
