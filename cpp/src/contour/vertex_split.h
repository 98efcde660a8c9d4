// A component with two features in one cell gets two vertices, one for each part of its crossings.
//
// Each vertex is fitted to the planes of its part and of the side between the parts, which the
// crossings do not show (wall_end.h, hidden_side.h). Strips of polygons join the two vertices.
// Units: the coordinates of the cell. Source: own method; docs/contouring.md.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contour/components.h"
#include "contour/qef.h"
#include "grid/surface_probe.h"

namespace swept {

/// Two normals whose cosine is below this belong to the two sides of a thin wall (120 degrees).
constexpr double kMaxOpposedCosine = -0.5;

/// A crossing in the coordinates of one of its cells.
struct CrossingPoint {
  int slot;
  Eigen::Vector3d position, normal;  ///< in the coordinates of the cell

  static CrossingPoint of(const Cell& cell, int slot, const Crossing* crossings) {
    const Crossing& crossing = crossings[cell.crossing(slot)];
    return {slot, localPosition(slot >> 1, crossing.fraction), crossing.normal.cast<double>()};
  }
};

struct VertexSplit {
  /// Per slot of the component: part 0, part 1, or -1 for neither.
  std::array<std::int8_t, kSlots> part;
  std::vector<ProbeLine> between;  ///< hits on the side between the parts, in grid coordinates
  /// A point near that end of both features which the ring shows, in the coordinates of the cell;
  /// not set if no end is known better than the other.
  std::optional<Eigen::Vector3d> seen;
  /// Where the polygons of the two parts meet: pairs of slots on the faces of the cell. There are
  /// two of them, or none if the vertex cannot be split.
  std::vector<std::array<std::int8_t, 2>> folds;
  std::vector<std::int8_t> foldFaces;

  /// Finds the folds. Requires that every slot has a part, that each part is one arc of the ring of
  /// polygons, and that the arcs meet on faces that leave no choice of pairing.
  void findFolds(const Cell& cell, const Components& components, int component,
                 const Crossing* crossings);

  /// Where along the crease of a part's planes its vertex is placed, starting from the minimiser
  /// `best`. The few crossings of the part do not show how long the crease is, and the next cell
  /// may not know of it. The vertex is therefore placed half way between the walls of the cell, or
  /// three quarters of the way from the end that is `seen`.
  Eigen::Vector3d alongCrease(const Qef& planes, const Eigen::Vector3d& best) const;
};

}  // namespace swept
