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
  /// Adds a chain, unless it is a sum of earlier ones. Then returns the names of these. Otherwise
  /// empty.
  std::vector<int> add(Chain chain, int name);

  /// Reduces the chain by those of the basis. Returns the names of those whose sum was taken off.
  std::vector<int> reduce(Chain& chain) const;

 private:
  struct Row {
    Chain chain, names;
  };
  std::map<int, Row> rows_;  // by the first edge of the chain
};

}  // namespace swept::step
