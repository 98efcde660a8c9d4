// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Share of the range by which the surface goes on beyond its borders.
constexpr double kBeyond = 0.05;
constexpr int kSamplesPerSpan = 4;
constexpr int kRounds = 40;

std::vector<double> samplesOf(const Knots& knots) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < knots.breaks().size(); ++i) {
    const Range span{knots.breaks()[i], knots.breaks()[i + 1]};
    for (int k = 0; k < kSamplesPerSpan; ++k)
      at.push_back(span.at(static_cast<double>(k) / kSamplesPerSpan));
  }
  at.push_back(knots.breaks().back());
  return at;
}

}  // namespace

Sheet::Sheet(Knots u, Knots t, std::vector<Vector3d> poles)
    : u_(std::move(u)),
      t_(std::move(t)),
      poles_(std::move(poles)),
      roomU_(u_.range().grown(kBeyond)),
      roomT_(t_.range().grown(kBeyond)) {
  sampleU_ = samplesOf(u_);
  sampleT_ = samplesOf(t_);
  for (const double a : sampleU_) {
    for (const double b : sampleT_) samples_.push_back(at(a, b));
  }
}

Vector3d Sheet::at(double u, double t) const {
  const Knots::Basis bu = u_.basis(u), bt = t_.basis(t);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i <= u_.degree(); ++i) {
    Vector3d row = Vector3d::Zero();
    for (int j = 0; j <= t_.degree(); ++j) row += bt.value[0][j] * pole(bu.first + i, bt.first + j);
    sum += bu.value[0][i] * row;
  }
  return sum;
}

Sheet::Jet Sheet::jet(double u, double t) const {
  const Knots::Basis bu = u_.basis(u), bt = t_.basis(t);
  Jet jet;
  jet.at = jet.u = jet.t = jet.uu = jet.ut = jet.tt = Vector3d::Zero();
  for (int i = 0; i <= u_.degree(); ++i) {
    Vector3d row = Vector3d::Zero(), rowT = Vector3d::Zero(), rowTt = Vector3d::Zero();
    for (int j = 0; j <= t_.degree(); ++j) {
      const Vector3d& p = pole(bu.first + i, bt.first + j);
      row += bt.value[0][j] * p;
      rowT += bt.value[1][j] * p;
      rowTt += bt.value[2][j] * p;
    }
    jet.at += bu.value[0][i] * row;
    jet.u += bu.value[1][i] * row;
    jet.uu += bu.value[2][i] * row;
    jet.t += bu.value[0][i] * rowT;
    jet.ut += bu.value[1][i] * rowT;
    jet.tt += bu.value[0][i] * rowTt;
  }
  return jet;
}

Sheet::Foot Sheet::footAt(double u, double t) const {
  const Jet j = jet(u, t);
  return {u, t, j.at, j.u, j.t, true};
}

Sheet::Foot Sheet::foot(const Vector3d& p) const {
  std::size_t best = 0;
  double smallest = 1e300;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double d = (samples_[i] - p).squaredNorm();
    if (d >= smallest) continue;
    smallest = d;
    best = i;
  }
  return foot(p, sampleU_[best / sampleT_.size()], sampleT_[best % sampleT_.size()]);
}

// Minimises the squared distance within the box of parameters. A step that does not shorten the
// distance is halved; where the second derivatives would lead to a saddle, they are left out.
Sheet::Foot Sheet::foot(const Vector3d& p, double u, double t) const {
  u = std::clamp(u, roomU_.from, roomU_.to);
  t = std::clamp(t, roomT_.from, roomT_.to);
  Jet j = jet(u, t);
  double distance = (j.at - p).norm();
  bool isAtEnd = false;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d d = j.at - p;
    const double gu = d.dot(j.u), gt = d.dot(j.t);
    const double e = j.u.squaredNorm(), f = j.u.dot(j.t), g = j.t.squaredNorm();
    double a = e + d.dot(j.uu), b = f + d.dot(j.ut), c = g + d.dot(j.tt);
    if (!(a > 0.05 * e && c > 0.05 * g && a * c - b * b > 0.05 * e * g * (1 - f * f / (e * g)))) {
      a = e;
      b = f;
      c = g;
    }
    // A parameter at an end stays there if the distance would fall beyond it.
    const bool fixU = (u <= roomU_.from && gu > 0) || (u >= roomU_.to && gu < 0);
    const bool fixT = (t <= roomT_.from && gt > 0) || (t >= roomT_.to && gt < 0);
    isAtEnd = fixU || fixT;
    double du = 0, dt = 0;
    if (fixU && fixT) break;
    if (fixU) {
      dt = -gt / c;
    } else if (fixT) {
      du = -gu / a;
    } else {
      const double det = std::max(a * c - b * b, 1e-12 * a * c);
      du = -(c * gu - b * gt) / det;
      dt = -(a * gt - b * gu) / det;
    }
    double w = 1;
    const double nextU = std::clamp(u + du, roomU_.from, roomU_.to) - u;
    const double nextT = std::clamp(t + dt, roomT_.from, roomT_.to) - t;
    const double slack = 1e-15 * (distance + p.norm());
    Jet next;
    for (;; w /= 2) {
      next = jet(u + w * nextU, t + w * nextT);
      if ((next.at - p).norm() <= distance + slack || w < 1e-4) break;
    }
    const double moved = w * (std::abs(nextU) * std::sqrt(e) + std::abs(nextT) * std::sqrt(g));
    if (w < 1e-4) break;
    u += w * nextU;
    t += w * nextT;
    j = next;
    distance = (j.at - p).norm();
    if (moved < 1e-12) break;
  }
  return {u, t, j.at, j.u, j.t, !isAtEnd};
}

double Sheet::distance(const Vector3d& p) const {
  const Foot near = foot(p);
  const double along = (p - near.at).dot(near.normal());
  if (near.isInside) return along;
  return along < 0 ? -(p - near.at).norm() : (p - near.at).norm();
}

Sheet Sheet::part(Range u, Range t) const {
  const auto rows = static_cast<Eigen::Index>(u_.poleCount());
  const auto columns = static_cast<Eigen::Index>(t_.poleCount());
  // Along t first: one row of the matrix for each pole of this direction.
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
