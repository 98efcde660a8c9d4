// Adjacency of a triangle list: half-edges grouped by undirected edge, and their neighbours.
//
// In: triangles with indices inside [0, vertexCount), in any condition: open, non-manifold,
// misoriented. Half-edge h = 3 * triangle + k runs from corner k to corner k + 1 (mod 3).
// Out: EdgeTable: one 64-bit record per half-edge, grouped by its smaller vertex, sorted within the
// group. Adjacency: the half-edge on the other side of each half-edge, and the number of faults of
// each kind.
// Cost: O(n) time for n triangles; 8 bytes per half-edge and 4 per vertex for the table, 4 per
// half-edge for the neighbours. Method: a counting sort by several threads, without hashing.
// Promise: the order depends on the triangles alone, never on threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/lists_by_key.h"
#include "base/raw_array.h"
#include "swept/types.h"

namespace swept {

using Triangles = std::vector<std::array<std::int32_t, 3>>;

/// Entry of Adjacency::across for a half-edge without a neighbour.
constexpr std::uint32_t kNoNeighbour = 0xffffffffu;

/// Returns the half-edge after `h` in its triangle; previousHalfEdge() returns the one before `h`.
template <class Number>
Number nextHalfEdge(Number h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
template <class Number>
Number previousHalfEdge(Number h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// Returns a number for the edge between two vertices, the same for both directions.
inline std::uint64_t edgeKey(std::int32_t a, std::int32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
         static_cast<std::uint32_t>(std::max(a, b));
}

class EdgeTable {
 public:
  EdgeTable(const Triangles& triangles, std::size_t vertexCount);
  explicit EdgeTable(const TriMesh& mesh) : EdgeTable(mesh.triangles, mesh.vertices.size()) {}

  std::int64_t vertexCount() const { return static_cast<std::int64_t>(groups_.keys()); }
  const RawArray<std::uint64_t>& records() const { return groups_.values(); }

  static std::int32_t high(std::uint64_t record) { return static_cast<std::int32_t>(record >> 33); }
  /// Returns whether the half-edge runs from the smaller to the larger vertex.
  static bool ascending(std::uint64_t record) { return ((record >> 32) & 1u) == 0; }
  static std::int64_t halfEdge(std::uint64_t record) {
    return static_cast<std::int64_t>(record & 0xffffffffu);
  }

  /// Calls visit(low, high, first, last) for each undirected edge whose smaller vertex lies in
  /// [lowBegin, lowEnd). [first, last) are the records of its half-edges, the ascending ones first.
  template <class Visit>
  void forEachEdge(std::int64_t lowBegin, std::int64_t lowEnd, Visit&& visit) const {
    for (std::int64_t low = lowBegin; low < lowEnd; ++low) {
      const std::span group = groups_.asTheyStand(static_cast<std::size_t>(low));
      const std::uint64_t *first = group.data(), *end = first + group.size();
      while (first != end) {
        const std::uint64_t* last = first + 1;
        while (last != end && high(*last) == high(*first)) ++last;
        visit(static_cast<std::int32_t>(low), high(*first), first, last);
        first = last;
      }
    }
  }
  template <class Visit>
  void forEachEdge(Visit&& visit) const {
    forEachEdge(0, vertexCount(), visit);
  }

 private:
  ListsByKey<std::uint64_t> groups_;  ///< by smaller vertex
};

struct EdgeFaults {
  std::int64_t open = 0;         ///< edges with one triangle
  std::int64_t nonManifold = 0;  ///< edges with more than two triangles
  std::int64_t odd = 0;          ///< edges with an odd number of triangles
  /// Edges with two or more triangles, but not equally many in each direction.
  std::int64_t misoriented = 0;
};

struct Adjacency {
  /// Per half-edge: the half-edge on the other side, if the edge has exactly two triangles (in any
  /// orientation); otherwise kNoNeighbour.
  RawArray<std::uint32_t> across;
  EdgeFaults faults;
};

Adjacency findAdjacency(const EdgeTable& edges);
Adjacency findAdjacency(const TriMesh& mesh);

/// Returns, per vertex, the half-edges that start at it.
ListsByKey<> halfEdgesByVertex(const TriMesh& mesh);

}  // namespace swept
