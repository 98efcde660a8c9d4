// The curve in which two carriers intersect, exact to what a kernel calls zero.
// In: points along the curve in order, the first and the last of which lie on both carriers. Out: a
// line, a circle or a spline no point of which is farther than kOnCarrier from either carrier, or
// nothing where the carriers are nearly parallel along it or the curve strays from the points.
// Units: mm. Method: Newton's method on both distances at points of equal spacing, cubics with the
// tangents that the normals give, twice as many points until every span holds. Cost: O(points).
// Source: marching over intersections with exact tangents (Patrikalakis and Maekawa 2002, ch. 5).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/carrier/curve.h"

namespace swept::step {

/// Mm: a kernel takes two points as one below 1e-7; a file rounds to 1e-9.
constexpr double kOnCarrier = 5e-8;

/// Largest distance of points of the curve from the carrier.
double largestGap(const Curve& curve, const Carrier& carrier);

/// strays: mm, how far the curve may lie from the polyline.
std::optional<Curve> sectionCurve(std::vector<Eigen::Vector3d> along, bool closed, const Carrier& a,
                                  const Carrier& b, double strays);

}  // namespace swept::step
