// Vertices and faces with any number of corners, in file order.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace swept {

struct PolygonList {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::int32_t> corners;        ///< corners of all faces, face after face
  std::vector<std::uint64_t> faceStart{0};  ///< face f has corners [faceStart[f], faceStart[f + 1])

  std::size_t faces() const { return faceStart.size() - 1; }
};

}  // namespace swept
