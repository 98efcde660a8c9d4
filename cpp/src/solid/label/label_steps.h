// Steps that clean the labels of triangles, called by FaceLabels in this order.
// Units:   mm.
// Cost:    O(triangles) each.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/label/label_faces.h"
#include "solid/label/label_tools.h"

namespace swept::step {

/// Gives small regions to neighbours that explain them, connects narrow strips, and parts regions
/// that touch themselves. Returns false if nothing changed.
bool tidyRegions(Labels& labels);

/// Mends vertices where three or four regions meet whose carriers have no common point. Returns
/// false if nothing changed.
bool mendCorners(Labels& labels);

/// Removes regions of very few triangles: they join a neighbour, or become open ground.
void removeSpecks(Labels& labels);

/// Opens the ground around these places, and specks of labelled ground that remain between them.
void openGround(const std::vector<OpenSpot>& spots, Labels& labels);

}  // namespace swept::step
