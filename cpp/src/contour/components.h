// Surface components of a leaf cell: which of its crossings belong to one piece of surface.
//
// Consistent (default): on each face the crossings met going round alternate between entering and
// leaving the inside. They are joined in pairs, without crossing each other, by a rule that looks
// at the face alone (its crossings and normals), so that the two cells of a face agree. Every
// crossing lies on two faces of the cell; the pairs close to loops, each loop is a component.
//   Of several pairings the one with the least sum of disagreements is taken,
//   cost(p, q) = 1 - n_p . n_q + |n_p . d| + |n_q . d|, d the unit vector from p to q;
//   of equal ones the one that cuts off the inside corners.
// Invariant: the dual surface is closed, and every component is one closed ring of polygons.
// Proof over all configurations: tests/unit/contour.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "contour/cell.h"
#include "swept/types.h"

namespace swept {

struct Components {
  int count = 0;
  std::array<std::int8_t, kSlots> of;  ///< per slot; -1: no crossing or not used
};

/// Pairs of slots on one face; n / 2 pairs for n crossings.
struct FacePairs {
  int count = 0;
  std::array<std::array<std::int8_t, 2>, 4> slots;
};

/// The consistent rule on one face. `crossings` is the whole array that the cell's indices point
/// to.
FacePairs pairFace(const Cell& cell, int face, const Crossing* crossings);

/// Crossings on a face that the cell's mask shows.
int faceCrossings(std::uint32_t mask, int face);
/// Whether they are more than two, so that they can be paired in several ways.
bool hasChoice(std::uint32_t mask, int face);

class ComponentFinder {
 public:
  explicit ComponentFinder(ComponentMethod method) : method_(method) {}
  void find(const Cell& cell, const Crossing* crossings, Components& out);

 private:
  void consistent(const Cell& cell, const Crossing* crossings, Components& out);

  ComponentMethod method_;
  // Cells without an ambiguous face are decided by their mask alone: remember the last ones.
  struct Known {
    std::uint32_t mask = 0;
    Components components;
  };
  std::array<Known, 1024> known_{};
};

}  // namespace swept
