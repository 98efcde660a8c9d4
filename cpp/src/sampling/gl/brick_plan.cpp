// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/brick_plan.h"

#include <algorithm>
#include <string>

#include "swept/types.h"

namespace swept::gl {

std::vector<Brick> planBricks(const GridPlan& grid, const Limits& limits,
                              std::uint64_t budgetBytes) {
  const std::int32_t image = std::min(limits.texture3d, 4096);
  const std::int32_t view = std::min(limits.viewport, limits.framebuffer);
  // The code of an edge is the 32-bit index of its bit, so an image may have at most 2^27 texels.
  const std::uint64_t texels = std::min<std::uint64_t>(budgetBytes / 4, std::uint64_t{1} << 26);
  if (image < 3 || view < 32 || texels < 3) {
    throw Error(Status::DeviceUnavailable, "DeviceUnavailable",
                "no GPU can be used: its limits are too small (3D image " +
                    std::to_string(limits.texture3d) + ", viewport " + std::to_string(view) +
                    ", budget " + std::to_string(budgetBytes) +
                    " bytes; at least 3, 32 and 12 are needed); use --backend cpu or auto");
  }
  const std::int32_t nx = grid.points[0], ny = grid.points[1], nz = grid.points[2];
  const auto smallest = [](std::int32_t a, std::int64_t b, std::int64_t c) {
    return static_cast<std::int32_t>(std::min<std::int64_t>({a, b, c}));
  };
  const std::int32_t bz = smallest(nz, view, 32 * std::int64_t{image});
  std::int32_t words = (bz + 31) / 32, sizeZ = bz;
  if (3 * static_cast<std::uint64_t>(words) > texels) {
    words = static_cast<std::int32_t>(texels / 3);
    sizeZ = 32 * words;
  }
  const auto row = 3 * static_cast<std::uint64_t>(words);
  const std::int32_t sizeY =
      smallest(smallest(ny, view, image), static_cast<std::int64_t>(texels / row), ny);
  const auto layer = row * static_cast<std::uint64_t>(sizeY);
  const std::int32_t sizeX =
      smallest(smallest(nx, view, image / 3),
               static_cast<std::int64_t>(std::max<std::uint64_t>(1, texels / layer)), nx);
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
