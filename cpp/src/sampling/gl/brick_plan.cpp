// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/brick_plan.h"

#include <algorithm>
#include <string>

#include "swept/types.h"

namespace swept::gl {

std::vector<Brick> planBricks(const GridPlan& grid, const Limits& limits,
                              std::uint64_t budgetBytes) {
  // The shader uses 32-bit indices for the words of a brick.
  const std::uint64_t most =
      std::min<std::uint64_t>({budgetBytes / 4, static_cast<std::uint64_t>(limits.storageBytes) / 4,
                               std::uint64_t{1} << 30});
  if (most < 3) {
    throw Error(Status::DeviceUnavailable, "DeviceUnavailable",
                "no GPU can be used, because the GPU that was found has too little memory (in one "
                "piece: " +
                    std::to_string(limits.storageBytes) +
                    " bytes, for the grid: " + std::to_string(budgetBytes) +
                    " bytes; 12 bytes are needed of both)" + kDeviceAdvice);
  }
  const std::int32_t nx = grid.points[0], ny = grid.points[1], nz = grid.points[2];
  const auto atMost = [](std::int32_t points, std::uint64_t fitting) {
    return static_cast<std::int32_t>(std::min<std::uint64_t>(static_cast<std::uint64_t>(points),
                                                             std::max<std::uint64_t>(1, fitting)));
  };
  const std::int32_t words = atMost((nz + 31) / 32, most / 3), sizeZ = std::min(nz, 32 * words);
  const std::uint64_t row = 3 * static_cast<std::uint64_t>(words);
  const std::int32_t sizeY = atMost(ny, most / row);
  const std::int32_t sizeX = atMost(nx, most / (row * static_cast<std::uint64_t>(sizeY)));
  std::vector<Brick> bricks;
  for (std::int32_t i = 0; i < nx; i += sizeX) {
    for (std::int32_t j = 0; j < ny; j += sizeY) {
      for (std::int32_t k = 0; k < nz; k += sizeZ) {
        bricks.push_back(
            {{i, j, k},
             {std::min(sizeX, nx - i), std::min(sizeY, ny - j), std::min(sizeZ, nz - k)}});
      }
    }
  }
  return bricks;
}

}  // namespace swept::gl
