// The part among its neighbours, as searches for a path see it.
// In:    meshes, clearances. Out: answers about placements and about moves between two placements.
// Frames: the part and the world are turned so that their main axes are x, y and z; states are in
//        that world. inside() and outside() lead in and out.
// Units: mm, rad. The length of a move is |dt| + angle x radius of the part: no point travels more.
// Cost:  some ten microseconds a question; the parts are prepared once.
// Promise: a move that is called free is proven so (clearance/pair_search.h), with the
//          interpolation of the motion to come. A move that is free may be called blocked where
//          it passes less than the resolution farther off than asked.
// Source: the metric, S. LaValle, Planning Algorithms (2006), 5.1.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <deque>
#include <string>
#include <vector>

#include "clearance/motion_tree.h"
#include "clearance/pair_search.h"
#include "swept/path.h"

namespace swept::path {

/// A placement of the part.
struct State {
  Pose pose;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< of the part, world
};

/// A move from a state: shift of the middle, turn about it (axis times angle, world).
struct Twist {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  Twist operator*(double s) const { return {shift * s, turn * s}; }
};

/// Where the part is near a neighbour; the normal looks from the neighbour to the part.
struct Contact {
  int neighbour = -1;
  double distance = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< world, of the part
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// Distance to keep from each neighbour, mm; negative: this one does not count.
using Rule = std::vector<double>;

/// What one search remembers from question to question: the pairs that were in the way last.
struct Memory {
  std::vector<clearance::LeafPair> pairs;  ///< one a neighbour
  std::size_t last = 0;                    ///< neighbour that was in the way last
  std::int64_t steps = 0;                  ///< questions asked
  std::vector<std::int64_t> blocked;       ///< how often each neighbour was in the way
};

/// How far a move is free.
struct Follow {
  double fraction = 1;  ///< of the move, from its start, that is proven free
  int neighbour = -1;   ///< what is in the way behind that
};

class Scene {
 public:
  /// Throws Error(InvalidInput) as Part does, Error(Cancelled).
  Scene(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
        const PathOptions& options, RunContext& run);

  const clearance::Part& part() const { return part_; }
  bool partMended() const { return partMended_; }
  const clearance::Part& neighbour(std::size_t i) const { return neighbours_[i]; }
  bool neighbourMended(std::size_t i) const { return mended_[i] != 0; }
  std::size_t count() const { return neighbours_.size(); }
  /// Box round all neighbours.
  const Eigen::AlignedBox3d& box() const { return box_; }
  /// Of the part about its middle, mm.
  double radius() const { return radius_; }
  Interpolation interpolation() const { return interpolation_; }

  /// From a placement as the caller has it, and back.
  State inside(const Pose& pose) const;
  Pose outside(const State& state) const;
  /// Turns directions and points of the caller's world into this one.
  const Eigen::Matrix3d& world() const { return world_; }

  State at(const Pose& pose) const;
  State at(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& middle) const;
  State moved(const State& from, const Twist& twist) const;
  static Twist between(const State& from, const State& to);
  double length(const Twist& twist) const {
    return twist.shift.norm() + radius_ * twist.turn.norm();
  }
  double distance(const State& a, const State& b) const;
  /// On the way from a to b as the motion will take it.
  State stateBetween(const State& a, const State& b, double fraction) const;

  /// Of the part.
  clearance::MotionTree motionTree(const Trajectory& motion) const {
    return {motion, partBox_.centre, partBox_.half};
  }
  Memory memory() const;
  bool isFree(const State& state, const Rule& rule, Memory& memory) const;
  /// `finest`: fraction of the move at which halving stops: a span of this length whose proof fails
  /// counts as blocked.
  Follow follow(const State& from, const State& to, const Rule& rule, Memory& memory,
                double finest = 0) const;

 private:
  void followOne(const clearance::MotionTree& motion, std::size_t neighbour, double apart,
                 double finest, Follow& result, Memory& memory) const;

  Eigen::Matrix3d world_, own_;  ///< of the world, of the part's frame
  bool partMended_ = false;
  clearance::Part part_;
  std::deque<clearance::Part> neighbours_;
  std::vector<char> mended_;
  Eigen::AlignedBox3d box_;
  clearance::Box partBox_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  ///< in the part's frame
  double radius_ = 0;
  double resolution_ = 0;
  Interpolation interpolation_;
};

}  // namespace swept::path
