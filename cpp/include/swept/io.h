// Mesh and motion files. Throws Error(InvalidInput, "BadFile", ...) with line and column for text,
// Error(ExportFailed, ...) when writing fails; files are written beside the target, then renamed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/types.h"

namespace swept {

/// PLY, STL, OBJ, OFF; pipes as well. `millimetresPerUnit` scales the numbers in the file; `format`
/// stands for the suffix where the name has none.
TriMesh readMesh(const std::string& path, double millimetresPerUnit = 1.0,
                 const std::string& format = {});
/// Throws Error(ExportFailed, "Exists") if there is such a file, folder or link. `role`: what it is
/// to the caller ("--output").
void requireAbsent(const std::string& role, const std::string& path);

/// The mesh as a file of that suffix holds it: single precision in STL, with all vertices apart and
/// all triangles that have area keeping it; unchanged in the other formats.
TriMesh meshAsWritten(const TriMesh& mesh, const std::string& suffix);
/// The same formats, and 3MF.
void writeMesh(const TriMesh& mesh, const std::string& path);

/// Table `t,tx,ty,tz,qx,qy,qz,qw` (TUM; a header, also in a comment, says another order, as in
/// EuRoC's files), or 12 (KITTI) or 16 numbers of a row-major matrix a row, the latter optionally
/// preceded by t; `.gz`/`.xz` packed as well. Separators , ; tab blanks; decimal commas where
/// something else separates; comment lines start with #. Rotations that drift up to 1e-4 from rigid
/// are kept for checkTrajectory() to mend; worse is Error(InvalidInput, "NotRigid").
Trajectory readTrajectoryCsv(const std::string& path, double millimetresPerUnit,
                             Interpolation interpolation);

/// Nearest rigid pose to a row-major 4x4 matrix; throws Error(InvalidInput, "NotRigid") naming pose
/// `index`, what is wrong (scale, shear, mirror, last row), how much, and the limit 1e-4.
/// `deviation` receives the largest entry of |R^T R - I|.
Pose poseFromMatrix(const double matrix[16], double timeSeconds, std::int64_t index,
                    double* deviation = nullptr);

}  // namespace swept
