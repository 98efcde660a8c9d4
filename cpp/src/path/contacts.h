// Which way the part can move where it stands: directions that no contact blocks.
// In:    a placement, the neighbours near it. Out: moves of unit length, the most promising first.
// Units: mm, rad; a twist has length 1 if no point of the part travels more than 1 mm by it.
// Source: instantaneous motions under contacts, M. Mason, Mechanics of Robotic Manipulation (2001),
// 4;
//         directions that a blocked part keeps are the weakest eigenvectors of its contacts'
//         matrix.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "path/scene.h"

namespace swept::path {

/// Contacts with all neighbours nearer than their entry of `within` (negative: left out), at most
/// some hundred a neighbour, spread over the surface.
std::vector<Contact> contactsOf(const Scene& scene, const State& state, const Rule& within);

/// Shifts, and with `turns` turns and screws. Includes +-x, +-y, +-z of the world and of the part.
std::vector<Twist> freeMoves(const Scene& scene, const State& state,
                             const std::vector<Contact>& contacts, bool turns);

}  // namespace swept::path
