// Thin cylinders round small groups of triangles: on a curved or slanted surface a box with the
// axes of the mesh is as thick as it is wide, a cylinder whose axis is the surface's normal is
// flat. In:    the places of a tree of boxes. Units: mm. Out:   for a pair of nodes a gap, and the
// direction along which it is one. Cost:  about 20 bytes a triangle, a pass over the triangles for
// each of the lowest levels; a gap
//        costs about as much as that of two boxes.
// Promise: every corner of a node's triangles lies in its plate.
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
  double half = 0;       ///< of the height
  double radius = 0;
};

/// The plates of the lowest levels of a tree; items have none: their triangle says more.
class Plates {
 public:
  Plates() = default;
  /// `corners`: by place.
  Plates(const BoxTree& tree, const std::vector<Triangle3d>& corners);
  /// nullptr: this node has none.
  const Plate* of(BoxTree::Node node) const {
    const auto level = static_cast<std::size_t>(node.level);
    return level > 0 && level <= levels_.size() ? &levels_[level - 1][node.index] : nullptr;
  }

 private:
  std::vector<std::vector<Plate>> levels_;  ///< the first is that of the tree's level 1
};

/// Gap of two plates at one pose of the first one. No two points of them are nearer along
/// direction(), which is turned from the first to the second.
class PlateGap {
 public:
  PlateGap(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) : R_(R), t_(t) {}

  /// mm; not above 0: the plates may meet.
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
  /// Half of what the plate takes up along a direction that makes this cosine with its axis.
  static double extent(const Plate& plate, double cosine) {
    constexpr double kRounding = 1e-15;  // of the cosine's square, so that the root is no smaller
    return std::abs(cosine) * plate.half +
           std::sqrt(std::max(0.0, 1 - cosine * cosine) + kRounding) * plate.radius;
  }

  const Eigen::Matrix3d& R_;
  const Eigen::Vector3d& t_;
  const Plate* moving_ = nullptr;  ///< whose centre and axis are known in the still one's frame
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();
};

}  // namespace swept::clearance
