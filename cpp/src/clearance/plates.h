// Encloses small groups of triangles in thin cylinders ("plates"). On a curved or slanted surface,
// a box aligned with the axes of the mesh is as thick as it is wide. A cylinder whose axis is the
// surface normal is flat there.
// In:      a bounding volume hierarchy of triangles.
// Out:     for a pair of nodes, a lower bound of their distance, and a direction along which they
//        are at least this far apart.
// Units:   mm.
// Cost:    about 20 bytes per triangle and one pass over the triangles for each of the lowest
//          levels. The gap of two plates costs about as much as the gap of two boxes.
// Promise: each vertex of the triangles of a node lies in the plate of the node.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/triangle_distance.h"

namespace swept::clearance {

struct Plate {
  Eigen::Vector3d centre;
  Eigen::Vector3d axis;  ///< unit length
  double half = 0;       ///< half the height
  double radius = 0;
};

/// Plates of the lowest levels of a tree. Single triangles have none, because the triangle itself
/// is more exact.
class Plates {
 public:
  Plates() = default;
  /// `corners[place]` are the vertices of the triangle at that place of the tree.
  Plates(const BoxTree& tree, const std::vector<Triangle3d>& corners);
  /// Returns nullptr if the node has no plate.
  const Plate* of(BoxTree::Node node) const {
    const auto level = static_cast<std::size_t>(node.level);
    return level > 0 && level <= levels_.size() ? &levels_[level - 1][node.index] : nullptr;
  }

 private:
  std::vector<std::vector<Plate>> levels_;  ///< levels_[0] belongs to level 1 of the tree
};

/// A lower bound (gap) of the distance of two plates, the first one at pose (R, t). Along
/// direction(), which points from the first plate to the second, no two of their points are nearer
/// than the gap.
class PlateGap {
 public:
  PlateGap(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) : R_(R), t_(t) {}

  /// Returns the gap in mm. If it is 0 or negative, the plates may intersect.
  double between(const Plate& moving, const Plate& still) {
    if (&moving != moving_) {
      moving_ = &moving;
      centre_ = R_ * moving.centre + t_;
      axis_ = R_ * moving.axis;
    }
    const Eigen::Vector3d offset = still.centre - centre_;
    const double lean = axis_.dot(still.axis);
    const double onMoving = axis_.dot(offset), onStill = still.axis.dot(offset);
    double gap = std::abs(onMoving) - moving.half - extent(still, lean);
    direction_ = onMoving < 0 ? Eigen::Vector3d(-axis_) : axis_;
    const double other = std::abs(onStill) - still.half - extent(moving, lean);
    if (other > gap) {
      gap = other;
      direction_ = onStill < 0 ? Eigen::Vector3d(-still.axis) : still.axis;
    }
    const double apart = offset.norm();
    if (apart <= gap) return gap;
    const double along = apart - extent(moving, onMoving / apart) - extent(still, onStill / apart);
    if (along > gap) {
      gap = along;
      direction_ = offset / apart;
    }
    return gap;
  }
  const Eigen::Vector3d& direction() const { return direction_; }

 private:
  /// Returns half the extent of the plate along a direction. `cosine`: cosine of the angle between
  /// this direction and the axis.
  static double extent(const Plate& plate, double cosine) {
    constexpr double kRounding = 1e-15;  // so that rounding never makes the square root too small
    return std::abs(cosine) * plate.half +
           std::sqrt(std::max(0.0, 1 - cosine * cosine) + kRounding) * plate.radius;
  }

  const Eigen::Matrix3d& R_;
  const Eigen::Vector3d& t_;
  /// The plate to which centre_ and axis_ belong; both are in the frame of the still part.
  const Plate* moving_ = nullptr;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();
};

}  // namespace swept::clearance
