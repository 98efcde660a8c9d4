// Measures the clearance of a part while a user moves it, without delay at each placement.
// In:    the part and the neighbours, prepared once; then placements, in world coordinates. Units:
//        mm.
// Out:   the nearest pair of points at a placement; how far the part can move while it keeps a
//        distance from all neighbours.
// Cost:  preparation as for a check. A placement takes about 10 microseconds far from all
//        neighbours, and up to some milliseconds near large ones. Only one call may run at a time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "swept/clearance.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct LiveDistance {
  /// Index of the nearest neighbour, in the order given. Not set if the pose is not finite.
  std::optional<std::size_t> neighbour;
  /// mm between the triangles; 0 if they meet or one part lies inside the other.
  double distance = 0;
  bool inside = false;  ///< true: one part lies inside the other without touching it
  /// World coordinates; both points are zero if `inside`
  Eigen::Vector3d pointOnPart = Eigen::Vector3d::Zero();
  Eigen::Vector3d pointOnNeighbour = Eigen::Vector3d::Zero();
};

class LiveClearance {
 public:
  /// Throws Error(InvalidInput) in the cases in which checkClearance() fails (EmptyMesh,
  /// NoNeighbours, ...), and Error(Cancelled).
  LiveClearance(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
                RunContext& run);
  ~LiveClearance();
  LiveClearance(LiveClearance&&) noexcept;
  LiveClearance& operator=(LiveClearance&&) noexcept;

  LiveDistance at(const Pose& pose);

  /// Moves the part in a straight line from `from` towards `to`. Returns the last placement up to
  /// which the part stays at least `apart` mm (> 0) from all neighbours. If the part is closer than
  /// that already at `from`, returns `to` if the part keeps the distance there, otherwise `from`.
  /// Throws Error(InvalidInput, "BadOption").
  Pose reached(const Pose& from, const Pose& to, double apart);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace swept
