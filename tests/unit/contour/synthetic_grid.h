// Hermite grids made by hand, from signs of lattice points and from edges that carry two crossings.
// The geometry may be random. For tests of what depends on the configuration and not on a body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/hermite_grid.h"
#include "swept/types.h"

namespace swept::test {

/// Signs and marks of a box of lattice points; everything is outside and unmarked at first.
class SyntheticGrid {
 public:
  SyntheticGrid(std::int32_t nx, std::int32_t ny, std::int32_t nz);

  void setInside(std::int32_t i, std::int32_t j, std::int32_t k) { inside_[index(i, j, k)] = 1; }
  bool inside(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return inside_[index(i, j, k)] != 0;
  }
  /// Lets a thin wall cross the edge from (i, j, k) along `axis`, both of whose ends are outside.
  void setWall(int axis, std::int32_t i, std::int32_t j, std::int32_t k) {
    walls_[3 * index(i, j, k) + static_cast<std::size_t>(axis)] = 1;
  }
  const std::array<std::int32_t, 3>& points() const { return points_; }

  /// How crossings are placed: all in the middle with normals along their edge, or at random.
  enum class Geometry { Regular, Random };
  HermiteGrid build(Geometry geometry, std::uint64_t seed) const;

 private:
  std::size_t index(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return (static_cast<std::size_t>(i) * points_[1] + j) * points_[2] + k;
  }
  std::array<std::int32_t, 3> points_;
  std::vector<std::uint8_t> inside_, walls_;
};

/// Faults of a mesh, counted without any code of the contouring or the mesh check.
struct Faults {
  /// Undirected edges without exactly two triangles of opposite direction.
  std::int64_t openEdges = 0;
  std::int64_t nonManifoldEdges = 0;  ///< undirected edges of more than two triangles
  std::int64_t badVertices = 0;       ///< vertices whose triangles are not one closed ring
  std::int64_t degenerate = 0;        ///< triangles with a repeated vertex
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< position of the first fault
  bool any() const { return openEdges + nonManifoldEdges + badVertices + degenerate > 0; }
};
Faults findFaults(const TriMesh& mesh);

/// Returns a pseudo-random number that depends only on x.
std::uint64_t mix(std::uint64_t x);

}  // namespace swept::test
