// A smooth plane curve that generates a surface: moved along a direction (extrusion) or rotated
// about an axis (revolution).
// In:      nodes in order, with slopes. Cubics with these slopes join them.
// Out:     signed distance (positive to the right of the direction of travel), normal, foot point.
// Units:   mm. The parameter is approximately the arc length.
// Cost:    constant per query near the curve.
// Note:    An open profile continues straight beyond its ends, so that the borders of faces do not
// lie at the end of the surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace swept::step {

class Profile {
 public:
  struct Node {
    Eigen::Vector2d at, slope;  ///< `slope`: derivative with respect to the parameter
    double knot = 0;
  };
  struct Foot {
    double t = 0;
    Eigen::Vector2d at, tangent;  ///< `tangent`: unit vector
  };

  /// A closed profile must repeat its first node at the end. `beyond`: mm, length of the straight
  /// pieces at the ends of an open profile.
  Profile(std::vector<Node> nodes, bool closed, double beyond);

  Foot foot(const Eigen::Vector2d& q) const;
  double distance(const Eigen::Vector2d& q) const;
  /// Returns the unit normal to the right.
  Eigen::Vector2d normal(const Eigen::Vector2d& q) const;
  /// Returns whether the foot point lies between the first and the last given node, not on a
  /// straight end piece.
  bool covers(const Eigen::Vector2d& q) const;

  Eigen::Vector2d at(double t) const;
  /// Computes the first and the second derivative.
  void derivatives(double t, Eigen::Vector2d& first, Eigen::Vector2d& second) const;

  bool isClosed() const { return closed_; }
  double length() const { return nodes_.back().knot - nodes_.front().knot; }
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Returns the profile shifted to the right by a distance that is small compared with its radii
  /// of curvature.
  Profile offset(double right) const;
  /// Returns the part of a closed profile from parameter `from`, through its closing node, to `to`.
  Profile opened(double from, double to) const;

 private:
  std::size_t spanOf(double t) const;
  void sample();
  void addToCells(std::int32_t segment, std::vector<std::vector<std::int32_t>>& cells) const;
  double bestOn(std::int32_t segment, const Eigen::Vector2d& q, double& smallest) const;

  std::vector<Node> nodes_;
  bool closed_ = false;
  double beyond_ = 0;
  double first_ = 0, last_ = 0;  // range of parameters without the straight end pieces
  // A polyline along the curve, and a grid that lists the segments near each cell.
  std::vector<Eigen::Vector2d> samples_;
  std::vector<double> sampleAt_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  double cell_ = 1;
  Eigen::Vector2i count_ = Eigen::Vector2i::Zero();
  std::vector<std::int32_t> cellStart_, cellSegments_;
};

}  // namespace swept::step
