// Sums of edges in which an edge that occurs twice cancels out (chains over the integers modulo 2).
// Cost:    O(n^2 e) for n chains of e edges.
// Method:  Gaussian elimination. The border of a surface is the sum of the borders of its pieces,
//          so pieces close a surface if the sum of their borders is its border.
//          H. Edelsbrunner, J. Harer, Computational topology, 2010, section IV.2.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

namespace swept::step {

/// Numbers of edges, by size.
using Chain = std::vector<int>;

Chain sumOf(const Chain& a, const Chain& b);

/// Chains, none of which is a sum of others.
class ChainBasis {
 public:
  /// If the chain is a sum of earlier chains, returns the names of these and adds nothing.
  /// Otherwise adds it under a name, a number of the caller's choice, and returns nothing.
  std::vector<int> add(Chain chain, int name);

  /// Subtracts chains of the basis until none of them shares its first edge with the rest. Returns
  /// the names of the chains that were added and make up what was subtracted. Nothing is left of
  /// the chain if it is a sum of them.
  std::vector<int> reduce(Chain& chain) const;

 private:
  struct Row {
    Chain chain, names;
  };
  std::map<int, Row> rows_;  // by the first edge of the chain
};

}  // namespace swept::step
