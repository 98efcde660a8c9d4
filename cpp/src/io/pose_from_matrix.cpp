// Converts a row-major 4x4 matrix to a rigid pose. If the matrix is not rigid, the error says why.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "base/limits.h"
#include "base/number_text.h"
#include "swept/io.h"

namespace swept {
namespace {

[[noreturn]] void refuse(std::int64_t index, const std::string& text) {
  throw Error(Status::InvalidInput, "NotRigid", textOf(6, "pose ", index + 1, ": ", text));
}

[[noreturn]] void notRigid(std::int64_t index, const std::string& what) {
  refuse(index, what + "; export poses that only rotate and translate");
}

// Returns a text that says why a matrix is not a rotation, and by how much. Its columns are not
// perpendicular, or do not have length 1.
std::string describe(const Eigen::Matrix3d& m) {
  const Eigen::Vector3d lengths = m.colwise().norm();
  const double spread = lengths.maxCoeff() - lengths.minCoeff();
  const Eigen::Matrix3d unit = m * lengths.cwiseInverse().asDiagonal();
  const double skew = (unit.transpose() * unit - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(lengths.minCoeff() > 0)) return "a column of the rotation in the matrix is zero";
  if (skew > kRigidLimit) {
    return textOf(4, "the matrix shears the part: its axes are not perpendicular (error ", skew,
                  ", allowed ", kRigidLimit, ")");
  }
  if (spread > kRigidLimit) {
    return textOf(4, "the matrix scales the part: its axes are stretched by ", lengths[0], ", ",
                  lengths[1], " and ", lengths[2], " (allowed difference: ", kRigidLimit, ")");
  }
  return textOf(6, "the matrix scales the part: all its axes are stretched by ", lengths.mean(),
                " (allowed error: ", kRigidLimit, ")");
}

}  // namespace

Pose poseFromMatrix(const double matrix[16], double timeSeconds, std::int64_t index,
                    double* deviation) {
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> full(matrix);
  for (int i = 0; i < 16; ++i) {
    if (std::isfinite(matrix[i])) continue;
    throw Error(Status::InvalidInput, "BadPose",
                "pose " + std::to_string(index + 1) + ": matrix entry " +
                    std::to_string(i / 4 + 1) + "," + std::to_string(i % 4 + 1) +
                    " (row, column) is not a finite number; correct or remove this pose (poses are "
                    "counted from 1)");
  }
  const Eigen::RowVector4d last = full.row(3);
  if ((last - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-9) {
    const std::string what = textOf(4, "the last row of the matrix is ", last[0], " ", last[1], " ",
                                    last[2], " ", last[3], " instead of 0 0 0 1");
    const bool transposed = full.col(3).head<3>().isZero() && last[3] == 1.0;
    if (!transposed) notRigid(index, what);
    refuse(index, what + "; the matrix seems to be stored by columns: transpose it");
  }
  const Eigen::Matrix3d rotation = full.topLeftCorner<3, 3>();
  const double off =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (deviation != nullptr) *deviation = off;
  if (off > kRigidLimit) notRigid(index, describe(rotation));
  if (rotation.determinant() < 0)
    notRigid(index, "the matrix mirrors the part (its determinant is -1)");
  // Nearest rotation in the least-squares sense: the orthogonal factor of the polar decomposition.
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rotation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Pose pose;
  pose.timeSeconds = timeSeconds;
  pose.rotation = Eigen::Quaterniond(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose()));
  pose.rotation.normalize();
  pose.translation = full.topRightCorner<3, 1>();
  return pose;
}

}  // namespace swept
