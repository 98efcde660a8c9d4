// A body with planes and cylinders during one step of its motion: how its points move, and where
// its edges touch the envelope.
// Units:   mm; s is the fraction of the step. Times are s times the length of the step, in mm, so
//          that surfaces have parameters of similar size.
// Cost:    O(edges) for a question about the whole body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/elementary_body.h"
#include "solid/assemble/zero_curves.h"

namespace swept::step {

class BodyMotion {
 public:
  BodyMotion(const ElementaryBody& body, const StepPath& path);

  /// mm: the longest and the shortest path of a vertex.
  double length() const { return length_; }
  double shortest() const { return shortest_; }
  double timeOf(double s) const { return s * length_; }
  Range timeOf(Range s) const { return {timeOf(s.from), timeOf(s.to)}; }
  /// Returns where a point of the body is, in world coordinates.
  Eigen::Vector3d at(const Eigen::Vector3d& p, double s) const { return path_.at(s).apply(p); }

  /// Returns the speed n.v of a face along its normal, at points (u, s) of an edge.
  OfTwo speedOn(const BodyEdge& edge, int f) const;
  /// Returns the curves on which this speed is zero.
  std::vector<ZeroArc> contactsOf(const BodyEdge& edge, int f, Range s) const;
  /// Returns whether a face moves only along itself.
  bool doesSlide() const;
  /// Returns whether the edge is ever between a face that moves outward and one that moves inward.
  bool isOutline(const BodyEdge& edge) const;
  /// Returns the start and the end of the step, and between them the times at which a point of an
  /// edge moves along the edge. There the surface that the edge sweeps is pinched, and from there
  /// it intersects itself; cut at this time, its parts do not.
  std::vector<double> pinches() const;

 private:
  double speedOf(int f, const Eigen::Vector3d& p, double s) const;

  const ElementaryBody& body_;
  const StepPath& path_;
  double length_ = 0, shortest_ = HUGE_VAL;
};

}  // namespace swept::step
