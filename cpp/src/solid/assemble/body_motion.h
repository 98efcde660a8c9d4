// A body during one step of its motion: how its points move, and where its edges touch the
// envelope.
// Units:   mm; s is the fraction of the step. Times are s times the length of the step, in mm, so
//          that surfaces have parameters of similar size.
// Cost:    O(edges) for a question about the whole body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/body_geometry.h"
#include "solid/assemble/zero_curves.h"

namespace swept::step {

class BodyMotion {
 public:
  BodyMotion(const BodyGeometry& body, const StepPath& path);

  /// mm: the longest and the shortest path of a vertex.
  double length() const { return length_; }
  double shortest() const { return shortest_; }
  double timeOf(double s) const { return s * length_; }
  Range timeOf(Range s) const { return {timeOf(s.from), timeOf(s.to)}; }
  /// Returns where a point of the body is, in world coordinates.
  Eigen::Vector3d at(const Eigen::Vector3d& p, double s) const { return path_.at(s).apply(p); }

  /// Returns the normal of the plane in which a straight edge moves, in world coordinates; nothing
  /// if it does not move in a plane, or does not turn in it.
  std::optional<Eigen::Vector3d> planeOf(const BodyEdge& edge) const;

  /// Returns the speed n.v of a face along its normal, at points (u, s) of an edge.
  OfTwo speedOn(const BodyEdge& edge, int f) const;
  /// Returns the curves on which this speed is zero; none for a face that slides.
  std::vector<ZeroArc> contactsOf(const BodyEdge& edge, int f, Range s) const;
  bool doesTurn() const;
  /// Returns whether a face slides, that is, moves only along itself.
  bool slides(int f) const { return slides_[f]; }
  /// Returns whether a face at the edge slides. Such an edge sweeps no surface of its own.
  bool slidesAt(const BodyEdge& edge) const {
    return slides_[edge.faces[0]] || slides_[edge.faces[1]];
  }
  /// Returns whether the edge is ever between a face that moves outward and one that moves inward.
  bool isOutline(const BodyEdge& edge) const;
  /// Returns the times at which a point of the edge moves along the edge. There the surface that
  /// the edge sweeps is pinched, and from there it intersects itself; cut at this time, its parts
  /// do not.
  std::vector<double> pinchesOf(const BodyEdge& edge) const;

 private:
  double speedOf(const BodyEdge& edge, int f, double u, double s) const;
  // mm per unit of s: slower is taken as rest.
  double noSpeed() const;
  // Returns whether a face does not move along its normal at a point of an edge.
  bool isContact(const BodyEdge& edge, int f, double u, Range s) const;
  bool isSliding(int f) const;

  const BodyGeometry& body_;
  const StepPath& path_;
  double length_ = 0, shortest_ = HUGE_VAL;
  std::vector<char> slides_;  // by face
};

}  // namespace swept::step
