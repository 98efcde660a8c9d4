// Divides the six faces of a cell into the two sides of each ring: the closed chain of chords that
// bounds one piece of surface in the cell (cell_rings.h).
//
// In: the rings of a cell. Out: for each ring, its left and its right side as flat polygons on the
// six faces; and how the rings are nested.
// Units: the coordinates of the cell. Cost: microseconds.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "contour/mend/cell_rings.h"
#include "geometry/flat_polygons.h"

namespace swept {

/// A choice of one side for every ring. Any two chosen sides are nested or disjoint.
struct Nesting {
  std::vector<bool> left;  ///< true: the left side, seen from outside the cell; false: the right
  /// 1 for a side that contains no other chosen side; otherwise one more than the largest height
  /// among the sides that it contains.
  std::vector<int> height;
};

class RingSides {
 public:
  RingSides(const Cell& cell, const Crossing* crossings, const std::vector<CellRing>& rings);

  Nesting nesting() const;

  /// Returns the crossings of a ring, each followed by the point on the chord after it, and then
  /// the corners of the cell.
  std::vector<Eigen::Vector3d> wallPoints(std::size_t ring) const;

  struct Piece {
    int face;
    Loop corners;  ///< counter-clockwise seen from outside the cell; indices of wallPoints()
  };
  /// Returns one side of a ring, cut into pieces of the six faces.
  std::vector<Piece> pieces(std::size_t ring, bool left) const;

 private:
  enum class Side : std::int8_t { Unknown = -1, Right = 0, Left = 1 };
  struct Cut {
    std::vector<Piece> pieces;
    std::vector<Side> sides;  // per piece
    std::array<Side, 8> corners;
  };
  Cut cut(const CellRing& ring) const;
  void cutFace(const CellRing& ring, int face, Cut& out) const;
  /// Returns whether the ring `other` lies on the left side of the ring `of`.
  bool isLeft(std::size_t of, std::size_t other) const;

  const Cell& cell_;
  const Crossing* crossings_;
  const std::vector<CellRing>& rings_;
  std::vector<Cut> cuts_;
};

}  // namespace swept
