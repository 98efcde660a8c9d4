// Cuts the grid into bricks. The marks of a brick (one bit per lattice edge) fit into one storage
// block of the device and into a memory budget. Bricks are slabs of whole layers if these fit. If
// not, layers are cut along y, then along z. The cuts do not change the result. Cost: O(bricks).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "sampling/gl/gl_context.h"

namespace swept::gl {

struct Brick {
  std::array<std::int32_t, 3> low{0, 0, 0}, size{0, 0, 0};  ///< lattice points

  std::int32_t words() const { return (size[2] + 31) / 32; }  ///< words along z, 32 edges each
  std::uint64_t markWords() const {
    return std::uint64_t{3} * size[0] * size[1] * static_cast<std::uint64_t>(words());
  }
};

/// Returns the bricks, slab by slab. Within a slab of layers they are ordered by y, then by z.
/// Throws Error(DeviceUnavailable) if not even the smallest brick (1 x 1 x 32 points) fits.
std::vector<Brick> planBricks(const GridPlan& grid, const Limits& limits,
                              std::uint64_t budgetBytes);

}  // namespace swept::gl
