// Searches in six dimensions: one tree of moves grows from the start and another from the goal
// until they meet.
// In:      placements to grow from, and the space to search.
// Out:     placements from start to goal, with each move between two of them proven free.
// Units:   mm, rad.
// Cost:    some tens of microseconds per query. Finding the nearest node takes time linear in the
//        number of nodes.
// Promise: The result depends only on the seed and the number of rounds.
// Source:  Two trees: J. Kuffner, S. LaValle, RRT-Connect (2000). A blocked extension keeps its
// last free state and slides along the obstacle (slide.h): L. Zhang, D. Manocha, An efficient
// retraction-based RRT planner (2008). Pushes in fixed directions along contacts: Y. Tian et al.,
// Assemble them all (2022). Nodes in sparse cells grow first: I. Sucan, L. Kavraki, KPIECE (2009).
// A node is extended in the direction that led to it: S. Dalibard, J.-P. Laumond, Linear
// dimensionality reduction in random motion planning (2011).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "path/contacts.h"
#include "path/random_numbers.h"
#include "path/scene.h"
#include "path/slide.h"

namespace swept::path {

/// The space that is searched.
struct SearchSpace {
  Eigen::Vector3d low, high;   ///< bounds of the part's middle
  Eigen::Quaterniond upright;  ///< orientation at the goal
  double largestTurn = 4;      ///< rad from `upright`; pi or more: any; 0: never turns
  bool turns() const { return largestTurn > 0; }
  /// If set: a state of the goal's tree for which isOut() is true completes the path without the
  /// other tree.
  std::function<bool(const State&)> isOut;
};

class TwoTrees {
 public:
  TwoTrees(const Scene& scene, const Rule& rule, const SearchSpace& space,
           const std::vector<State>& starts, const std::vector<State>& goals, std::uint64_t seed);

  /// Grows the trees by up to `rounds` rounds. Returns true once a path is found.
  bool grow(int rounds);
  /// Returns the keys from one of the starts to one of the goals.
  const std::vector<State>& path() const { return path_; }
  std::size_t nodes() const { return trees_[0].size() + trees_[1].size(); }
  std::int64_t steps() const { return memory_.steps; }
  /// Returns the state in the goal's tree whose middle is farthest from the root of that tree.
  const State& farthest() const { return trees_[1][farthest_].state; }
  /// Returns for each neighbour how often it blocked a move.
  const std::vector<std::int64_t>& blocked() const { return memory_.blocked; }

 private:
  struct Node {
    State state;
    int parent;
    int cell;
    int tries;
    Touches touches;  ///< pairs that limit moves from here
  };
  /// A target: a state, or a constant twist. `step`: the longest single move; `most`: the length of
  /// all moves together.
  struct Drive {
    const State* to;
    Twist twist;
    double step, most;
    int moves;
  };
  using Tree = std::vector<Node>;
  using CellKey = std::array<int, 6>;

  int add(int tree, int parent, const State& state);
  int nearest(int tree, const State& to) const;
  int sparse(int tree);
  State sample();
  State sampleNear(int tree, int node);
  int chooseTree();
  State limited(const State& from, const State& to) const;
  /// Moves from a node towards a state and slides along obstacles. Returns the last node added, or
  /// `from` if there is none.
  int extend(int tree, int from, const State& to, double most, bool& reached);
  /// Moves from a node in one direction as far as possible and slides along obstacles. Returns the
  /// last node added, or `from` if there is none.
  int push(int tree, int from);
  Twist randomDrive(const State& at);
  int slide(int tree, int from, const Drive& drive, bool& reached);
  bool connect(int tree, int node);
  void finish(int startNode, int goalNode);

  const Scene& scene_;
  const Rule rule_;
  const SearchSpace space_;
  RandomNumbers random_;
  Memory memory_;
  Tree trees_[2];  ///< one tree from the start, one from the goal
  std::map<CellKey, int> cells_[2];
  std::vector<int> cellNodes_[2];
  std::vector<State> path_;
  int farthest_ = 0;
  double hardness_[2] = {1, 1};  ///< recent fraction of blocked extensions of each tree
  double longest_ = 0;           ///< mm, longest extension
  double shortest_ = 0;          ///< mm, shortest new edge
};

}  // namespace swept::path
