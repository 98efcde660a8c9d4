// Winding number of a closed mesh about a point, by a ray along +x.
// In:      triangles. Out: winding numbers; for a line (y, z) the crossings in rising x, each with
//          its direction. Units: any one unit of length.
// Cost:    O(n) to build, one column of triangles a line; a triangle stands in the columns that it
//          covers, not in all of its box (CAD parts have long ones). The same rays through the
//          boxes of a BoxTree take 0.75 to 6 times as long, mostly three (a machine part, a ball, a
//          torus; 32,000 to 300,000 triangles; points in the box and near the surface): hence
//          columns.
// Promise: a line through a shared edge or vertex meets a closed surface consistently (half-open
//          rule on the projected corners, each edge evaluated in one direction), also where the
//          triangles of an edge do not share vertices but only places.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/lists_by_key.h"
#include "swept/types.h"

namespace swept {

class RayColumns {
 public:
  struct Crossing {
    double x = 0;
    std::int32_t triangle = 0;
    std::int32_t direction = 0;  ///< +1: the line enters (normal towards -x), -1: it leaves
  };

  explicit RayColumns(const TriMesh& mesh);
  /// Only lines with (y, z) inside the box can be queried.
  RayColumns(const TriMesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high);
  /// How often the surface goes round x, counter-clockwise as seen from its normals' side: 1 inside
  /// a solid, 0 outside and in its cavities, -1 inside a solid turned inside out.
  int winding(const Eigen::Vector3d& x) const;
  /// Crossings of the line (any x, y, z), sorted by x, then by triangle.
  void crossings(double y, double z, std::vector<Crossing>& out) const;
  /// How many triangles stand in all columns together: memory, 4 bytes each.
  std::size_t entries() const { return triangles_.values().size(); }
  const Eigen::Vector3d& low() const { return low_; }
  const Eigen::Vector3d& high() const { return high_; }

 private:
  /// use(z, y0, y1): a triangle covers at most the columns y0 to y1 of the row z.
  template <class Use>
  void forRows(std::size_t triangle, const Use& use) const;
  void build();
  std::int64_t countPairs() const;
  std::int32_t column(double value, int axis) const;
  std::size_t cellAt(std::int32_t y, std::int32_t z) const {
    return static_cast<std::size_t>(z) * columns_ + y;
  }
  template <class Visit>
  void forCrossings(double y, double z, const Visit& visit) const;

  const TriMesh& mesh_;
  Eigen::Vector3d low_, high_;
  std::int32_t columns_ = 1;
  ListsByKey<std::int32_t> triangles_;  ///< by column
};

}  // namespace swept
