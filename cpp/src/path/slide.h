// Lets moves slide along obstacles: changes a wanted move so that the known contacts allow it.
// In:      a scene, the distances to keep, a state, and the wanted move.
// Out:     the allowed move nearest to the wanted one.
// Units:   mm, rad; lengths of moves as in scene.h.
// Cost:    one or two microseconds for ten contacts. Blocked moves supply the contacts as pairs of
//        triangles, so no search is needed.
// Promise: The move is correct to first order only; Scene::follow() finds how far it is free.
// Source:  contacts as inequalities of twists: M. S. Ohwovoriole, B. Roth, An extension of screw
//          theory (1981). Nearest twist by dual coordinate ascent: C. Hildreth, A quadratic
//          programming procedure (1957).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "path/scene.h"

namespace swept::path {

/// A pair of triangles that blocked a move.
struct Touch {
  int neighbour = -1;
  clearance::LeafPair pair;
  bool operator==(const Touch& other) const {
    return neighbour == other.neighbour && pair.body == other.pair.body &&
           pair.neighbour == other.pair.neighbour;
  }
};

/// Pairs that limit moves near one state. The oldest is dropped when the list is full.
using Touches = std::vector<Touch>;

/// Adds the pair that stopped the last move (in `memory`). Returns false if it is already in the
/// list.
bool addTouch(const Memory& memory, int neighbour, Touches& touches);

/// Removes pairs that are farther apart at this state than the required distance plus `reach`.
void dropFar(const Scene& scene, const State& state, const Rule& rule, double reach,
             Touches& touches);

/// Returns the move nearest to `wanted` that keeps, to first order, the required distance of each
/// listed pair. If the contacts allow it, pairs also keep a small margin.
Twist allowedMove(const Scene& scene, const State& state, const Rule& rule, const Touches& touches,
                  const Twist& wanted);

}  // namespace swept::path
