// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/cell.h"

namespace swept {

std::array<bool, 8> outsideCorners(const Cell& cell) {
  std::array<std::int8_t, 8> sign;  // 1 outside, 0 inside, -1 not known yet
  sign.fill(-1);
  const auto ends = [](int edge) {
    const int a = edge >> 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const int low = (edge & 1) << b | (edge >> 1 & 1) << c;
    return std::array<int, 2>{low, low | 1 << a};
  };
  for (int edge = 0; edge < kEdges; ++edge) {
    const auto [low, high] = ends(edge);
    if (!cell.has(2 * edge) && !cell.has(2 * edge + 1)) continue;
    sign[low] = cell.has(2 * edge) ? 1 : 0;
    sign[high] = cell.has(2 * edge + 1) ? 1 : 0;
  }
  for (int round = 0; round < 3; ++round) {  // edges without a crossing hand the sign on
    for (int edge = 0; edge < kEdges; ++edge) {
      const auto [low, high] = ends(edge);
      if (cell.has(2 * edge) || cell.has(2 * edge + 1)) continue;
      if (sign[low] < 0) sign[low] = sign[high];
      if (sign[high] < 0) sign[high] = sign[low];
    }
  }
  std::array<bool, 8> outside;
  for (int corner = 0; corner < 8; ++corner) outside[corner] = sign[corner] != 0;
  return outside;
}

}  // namespace swept
