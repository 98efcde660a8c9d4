// A ridge that no grid edge beside it tells of: the planes of a component do not meet in its cell,
// because between them lies a ledge lower than a cell whose own side no grid edge meets. The
// surface is probed from the cell's outside corners; where it shows a side that the crossings do
// not know, the vertex goes to the ridge between that side and the plane above it.
//
// The valley at the ledge's foot stays cut: of two features in one cell the outer one is kept, so
// that no part of the swept volume is lost.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/components.h"
#include "contour/qef.h"
#include "data/surface_probe.h"

namespace swept {

/// For the only component of a cell. True: `ridge` holds the planes that meet in the vertex.
bool findMissedRidge(const Cell& cell, const Eigen::Vector3i& at, const Crossing* crossings,
                     const SurfaceProbe& probe, Qef& ridge);

}  // namespace swept
