// Cuts a triangle at the middles of its sides.
// Units: any one unit of length. Cost: O(1).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace swept {

/// The middle of a side that is not cut.
constexpr std::int32_t kNotCut = -1;

/// Cuts a triangle into 1 to 4 pieces, so that triangles that share a side fit together.
/// `middle`: the vertices in the middle of the sides, or kNotCut. Side k begins at corner k.
/// `squaredDistance(a, b)`: of two vertices; if two sides are cut, the shorter diagonal is taken.
/// Calls add(a, b, c) for each piece.
template <class SquaredDistance, class Add>
void cutTriangle(std::array<std::int32_t, 3> corners, std::array<std::int32_t, 3> middle,
                 const SquaredDistance& squaredDistance, const Add& add) {
  const auto cuts = 3 - std::count(middle.begin(), middle.end(), kNotCut);
  // Turn the triangle until its first side is the only one that is cut, or the only one that is
  // not.
  while ((cuts == 1 || cuts == 2) && (middle[0] != kNotCut) != (cuts == 1)) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    std::rotate(middle.begin(), middle.begin() + 1, middle.end());
  }
  const auto [a, b, c] = corners;
  const auto [ab, bc, ca] = middle;
  if (cuts == 0) {
    add(a, b, c);
  } else if (cuts == 1) {
    add(a, ab, c);
    add(ab, b, c);
  } else {
    add(ca, bc, c);
    if (cuts == 3) {
      add(a, ab, ca);
      add(ab, b, bc);
      add(ab, bc, ca);
    } else if (squaredDistance(a, bc) <= squaredDistance(b, ca)) {
      add(a, b, bc);
      add(a, bc, ca);
    } else {
      add(a, b, ca);
      add(b, bc, ca);
    }
  }
}

}  // namespace swept
