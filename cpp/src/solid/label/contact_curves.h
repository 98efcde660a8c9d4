// Finds where a face touches the envelope while the body moves in a straight line: the points at
// which its normal is perpendicular to the motion.
// In:      a carrier or a face of a BodyShape; the direction of the motion in the body's frame.
// Out:     curves and points in the body's frame.
// Units:   mm.
// Cost:    O(1) for each curve.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "solid/carrier/traces.h"
#include "solid/label/body_shape.h"

namespace swept::step {

/// Returns whether the surface slides along itself when it moves in this direction.
bool slidesAlong(const Carrier& surface, const Eigen::Vector3d& direction);

/// Returns the contact curves of the face. Straight contact curves extend beyond the face. Empty if
/// the surface slides along itself, or if there is no formula for its kind.
std::vector<Curve> contactCurves(const BodyShape& body, std::int32_t face,
                                 const Eigen::Vector3d& direction);

/// Returns the contact points of the surface that lie on this curve. The curve lies on the surface.
std::vector<Eigen::Vector3d> contactPoints(const Curve& curve, const Carrier& surface,
                                           const Eigen::Vector3d& direction);

}  // namespace swept::step
