// A component with two features in one cell gets two vertices: one for each part of its crossings,
// each with the planes of its part and of the side between them, which no crossing tells of. Strips
// of polygons join the two (METHOD: more than one feature in a component).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contour/components.h"
#include "contour/qef.h"
#include "grid/surface_probe.h"

namespace swept {

/// Cosine below which two normals are of the two sides of a thin wall.
constexpr double kOpposed = -0.5;

/// A crossing as its cell sees it.
struct CrossingPoint {
  int slot;
  Eigen::Vector3d position, normal;  ///< in the cell's coordinates

  static CrossingPoint of(const Cell& cell, int slot, const Crossing* crossings) {
    const Crossing& crossing = crossings[cell.crossing(slot)];
    return {slot, localPosition(slot >> 1, crossing.fraction), crossing.normal.cast<double>()};
  }
};

struct VertexSplit {
  /// Per slot of the component: 0 the one part, 1 the other, -1 neither.
  std::array<std::int8_t, kSlots> part;
  std::vector<ProbeLine> between;  ///< hits on the side between the parts, in grid coordinates
  /// Near the end of both features that the ring shows, in the cell's coordinates; else both ends
  /// of a feature are as good.
  std::optional<Eigen::Vector3d> seen;
  /// Where the polygons of the two parts meet: the pairs of slots on the cell's faces. Two of them,
  /// or none if the vertex cannot be split.
  std::vector<std::array<std::int8_t, 2>> folds;
  std::vector<std::int8_t> foldFaces;

  /// The folds, if every slot has a part, the ring of polygons falls into just one arc for each,
  /// and the two are joined through faces that leave no choice.
  void findFolds(const Cell& cell, const Components& components, int component,
                 const Crossing* crossings);

  /// Where on the crease of a part's planes its vertex goes, from the best place for them alone.
  /// The part's crossings are too few to tell how long the crease is, and nothing in the cell
  /// behind the wall that it leaves through may go on with it: the vertex stands half way between
  /// the cell's walls, three quarters of the way from the end that is seen.
  Eigen::Vector3d alongCrease(const Qef& planes, const Eigen::Vector3d& best) const;
};

}  // namespace swept
