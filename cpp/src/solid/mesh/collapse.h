// Edge collapses on shared arrays, so that parts of a mesh can be worked on at the same time.
// In: CollapseState: triangles with labels (a patch, or -1: open ground), what every vertex may do,
// and by triangle the points that must stay near it. Out: the same, triangles gone marked as dead.
// Invariants: the surface stays closed and manifold; every attached point within the tolerance of a
// triangle of open ground; a border stays near its patch's surface and does not pass over vertices
// of the patch. Order: cheapest quadric error first (Garland, Heckbert 1997).
// Cost: about 15 us a collapse.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "solid/mesh/patches.h"
#include "swept/run_context.h"

namespace swept::step {

/// Squared distances to planes, weighted.
struct PlaneQuadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double c = 0;

  void addPlane(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double weight) {
    const double d = -normal.dot(point);
    a += weight * normal * normal.transpose();
    b += weight * d * normal;
    c += weight * d * d;
  }
  PlaneQuadric operator+(const PlaneQuadric& o) const { return {a + o.a, b + o.b, c + o.c}; }
  double at(const Eigen::Vector3d& p) const { return p.dot(a * p) + 2 * b.dot(p) + c; }
};

enum class VertexKind : char { Free, Border, Fixed };

struct CollapseState {
  double tolerance = 0;  ///< mm
  const std::vector<Patch>* patches = nullptr;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> label;  ///< by triangle
  std::vector<std::vector<std::int32_t>> around;
  std::vector<std::vector<Eigen::Vector3d>> attached;  ///< by triangle: points that stay near it
  std::vector<PlaneQuadric> quadric;
  std::vector<char> gone, dead;  ///< vertices, triangles
  std::vector<VertexKind> kind;
  std::vector<std::uint32_t> stamp;
  /// By vertex: the part of the mesh in which it and all its neighbours lie, -1: no such part.
  std::vector<std::int32_t> part;
};

class Collapser {
 public:
  /// Works on edges between vertices of one part; part < 0: on all.
  Collapser(CollapseState& state, std::int32_t part, RunContext& run)
      : state_(state), part_(part), run_(run) {}
  /// Takes the edges at these vertices and goes on until none is left that may collapse.
  void work(const std::vector<std::int32_t>& vertices);

 private:
  struct Entry {
    double cost;
    std::int32_t from, to;  // `from` disappears into `to`
    std::uint32_t stampFrom, stampTo;
    bool operator<(const Entry& o) const {
      if (cost != o.cost) return cost > o.cost;
      return std::tie(from, to) > std::tie(o.from, o.to);
    }
  };

  bool isMine(std::int32_t v) const { return part_ < 0 || state_.part[v] == part_; }
  void neighbours(std::int32_t v, std::vector<std::int32_t>& result) const;
  bool isBorderEdge(std::int32_t a, std::int32_t b) const;
  bool mayGo(std::int32_t from, std::int32_t to) const;
  Eigen::Vector3d placeFor(std::int32_t from, std::int32_t to) const;
  void push(std::int32_t a, std::int32_t b);
  void pushAround(std::int32_t v, bool once);
  bool borderHolds(std::int32_t from, std::int32_t to);
  bool turnsOver(const std::array<Eigen::Vector3d, 3>& next, const Carrier& surface) const;
  bool linkIsSimple(std::int32_t from, std::int32_t to);
  void collapse(std::int32_t from, std::int32_t to);
  bool tryCollapse(std::int32_t from, std::int32_t to, const Eigen::Vector3d& place);
  bool reattach(std::int32_t from, std::int32_t to);
  bool findHomes(std::int32_t triangle, std::int32_t before, double limit);
  bool findHome(const Eigen::Vector3d& p, std::int32_t before, double limit);
  void apply(std::int32_t from, std::int32_t to, const Eigen::Vector3d& place);

  CollapseState& state_;
  std::int32_t part_;
  RunContext& run_;
  std::priority_queue<Entry> queue_;
  // Kept between calls for their memory.
  std::vector<std::int32_t> ring_, otherRing_, common_, staying_, dying_;
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;
  std::vector<std::pair<Eigen::Vector3d, std::int32_t>> moved_;  // and the new triangle
};

}  // namespace swept::step
