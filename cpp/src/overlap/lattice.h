// Rounds the vertices of two meshes to one lattice of integers. In the exact tests on this lattice,
// a vertex never lies on a triangle of the other mesh, and an edge never on an edge of it.
// In:    the vertices of both meshes, mm. Out: signs of orientations, exact. They are never 0,
//        except for triangles without area.
// Units: steps of the lattice: 2^-38 of the longest side of the common box of both meshes, rounded
// up to a power of two (mm).
// Cost:  a few nanoseconds per sign: products of three differences fit into 128 bits.
// Method: ties are decided as if the first mesh were shrunk a little about the centre of its box
// and then shifted even less: x -> x - e (x - centre) + (e^2, e^3, e^4), e -> 0 (simulation of
// simplicity; Edelsbrunner and Muecke 1990). So parts that only touch are separated, and of two
// faces that coincide, the face of the shrunk mesh lies inside. All signs below are linear in the
// displacement of one point, so the first term that is not 0 decides.
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

/// The mesh that is shrunk to decide ties, and the other mesh.
enum class Side { Shrunk, Fixed };
constexpr Side other(Side side) { return side == Side::Shrunk ? Side::Fixed : Side::Shrunk; }

class Lattice {
 public:
  Lattice(const TriMesh& shrunk, const TriMesh& fixed);

  const Whole& at(Side side, std::int32_t vertex) const { return points_[int(side)][vertex]; }
  std::size_t count(Side side) const { return points_[int(side)].size(); }
  /// Returns the position of a vertex in steps of the lattice, converted to double without
  /// rounding.
  Eigen::Vector3d position(Side side, std::int32_t vertex) const;
  double millimetres() const { return step_; }

  using Corners = std::array<std::int32_t, 3>;

  /// Returns on which side of a triangle of the other mesh a vertex lies: 1 on the side to which
  /// the normal points, -1 on the other side, 0 only for a triangle without area.
  int sideOf(Side side, std::int32_t vertex, const Corners& triangle) const;
  /// Returns the signed height of the vertex above the plane of the triangle, times twice the area
  /// of the triangle. The value is rounded, and ignores the symbolic displacement.
  double heightOf(Side side, std::int32_t vertex, const Corners& triangle) const;
  /// Returns the sign of det(a1 - a0, b0 - a0, b1 - a0). The vertices a0 and a1 belong to the
  /// shrunk mesh, b0 and b1 to the fixed mesh. The sign is 0 only if the two edges are parallel.
  int turnOf(std::int32_t a0, std::int32_t a1, std::int32_t b0, std::int32_t b1) const;
  /// Returns how a ray from a vertex towards +z crosses a triangle of the other mesh: 1 if the ray
  /// leaves the solid there, -1 if it enters the solid, 0 if it does not meet the triangle.
  int rayThrough(Side side, std::int32_t vertex, const Corners& triangle) const;

 private:
  Whole fromCentre(const Whole& p) const;
  int turnInPlane(Side side, const Whole& p, const Whole& a, const Whole& b) const;

  std::array<std::vector<Whole>, 2> points_;
  Whole centre_{};
  double step_ = 1;
};

}  // namespace swept::overlap
