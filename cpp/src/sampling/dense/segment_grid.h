// Which triangles of the body a short segment intersects. The triangles are sorted into cubes, the
// cubes into a hash table. Cost: O(triangles) to build, a few cubes per segment of about a cube's
// length.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept::dense {

class SegmentGrid {
 public:
  /// minSize: mm, smallest edge of the cubes.
  SegmentGrid(const TriMesh& body, double minSize);
  /// The triangles that the segment intersects (borders included), sorted.
  void hits(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            std::vector<std::uint32_t>& out) const;

 private:
  struct Entry {
    std::uint64_t cube;
    std::uint32_t triangle;
  };
  template <class Use>
  void forCubes(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const Use& use) const;
  bool meets(std::uint32_t triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  const TriMesh& body_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  double size_ = 1;
  std::vector<Entry> entries_;  // sorted by cube, then triangle
};

}  // namespace swept::dense
