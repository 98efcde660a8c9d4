// Finds points of contact, where the normal n of a face of the moving body is orthogonal to its
// velocity v. Follows them over rails (rails.h) and time.
// In:      rails of a face, the motion, a range of rails and time, and a start.
// Units:   mm, rad.
// Cost:    O(kNodes^2) steps of Newton's method first, then O(1) per point.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "solid/sweep/rails.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {

/// The motion at one time, in coordinates of the body: a point p has the velocity linear + angular
/// x p.
struct Moment {
  Moment(const StepPath& path, double s);
  Eigen::Vector3d velocityAt(const Eigen::Vector3d& x) const { return linear + angular.cross(x); }
  Placement placement;
  Eigen::Vector3d linear, angular;  // per unit of s, in coordinates of the body
};

class ContactMap {
 public:
  /// `size`: mm, extent of the points of contact.
  ContactMap(const Rails& rails, const StepPath& path, double size)
      : rails_(rails), path_(path), size_(size) {}

  /// Returns n.v at one point, in mm per unit of s.
  double speed(double w, double v, const Moment& moment) const;
  /// Returns the derivatives of n.v with respect to the length along the rail and the length across
  /// the rails.
  Eigen::Vector2d slopes(double w, double v, const Moment& moment) const;
  /// Returns the parameter v of the contact on rail w near the given v, if Newton's method finds
  /// one.
  std::optional<double> solve(double w, double v, const Moment& moment) const;

  /// Follows the contact from `start` (w, v, s) over the ranges of w and s. Returns how the contact
  /// degenerates within the inner ranges; `where` receives the parameters (w, s). Whether it
  /// degenerates in the margin around the inner ranges does not matter.
  Degeneracy follow(Range w, Range s, Range innerW, Range innerS, const Eigen::Vector3d& start,
                    Eigen::Vector2d& where);
  /// Returns the parameter v of the contact at (w, s) in the range that was followed. NaN if there
  /// is none.
  double parameterAt(double w, double s) const;

 private:
  static constexpr int kNodes = 24;  // intervals in each direction
  double& node(int i, int j) { return parameters_[i * (kNodes + 1) + j]; }
  double node(int i, int j) const { return parameters_[i * (kNodes + 1) + j]; }
  double lengthPer(double w, double v, bool alongRail) const;

  const Rails& rails_;
  const StepPath& path_;
  double size_;
  Range w_, s_;
  std::vector<double> parameters_;
};

}  // namespace swept::step
