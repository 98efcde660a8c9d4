// Exact places of vertices and edges of a solid, from curves and points that are known to lie on
// the carriers (carrier/traces.h).
// In:      the carriers that meet; points of the mesh near the place.
// Out:     the place on all carriers, within kOnCarrier. Nothing if no trace fits.
// Units:   mm.
// Cost:    O(traces).
// Note:    Newton's method fails where carriers touch, as a cylinder touches the plane that it
//          sweeps. Traces are exact there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/carrier/traces.h"

namespace swept::step {

/// Returns the point on all surfaces that a trace gives, within `reach` of `from`.
std::optional<Eigen::Vector3d> knownPlace(const Eigen::Vector3d& from,
                                          const std::vector<const Carrier*>& surfaces,
                                          double reach);

/// Returns the trace that lies on both surfaces, between the first and the last of these points. It
/// lies within `gap` (mm) of both surfaces.
std::optional<Curve> knownCurve(const std::vector<Eigen::Vector3d>& along, const Carrier& a,
                                const Carrier& b, double gap, double strays);

}  // namespace swept::step
