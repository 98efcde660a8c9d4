// Splits the vertex of a component that has two features, such as edges, in one cell. The crossings
// are divided into two parts, and each part gets a vertex.
//
// Each vertex is fitted to the planes of its part and of the side between the parts, which has few
// crossings or none (wall_end.h, hidden_side.h). Strips of polygons join the two vertices. Units:
// the coordinates of the cell. Source: own method; docs/contouring.md.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contour/components.h"
#include "contour/qef.h"
#include "grid/surface_probe.h"

namespace swept {

/// Two normals with a cosine below this (120 degrees) belong to opposite sides of a thin wall.
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
  /// The crossing on the side between the parts, in the coordinates of the cell; empty if there is
  /// none. The crossing lies near one end of both creases.
  std::optional<Eigen::Vector3d> seen;
  /// Folds: positions on the faces of the cell where the polygons of the two parts meet, each given
  /// by a pair of slots. There are two folds, or none if the vertex cannot be split.
  std::vector<std::array<std::int8_t, 2>> folds;
  std::vector<std::int8_t> foldFaces;

  /// Finds the folds. The polygons of the component form a ring, which `part` must divide into two
  /// connected arcs without leaving a polygon out. The arcs must meet on faces whose crossings can
  /// be paired in one way only. Otherwise there are no folds.
  void findFolds(const Cell& cell, const Components& components, int component,
                 const Crossing* crossings);

  /// Returns the position of a part's vertex along the crease of its planes; `best` is the
  /// minimiser. The few crossings of the part do not show how long the crease is, and those of the
  /// next cell may not show it, either. The vertex is therefore placed half way between the walls
  /// of the cell. If `seen` shows one end of the crease, the vertex is placed three quarters of the
  /// way from that end to the other.
  Eigen::Vector3d alongCrease(const Qef& planes, const Eigen::Vector3d& best) const;
};

}  // namespace swept
