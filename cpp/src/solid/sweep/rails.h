// Rails: curves that cover a face of the body, on which points of contact are searched for. A point
// of the face has the parameters (w, v): the rail w, and the position v on the rail.
// In:      the carrier of a face, in coordinates of the body.
// Units:   mm, rad.
// Cost:    O(1).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "solid/carrier/carrier.h"

namespace swept::step {

class Rails {
 public:
  struct Point {
    Eigen::Vector3d at, normal;  ///< `normal`: outward unit normal
  };

  virtual ~Rails() = default;
  virtual Point at(double w, double v) const = 0;
  /// Returns the parameters (w, v) of a point near the face.
  virtual Eigen::Vector2d parametersOf(const Eigen::Vector3d& p) const = 0;
  /// Returns the periods of w and of v; 0 for a parameter that is not periodic.
  virtual std::array<double, 2> periods() const { return {0, 0}; }
  /// Returns false where (w, v) lies beyond the known part of the face.
  virtual bool covers(double, double) const { return true; }
};

/// Returns the rails of a face; null if there are none for this kind of face. There are two sets of
/// rails, which cross each other; `crossed` selects the second set. `direction`: for a plane, the
/// direction of w; ignored for other faces.
std::unique_ptr<const Rails> railsOf(const Carrier& face, bool crossed,
                                     const Eigen::Vector3d& direction);

}  // namespace swept::step
