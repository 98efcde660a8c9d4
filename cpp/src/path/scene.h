// Holds the part and its neighbours for path searches.
// In:      meshes, clearances.
// Out:     answers to queries about placements and about moves between two placements.
// Units:   mm, rad. The length of a move is |shift| + angle x radius of the part. No point of the
// part travels farther than this length.
// Note:    Part and world are rotated so that their main axes become x, y and z. States refer to
// the rotated world; inside() and outside() convert.
// Cost:    tens of microseconds per query; the parts are prepared once.
// Promise: A move that is reported free is proven free (clearance/pair_search.h) for the given
// interpolation. A free move may be reported blocked if its distance exceeds the required one by
// less than the resolution.
// Source:  for the metric: S. LaValle, Planning Algorithms (2006), 5.1.
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
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< middle of the part, world
};

/// A move from a state: a shift of the middle and a rotation about it (axis times angle, world).
struct Twist {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  Twist operator*(double s) const { return {shift * s, turn * s}; }
};

/// A point where the part is near a neighbour. The normal points from the neighbour to the part.
struct Contact {
  int neighbour = -1;
  double distance = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the part, world
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// Distance to keep from each neighbour, mm; negative: this neighbour is ignored.
using Rule = std::vector<double>;

/// Data that a search keeps between queries, so that the pairs of triangles that blocked last are
/// tested first.
struct Memory {
  std::vector<clearance::LeafPair> pairs;  ///< one per neighbour
  std::size_t last = 0;                    ///< the neighbour that blocked last
  std::int64_t steps = 0;                  ///< number of queries
  std::vector<std::int64_t> blocked;       ///< for each neighbour, how often it blocked a move
};

/// Result of following a move.
struct Follow {
  double fraction = 1;  ///< fraction of the move, from its start, that is proven free
  int neighbour = -1;   ///< the neighbour that blocks the rest; -1: none
};

class Scene {
 public:
  /// Throws the errors of Part, and Error(Cancelled).
  Scene(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
        const PathOptions& options, RunContext& run);

  const clearance::Part& part() const { return part_; }
  bool partMended() const { return partMended_; }
  const clearance::Part& neighbour(std::size_t i) const { return neighbours_[i]; }
  bool neighbourMended(std::size_t i) const { return mended_[i] != 0; }
  std::size_t count() const { return neighbours_.size(); }
  /// Returns the box around all neighbours.
  const Eigen::AlignedBox3d& box() const { return box_; }
  /// Returns the largest distance of a point of the part from its middle, mm.
  double radius() const { return radius_; }
  Interpolation interpolation() const { return interpolation_; }

  /// Convert between a placement in the caller's world and a state.
  State inside(const Pose& pose) const;
  Pose outside(const State& state) const;
  /// Returns the rotation from the caller's world to the rotated world.
  const Eigen::Matrix3d& world() const { return world_; }

  State at(const Pose& pose) const;
  State at(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& middle) const;
  State moved(const State& from, const Twist& twist) const;
  static Twist between(const State& from, const State& to);
  double length(const Twist& twist) const {
    return twist.shift.norm() + radius_ * twist.turn.norm();
  }
  double distance(const State& a, const State& b) const;
  /// Returns the state at a fraction of the move from a to b, with interpolation().
  State stateBetween(const State& a, const State& b, double fraction) const;

  /// Returns the tree over a motion of the part (clearance/motion_tree.h).
  clearance::MotionTree motionTree(const Trajectory& motion) const {
    return {motion, partBox_.centre, partBox_.half};
  }
  Memory memory() const;
  bool isFree(const State& state, const Rule& rule, Memory& memory) const;
  /// Returns how far a move is free. Spans of the move are halved until they are proven free or as
  /// short as `finest`, a fraction of the move. A span of that length without proof counts as
  /// blocked.
  Follow follow(const State& from, const State& to, const Rule& rule, Memory& memory,
                double finest = 0) const;

 private:
  void followOne(const clearance::MotionTree& motion, std::size_t neighbour, double apart,
                 double finest, Follow& result, Memory& memory) const;

  Eigen::Matrix3d world_, own_;  ///< rotations of the world and of the part's frame
  bool partMended_ = false;
  clearance::Part part_;
  std::deque<clearance::Part> neighbours_;
  std::vector<char> mended_;
  Eigen::AlignedBox3d box_;
  clearance::Box partBox_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  ///< the middle in the part's frame
  double radius_ = 0;
  double resolution_ = 0;
  Interpolation interpolation_;
};

}  // namespace swept::path
