// Finds the surface components of a cell: groups of crossings that belong to one piece of surface.
//
// In: one cell and the crossings of the grid. Out: a component number per slot. Units: cells. Cost:
// O(crossings of the cell).
// Promise (consistent method only): the dual surface is closed, and the polygons round every
// component form one closed ring. tests/unit/contour enumerates all configurations;
// docs/contouring.md lists the faults of the other methods.
// Source: own method; docs/contouring.md, "Why `consistent` gives closed, manifold meshes". The
// other methods are in methods/methods.h with their papers.
//
// The consistent method (the default) pairs the crossings of each face. On a walk round a face,
// crossings that enter the inside alternate with crossings that leave it. The method joins entering
// and leaving crossings in pairs whose connecting lines do not cross. Its rule uses only the
// crossings of this face and their normals, so that the two cells that share the face pair them
// alike. Every crossing lies on two faces of its cell, so the pairs form closed loops; each loop is
// a component. Of all pairings, the method takes the one with the smallest sum of costs:
//   cost(p, q) = 1 - n_p . n_q + |n_p . d| + |n_q . d|, with d the unit vector from p to q.
// Sums that differ by less than 1e-5 count as equal. Among pairings with equal sums, the one that
// separates the inside corners is preferred.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "contour/cell.h"
#include "swept/types.h"

namespace swept {

struct Components {
  int count = 0;
  /// Component of each slot. -1: the slot has no crossing, or the method drops the crossing.
  std::array<std::int8_t, kSlots> of;
};

/// The pairs of slots on one face: n / 2 pairs for n crossings.
struct FacePairs {
  int count = 0;
  std::array<std::array<std::int8_t, 2>, 4> slots;
};

/// Pairs the crossings of one face by the consistent rule. `crossings`: all crossings of the grid;
/// the cell holds indices into this array.
FacePairs pairFace(const Cell& cell, int face, const Crossing* crossings);

/// Links every slot to its partners on the two faces that contain its crossing. The links form
/// closed rings.
class SlotLinks {
 public:
  void join(int p, int q) {
    link_[p][count_[p]++] = static_cast<std::int8_t>(q);
    link_[q][count_[q]++] = static_cast<std::int8_t>(p);
  }
  bool has(int slot) const { return count_[slot] != 0; }
  /// Returns the slot that follows `slot` in its ring; `from` is the slot before it (-1 at the
  /// start).
  int after(int slot, int from) const {
    return link_[slot][0] != from ? link_[slot][0] : link_[slot][1];
  }
  /// Makes a component of every ring.
  void setComponents(Components& out) const;

 private:
  std::array<std::array<std::int8_t, 2>, kSlots> link_;
  std::array<std::int8_t, kSlots> count_{};
};

/// Links the pairs of all faces of a cell by the consistent rule.
SlotLinks linkSlots(const Cell& cell, const Crossing* crossings);

/// Returns the number of crossings on a face of a cell with this mask.
int faceCrossings(std::uint32_t mask, int face);
/// Returns whether the face has more than two crossings, so that they can be paired in several
/// ways.
bool hasChoice(std::uint32_t mask, int face);

class ComponentFinder {
 public:
  explicit ComponentFinder(ComponentMethod method) : method_(method) {}
  void find(const Cell& cell, const Crossing* crossings, Components& out);

 private:
  ComponentMethod method_;
  // If no face has a choice of pairs, the mask alone decides the components. The latest results are
  // cached by mask.
  struct Known {
    std::uint32_t mask = 0;
    Components components;
  };
  std::array<Known, 1024> known_{};
};

}  // namespace swept
