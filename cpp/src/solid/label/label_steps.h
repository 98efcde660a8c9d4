// Steps that clean the labels of triangles, called by labelFaces() in this order.
// Units:   mm.
// Cost:    O(triangles) each.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/label/label_tools.h"

namespace swept::step {

/// Gives small regions to neighbours whose carriers are near, connects narrow strips, and changes
/// labels at vertices where a region touches itself. Returns false if nothing changed.
bool tidyRegions(Labels& labels);

/// Mends vertices where three or four regions meet whose carriers have no common point. Returns
/// false if nothing changed.
bool mendCorners(Labels& labels);

/// Removes the labels around vertices that could not be mended, and around the given points. These
/// triangles become facets.
void makeFacets(const std::vector<Eigen::Vector3d>& around, Labels& labels);

}  // namespace swept::step
