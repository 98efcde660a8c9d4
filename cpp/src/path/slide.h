// Moves along what is in the way: of a wanted move as much as the contacts met so far allow.
// In:    a scene, distances to keep, a state, the wanted move. Out: the allowed move nearest to it.
// Units: mm, rad; the metric is that of moves (scene.h).
// Cost:  a microsecond or two for ten contacts; they are found by moves that were blocked, and
//        kept as pairs of triangles, so that nothing has to be searched for.
// Promise: none: the move is right to first order; Scene::follow() says how far it is free.
// Sources: contacts as inequalities of twists, M. S. Ohwovoriole, B. Roth, An extension of screw
//        theory (1981); the nearest twist by dual coordinate ascent, C. Hildreth, A quadratic
//        programming procedure (1957).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "path/scene.h"

namespace swept::path {

/// A pair of triangles that was in the way.
struct Touch {
  int neighbour = -1;
  clearance::LeafPair pair;
  bool operator==(const Touch& other) const {
    return neighbour == other.neighbour && pair.body == other.pair.body &&
           pair.neighbour == other.pair.neighbour;
  }
};

/// The pairs that limit moves near one state; the newest ones are kept.
using Touches = std::vector<Touch>;

/// Adds what stopped a move: the pair in the memory. False if it is known already.
bool addTouch(const Memory& memory, int neighbour, Touches& touches);

/// Drops what is farther away than `reach` at the state.
void dropFar(const Scene& scene, const State& state, const Rule& rule, double reach,
             Touches& touches);

/// The move nearest to `wanted` after which no pair of the list is nearer than its rule asks for,
/// to first order; pairs that are nearer than a small margin are moved away from where there is
/// room.
Twist allowedMove(const Scene& scene, const State& state, const Rule& rule, const Touches& touches,
                  const Twist& wanted);

}  // namespace swept::path
