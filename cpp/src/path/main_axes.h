// Finds the directions in which most of a surface faces. These are the axes of a machine part,
// whatever its orientation is.
// In:      triangles.
// Out:     a rotation matrix whose columns are these directions.
// Cost:    O(n) for n triangles.
// Why:     Boxes around triangles are aligned with the axes of their mesh. If these are the main
// axes, most boxes are thin, and queries about pairs of parts take a fraction of the time
// (docs/paths.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/types.h"

namespace swept::path {

Eigen::Matrix3d mainAxes(const std::vector<const TriMesh*>& meshes);

/// Returns the mesh rotated about the origin.
TriMesh turnedMesh(const TriMesh& mesh, const Eigen::Matrix3d& rotation);

}  // namespace swept::path
