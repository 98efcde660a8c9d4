// Search in six dimensions: a tree of moves from the start, one from the goal, until they meet.
// In:    placements to grow from, the space to search. Out: placements from start to goal, every
//        move between two of them proven free.
// Units: mm, rad. Cost: some tens of microseconds a question; linear in nodes for the nearest one.
// Promise: depends on the seed and the number of rounds alone.
// Sources: J. Kuffner, S. LaValle, RRT-Connect (2000); a blocked extension keeps its last free
//        state and slides on along what blocks it (slide.h), after L. Zhang, D. Manocha, An
//        efficient retraction-based RRT planner (2008); pushes in fixed directions along contacts,
//        after Y. Tian et al., Assemble them all (2022); nodes in sparse cells are grown first, I.
//        Sucan, L. Kavraki, KPIECE (2009); the direction that led to a node is tried again, after
//        S. Dalibard, J.-P. Laumond, Linear dimensionality reduction in random motion planning
//        (2011).
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

/// Where the search looks.
struct SearchSpace {
  Eigen::Vector3d low, high;   ///< of the part's middle
  Eigen::Quaterniond upright;  ///< how the part stands at the goal
  double largestTurn = 4;      ///< rad from there; 0: the part never turns
  bool turns() const { return largestTurn > 0; }
  /// A tree from the goal that reaches such a state needs no other one.
  std::function<bool(const State&)> isOut;
};

class TwoTrees {
 public:
  TwoTrees(const Scene& scene, const Rule& rule, const SearchSpace& space,
           const std::vector<State>& starts, const std::vector<State>& goals, std::uint64_t seed);

  /// True when the trees have met.
  bool grow(int rounds);
  /// From one of the starts to one of the goals.
  const std::vector<State>& path() const { return path_; }
  std::size_t nodes() const { return trees_[0].size() + trees_[1].size(); }
  std::int64_t steps() const { return memory_.steps; }
  /// The placement of the goal's tree whose middle is farthest from its root.
  const State& farthest() const { return trees_[1][farthest_].state; }
  /// How often each neighbour was in the way.
  const std::vector<std::int64_t>& blocked() const { return memory_.blocked; }

 private:
  struct Node {
    State state;
    int parent;
    int cell;
    int tries;
    Touches touches;  ///< that limit moves from here
  };
  /// A state to go to, or a twist that stays the same; the longest move, of all moves together.
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
  /// Moves from a node towards a state and slides on where it is blocked; the last node added.
  int extend(int tree, int from, const State& to, double most, bool& reached);
  /// Pushes a node one way, along all that it meets, as far as it goes; the last node added.
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
  Tree trees_[2];  ///< from the start, from the goal
  std::map<CellKey, int> cells_[2];
  std::vector<int> cellNodes_[2];
  std::vector<State> path_;
  int farthest_ = 0;
  double hardness_[2] = {1, 1};  ///< fraction of the extensions of a tree that were blocked, lately
  double longest_ = 0;           ///< mm, of one extension
  double shortest_ = 0;          ///< mm, of a new edge
};

}  // namespace swept::path
