// Interface through which contouring casts lines at the swept surface, to find parts of the surface
// that no grid edge meets. crossings/element_probe implements it. Tests implement it with surfaces
// of known shape.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace swept {

/// A segment inside one cell, and its first intersection with the surface. Units: grid coordinates.
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
  /// Casts the lines at the part of the surface that is connected with the given crossings inside
  /// `region`. The region is at most a cell, in grid coordinates. Several threads may call this at
  /// the same time.
  virtual void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
                    std::vector<ProbeLine>& lines) const = 0;
};

}  // namespace swept
