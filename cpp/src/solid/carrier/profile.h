// A smooth plane curve that generates a surface: moved along a direction (extrusion) or turned
// about an axis (revolution).
// In: nodes in order, with slopes; cubics with common slopes join them. Out: signed distance
// (positive to the right of the direction of travel), normal, foot point. Units: mm; the parameter
// is approximately the arc length. Cost of a query: constant near the curve.
// An open profile continues straight beyond its ends, so that the borders of faces have room.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace swept::step {

class Profile {
 public:
  struct Node {
    Eigen::Vector2d at, slope;  ///< derivative by the parameter
    double knot = 0;
  };
  struct Foot {
    double t = 0;
    Eigen::Vector2d at, tangent;  ///< tangent: unit
  };

  /// A closed profile repeats its first node at the end. beyond: mm, length of the straight pieces
  /// at the ends of an open one.
  Profile(std::vector<Node> nodes, bool closed, double beyond);

  Foot foot(const Eigen::Vector2d& q) const;
  double distance(const Eigen::Vector2d& q) const;
  /// Unit, to the right.
  Eigen::Vector2d normal(const Eigen::Vector2d& q) const;
  /// Whether the foot point lies between the first and the last given node, and not on a straight
  /// end piece.
  bool covers(const Eigen::Vector2d& q) const;

  Eigen::Vector2d at(double t) const;
  /// First and second derivative.
  void derivatives(double t, Eigen::Vector2d& first, Eigen::Vector2d& second) const;

  bool isClosed() const { return closed_; }
  double length() const { return nodes_.back().knot - nodes_.front().knot; }
  const std::vector<Node>& nodes() const { return nodes_; }

  /// The profile moved to the right by a distance that is small against its radii of curvature.
  Profile offset(double right) const;
  /// The part of a closed profile that runs from `from` past its end to `to` (parameters).
  Profile opened(double from, double to) const;

 private:
  std::size_t spanOf(double t) const;
  void sample();
  void addToCells(std::int32_t segment, std::vector<std::vector<std::int32_t>>& cells) const;
  double bestOn(std::int32_t segment, const Eigen::Vector2d& q, double& smallest) const;

  std::vector<Node> nodes_;
  bool closed_ = false;
  double beyond_ = 0;
  double first_ = 0, last_ = 0;  // parameters without the straight end pieces
  // A polyline along the curve, and which of its segments are near each cell of a grid.
  std::vector<Eigen::Vector2d> samples_;
  std::vector<double> sampleAt_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  double cell_ = 1;
  Eigen::Vector2i count_ = Eigen::Vector2i::Zero();
  std::vector<std::int32_t> cellStart_, cellSegments_;
};

}  // namespace swept::step
