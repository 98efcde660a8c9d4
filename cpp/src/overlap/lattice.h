// Two meshes on one lattice of whole numbers, where no two things ever lie on each other.
// In:    the points of both meshes, mm. Out: signs of orientations, exact and never 0 but for
//        triangles without area.
// Units: steps of the lattice, 2^-38 of the longest side of both meshes' common box.
// Cost:  a few nanoseconds a sign: products of three differences fit into 128 bits.
// Method: ties are decided as if the smaller mesh had shrunk a little about the centre of its box
//        and had then been moved by less still: x -> x - e (x - centre) + (e^2, e^3, e^4), e -> 0
//        (simulation of simplicity; Edelsbrunner and Muecke 1990). So parts that only touch come
//        apart, and where two faces lie on each other the inner one counts. All signs below are
//        linear in the shift of one point: the first term that is not 0 decides.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept::overlap {

using Whole = std::array<std::int64_t, 3>;
using Wide = __int128;

/// The mesh that is shrunk where that decides, and the other one.
enum class Side { Shrunk, Fixed };
constexpr Side other(Side side) { return side == Side::Shrunk ? Side::Fixed : Side::Shrunk; }

class Lattice {
 public:
  Lattice(const TriMesh& shrunk, const TriMesh& fixed);

  const Whole& at(Side side, std::int32_t vertex) const { return points_[int(side)][vertex]; }
  std::size_t count(Side side) const { return points_[int(side)].size(); }
  /// Steps as doubles, exact: for boxes.
  Eigen::Vector3d place(Side side, std::int32_t vertex) const;
  double millimetres() const { return step_; }

  using Corners = std::array<std::int32_t, 3>;

  /// On which side of a triangle of the other mesh does a vertex lie? 1: where the normal points.
  int sideOf(Side side, std::int32_t vertex, const Corners& triangle) const;
  /// Signed height of the vertex above the plane of the triangle, times twice the area of the
  /// triangle. Rounded, and without the symbolic shift.
  long double heightOf(Side side, std::int32_t vertex, const Corners& triangle) const;
  /// Sign of det(a1 - a0, b0 - a0, b1 - a0): a of the shrunk mesh, b of the fixed one. 0 only where
  /// the two are parallel.
  int turnOf(std::int32_t a0, std::int32_t a1, std::int32_t b0, std::int32_t b1) const;
  /// What a line from a vertex towards +z meets in a triangle of the other mesh: 1 if it leaves the
  /// solid there, -1 if it enters it, 0 if it passes by.
  int rayThrough(Side side, std::int32_t vertex, const Corners& triangle) const;

 private:
  Whole fromCentre(const Whole& p) const;
  int turnInPlane(Side side, const Whole& p, const Whole& a, const Whole& b) const;

  std::array<std::vector<Whole>, 2> points_;
  Whole centre_{};
  double step_ = 1;
};

}  // namespace swept::overlap
