// Finds the directions in which the part can move from a placement without being blocked by a
// contact.
// In:      a placement and the neighbours near it.
// Out:     moves of unit length, the most promising first.
// Units:   mm, rad. A twist has length 1 if no point of the part travels more than 1 mm.
// Source:  instantaneous motions under contacts: M. Mason, Mechanics of Robotic Manipulation
// (2001), chapter 4. For a blocked part, the eigenvectors of its contact matrix with the smallest
// eigenvalues are the remaining directions.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "path/scene.h"

namespace swept::path {

/// Returns the contacts whose distance is at most the entry of their neighbour in `within`. A
/// negative entry excludes the neighbour. Per neighbour there are at most 200 contacts, spread over
/// the surface.
std::vector<Contact> contactsOf(const Scene& scene, const State& state, const Rule& within);

/// Returns shifts. With `turns` and at least one contact, also returns rotations and screws. Always
/// includes both directions of the axes of the world and of the part.
std::vector<Twist> freeMoves(const Scene& scene, const State& state,
                             const std::vector<Contact>& contacts, bool turns);

}  // namespace swept::path
