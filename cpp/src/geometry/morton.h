// Morton codes: the interleaved bits of three coordinates.
//
// The octree node at level l above the leaves has the number code >> (3 * l).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace swept {

/// Spreads the lowest 21 bits, with two zero bits between neighbouring bits.
constexpr std::uint64_t spreadBits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

constexpr std::uint64_t mortonCode(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return spreadBits(i) << 2 | spreadBits(j) << 1 | spreadBits(k);
}

}  // namespace swept
