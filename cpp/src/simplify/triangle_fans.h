// Stores the triangles around each vertex of a closed manifold mesh whose vertices are merged one
// by one. Half-edges of a removed triangle have no start.
// Cost: O(n) to build; a merge costs O(k) for k neighbours.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/half_edges.h"
#include "swept/types.h"

namespace swept {

class TriangleFans {
 public:
  /// Vertices with more neighbours are not merged.
  static constexpr int kMaxNeighbours = 40;
  using Corners = std::array<std::int32_t, 3>;

  explicit TriangleFans(const TriMesh& mesh)
      : opposite_(std::move(findAdjacency(mesh).across)),
        start_(opposite_.size()),
        fan_(mesh.vertices.size(), -1) {
    for (std::size_t h = 0; h < start_.size(); ++h) {
      start_[h] = mesh.triangles[h / 3][h % 3];
      fan_[start_[h]] = static_cast<std::int32_t>(h);
    }
  }

  std::size_t triangles() const { return start_.size() / 3; }
  bool isGone(std::size_t triangle) const { return start_[3 * triangle] < 0; }
  bool wasMerged(std::int32_t v) const { return fan_[v] < 0; }
  std::int32_t start(std::int32_t h) const { return start_[h]; }
  std::int32_t target(std::int32_t h) const { return start_[nextHalfEdge(h)]; }
  /// Returns the corner of the triangle of `h` that does not lie on `h`.
  std::int32_t third(std::int32_t h) const { return start_[previousHalfEdge(h)]; }
  /// Returns a half-edge that starts at `v`.
  std::int32_t first(std::int32_t v) const { return fan_[v]; }
  /// Returns the next half-edge that starts at the same vertex, counter-clockwise.
  std::int32_t turn(std::int32_t h) const {
    return static_cast<std::int32_t>(opposite_[previousHalfEdge(h)]);
  }

  /// Returns whether v has at most `count` neighbours.
  bool hasAtMost(int count, std::int32_t v) const {
    std::int32_t h = fan_[v];
    do {
      if (--count < 0) return false;
      h = turn(h);
    } while (h != fan_[v]);
    return true;
  }

  /// Returns whether the mesh stays a closed manifold if the start of `edge` is merged into its
  /// target. Requires that the two share exactly two neighbours, each of which keeps three or more
  /// neighbours.
  bool staysManifold(std::int32_t edge) const {
    const std::int32_t v = target(edge);
    std::array<std::int32_t, kMaxNeighbours> ring;
    auto end = ring.begin();
    std::int32_t h = fan_[v];
    do {
      if (end == ring.end()) return false;
      *end++ = target(h);
      h = turn(h);
    } while (h != fan_[v]);
    std::ptrdiff_t common = 0;
    h = edge;
    do {
      common += std::count(ring.begin(), end, target(h));
      h = turn(h);
    } while (h != edge);
    return common == 2 && !hasAtMost(3, third(edge)) &&
           !hasAtMost(3, third(static_cast<std::int32_t>(opposite_[edge])));
  }

  /// Returns whether visit(corners) is true for the triangles at the target of `edge` that do not
  /// contain its start. Of a large fan, only visits the kMaxNeighbours triangles on each side of
  /// the edge: otherwise, thinning the rim of a disc whose triangles all meet in its centre would
  /// take time that is quadratic in their number.
  template <class Visit>
  bool allBeside(std::int32_t edge, const Visit& visit) const {
    const std::int32_t u = start_[edge], v = target(edge),
                       back = static_cast<std::int32_t>(opposite_[edge]);
    const auto visitAt = [&](std::int32_t h) {
      const Corners c{v, target(h), third(h)};
      return c[1] == u || c[2] == u || visit(c);
    };
    std::int32_t h = back;
    for (int n = 0; n <= kMaxNeighbours; ++n) {
      if (!visitAt(h)) return false;
      h = turn(h);
      if (h == back) return true;
    }
    h = back;
    for (int n = 0; n <= kMaxNeighbours; ++n) {
      h = nextHalfEdge(static_cast<std::int32_t>(opposite_[h]));  // against turn()
      if (!visitAt(h)) return false;
    }
    return true;
  }

  /// Merges the start of `edge` into its target.
  void merge(std::int32_t edge) {
    const std::int32_t u = start_[edge], v = target(edge),
                       back = static_cast<std::int32_t>(opposite_[edge]);
    std::int32_t h = edge;
    do {
      const std::int32_t following = turn(h);
      start_[h] = v;
      h = following;
    } while (h != edge);
    for (const std::int32_t side : {edge, back}) {
      const std::uint32_t a = opposite_[nextHalfEdge(side)], b = opposite_[previousHalfEdge(side)];
      opposite_[a] = b;
      opposite_[b] = a;
      // In fan_, remaining half-edges replace those of the two removed triangles.
      fan_[start_[a]] = static_cast<std::int32_t>(a);
      fan_[start_[b]] = static_cast<std::int32_t>(b);
    }
    for (const std::int32_t side : {edge, back}) {
      for (int k = 0; k < 3; ++k) start_[side / 3 * 3 + k] = -1;
    }
    fan_[u] = -1;
  }

 private:
  RawArray<std::uint32_t> opposite_;
  std::vector<std::int32_t> start_;  // for each half-edge, its start; -1: removed
  std::vector<std::int32_t> fan_;    // for each vertex, a half-edge that starts there; -1: removed
};

}  // namespace swept
