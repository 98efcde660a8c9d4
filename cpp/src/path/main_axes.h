// The directions in which most of a surface looks: the axes of a machine part, however it is
// turned. In:    triangles. Out: a rotation whose columns are these directions. Cost: O(n). Boxes
// round triangles keep the axes of their mesh; in these axes they are thin, and questions about
// pairs of parts take a fraction of the time (docs/paths.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/types.h"

namespace swept::path {

Eigen::Matrix3d mainAxes(const std::vector<const TriMesh*>& meshes);

/// The mesh turned about the origin.
TriMesh turnedMesh(const TriMesh& mesh, const Eigen::Matrix3d& rotation);

}  // namespace swept::path
