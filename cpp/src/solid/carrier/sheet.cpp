// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/sheet.h"

namespace swept::step {

using Eigen::Vector3d;

Vector3d Sheet::at(double u, double t) const {
  const Knots::Basis basisU = u_.basis(u), basisT = t_.basis(t);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i <= u_.degree(); ++i) {
    Vector3d row = Vector3d::Zero();
    for (int j = 0; j <= t_.degree(); ++j)
      row += basisT.value[j] * pole(basisU.first + i, basisT.first + j);
    sum += basisU.value[i] * row;
  }
  return sum;
}

Sheet Sheet::part(Range u, Range t) const {
  const auto rows = static_cast<Eigen::Index>(u_.poleCount());
  const auto columns = static_cast<Eigen::Index>(t_.poleCount());
  // First takes the part along t: each row of the matrix has the poles of all u with one index
  // along t.
  Eigen::MatrixXd byT(columns, 3 * rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) byT.block<1, 3>(j, 3 * i) = pole(i, j).transpose();
  }
  Knots partU, partT;
  byT = partOf(t_, byT, t, partT);
  Eigen::MatrixXd byU(rows, 3 * byT.rows());
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < byT.rows(); ++j)
      byU.block<1, 3>(i, 3 * j) = byT.block<1, 3>(j, 3 * i);
  }
  byU = partOf(u_, byU, u, partU);
  std::vector<Vector3d> poles;
  for (Eigen::Index i = 0; i < byU.rows(); ++i) {
    for (Eigen::Index j = 0; j < byT.rows(); ++j)
      poles.push_back(byU.block<1, 3>(i, 3 * j).transpose());
  }
  return {partU, partT, std::move(poles)};
}

}  // namespace swept::step
