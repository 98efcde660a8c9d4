// Computes the curve in which two carriers intersect, so exactly that a CAD kernel sees no gap.
// In:      points along the curve in order. The first and the last one lie on both carriers.
// Out:     a line, circle or spline with all points within kOnCarrier of both carriers. Nothing if
//          the carriers are nearly parallel (less than 0.17 degrees) between the ends of the curve,
//          or if the curve deviates from the points by more than `maxDeviation`.
// Units:   mm.
// Method:  Newton's method on both distances at evenly spaced points, joined by cubics whose
//          tangents follow from the normals. The number of points doubles until each span is
//          accurate.
// Cost:    O(points).
// Source:  following the intersection with exact tangents (Patrikalakis and Maekawa 2002, ch. 5).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/carrier/curve.h"

namespace swept::step {

/// mm. A kernel merges two points closer than 1e-7; a file rounds to 1e-9.
constexpr double kOnCarrier = 5e-8;

/// Returns the largest distance of sampled points of the curve from the carrier.
double largestGap(const Curve& curve, const Carrier& carrier);

/// Returns the curve of intersection along the polyline `along`. `maxDeviation`: mm, how far the
/// curve may deviate from it.
std::optional<Curve> sectionCurve(std::vector<Eigen::Vector3d> along, bool closed, const Carrier& a,
                                  const Carrier& b, double maxDeviation);

}  // namespace swept::step
