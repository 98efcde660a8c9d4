// Finds exact positions of vertices and edges of a solid from traces: curves and points that are
// known to lie on the carriers (carrier/traces.h).
// In:      the carriers that meet; points of the mesh near the wanted position.
// Out:     the position, within kOnCarrier of all carriers. Nothing if no trace fits.
// Units:   mm.
// Cost:    O(traces).
// Note:    Newton's method fails where carriers touch, for example where a cylinder touches the
// plane that it sweeps. Traces are exact there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/carrier/traces.h"

namespace swept::step {

/// Returns a point of a trace that lies on all surfaces, at most `reach` (mm) from `from`.
std::optional<Eigen::Vector3d> knownPoint(const Eigen::Vector3d& from,
                                          const std::vector<const Carrier*>& surfaces,
                                          double reach);

/// Returns a piece of a trace between the first and the last of these points. It lies within `gap`
/// (mm) of both surfaces and within `maxDeviation` (mm) of the points.
std::optional<Curve> knownCurve(const std::vector<Eigen::Vector3d>& along, const Carrier& a,
                                const Carrier& b, double gap, double maxDeviation);

}  // namespace swept::step
