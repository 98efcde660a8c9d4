// What contouring may ask of the swept surface beyond its crossings with the grid: where it meets
// other lines. Implemented by sampling, or by a test that knows the surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace swept {

/// A segment inside one cell, and the first point of the surface met on the way. Grid coordinates.
struct ProbeLine {
  Eigen::Vector3d from, to;
  bool hit = false;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards `from`
  double timeSeconds = 0;
};

class SurfaceProbe {
 public:
  virtual ~SurfaceProbe() = default;
  /// Casts the lines against the part of the surface that passes through the region (a cell or less
  /// of one, grid coordinates) and hangs together, inside it, with the given crossings. Safe to
  /// call from several threads.
  virtual void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
                    std::vector<ProbeLine>& lines) const = 0;
};

}  // namespace swept
