// A curve through points of a plane in no order, and the direction or axis that makes points in
// space such a curve.
// In: points (mm), outward unit normals. Out: Surface of kind Extrusion or Revolution with its
// profile and `reversed`; nothing where no smooth curve carries the points. Cost: O(points x nodes
// of the profile).
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

/// exact: mm, spans are halved until their points lie so near, or no nearer by it.
std::optional<Profile> fitProfile(const Cloud& cloud, double exact);

/// Direction or axis alone, from the normals: across all of them, or meeting all their lines.
/// `spread` says how far the normals are from that (sine, root mean square).
std::optional<Surface> guessAxis(SurfaceKind kind, const Samples& samples, double& spread);

/// Profile, and axis made better with it in turns.
bool fitAlong(const Samples& samples, double exact, Surface& surface);

}  // namespace swept::step
