// Clearance of a part that somebody moves by hand: one placement after another, each at once.
// In:    the part and the neighbours, prepared once; then placements. Units: mm. All in one world.
// Out:   the nearest pair of points at a placement; how far a move stays apart from all neighbours.
// Cost:  to prepare, as for a check; a placement some 10 microseconds far from all neighbours, up
// to
//        some milliseconds near large ones. One question at a time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "swept/clearance.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct LiveDistance {
  int neighbour = -1;   ///< the nearest one, in the order given
  double distance = 0;  ///< mm between the triangles; 0 where they meet or one part holds the other
  bool inside = false;  ///< one part lies inside the other without touching it
  Eigen::Vector3d pointOnPart = Eigen::Vector3d::Zero();  ///< world; both zero if inside
  Eigen::Vector3d pointOnNeighbour = Eigen::Vector3d::Zero();
};

class LiveClearance {
 public:
  /// Throws Error(InvalidInput) as checkClearance() fails (EmptyMesh, NoNeighbours, ...),
  /// Error(Cancelled).
  LiveClearance(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
                RunContext& run);
  ~LiveClearance();
  LiveClearance(LiveClearance&&) noexcept;
  LiveClearance& operator=(LiveClearance&&) noexcept;

  LiveDistance at(const Pose& pose);

  /// The last placement on the straight way from one to the other up to which the part stays at
  /// least `apart` mm (> 0) from all neighbours. From a place that is nearer: `to` if the part
  /// keeps the distance there, else `from`. Throws Error(InvalidInput) BadOption.
  Pose reached(const Pose& from, const Pose& to, double apart);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace swept
