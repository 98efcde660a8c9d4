// Reads and writes mesh and motion files. Reading throws Error(InvalidInput, "BadFile", ...), with
// line and column for text files. Writing throws Error(ExportFailed, ...). A file is first written
// beside its target and then renamed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/types.h"

namespace swept {

/// Reads PLY, STL, OBJ or OFF, also from pipes. `millimetresPerUnit` scales the numbers in the
/// file. `format` replaces the suffix if the name has none.
TriMesh readMesh(const std::string& path, double millimetresPerUnit = 1.0,
                 const std::string& format = {});
/// Throws Error(ExportFailed, "Exists") if a file, folder or link with this name exists. `role`:
/// what the caller calls the file ("--output").
void requireAbsent(const std::string& role, const std::string& path);

/// Returns the mesh as a file with this suffix stores it. For STL: single precision, with three
/// separate vertices for each triangle, rounded so that triangles with an area keep one. For other
/// formats: unchanged.
TriMesh meshAsWritten(const TriMesh& mesh, const std::string& suffix);
/// Writes PLY, STL, OBJ, OFF or 3MF.
void writeMesh(const TriMesh& mesh, const std::string& path);

/// Reads a table of poses. A row holds t,tx,ty,tz,qx,qy,qz,qw (TUM format), or 12 numbers (KITTI
/// format) or 16 numbers of a row-major matrix; t may precede the 16 numbers. A header line, also
/// in a comment, may name another order, as EuRoC files do. Columns are separated by commas,
/// semicolons, tabs or blanks. Decimal commas are allowed if another separator is used. Lines that
/// begin with # are comments. The file may be packed (.gz, .xz). Rotations that deviate by up to
/// 1e-4 from rigid ones are kept; checkTrajectory() corrects them. Larger deviations throw
/// Error(InvalidInput, "NotRigid").
Trajectory readTrajectoryCsv(const std::string& path, double millimetresPerUnit,
                             Interpolation interpolation);

/// Returns the rigid pose nearest to a row-major 4x4 matrix. `deviation` receives the largest entry
/// of |R^T R - I|. Throws Error(InvalidInput, "NotRigid") beyond 1e-4; its text names pose `index`,
/// the fault (scale, shear, mirror, last row) and its size.
Pose poseFromMatrix(const double matrix[16], double timeSeconds, std::int64_t index,
                    double* deviation = nullptr);

}  // namespace swept
