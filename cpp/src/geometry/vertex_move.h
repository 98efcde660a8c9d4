// A vertex of a mesh and its new position.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace swept {

struct VertexMove {
  std::int32_t vertex = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mm
};

}  // namespace swept
