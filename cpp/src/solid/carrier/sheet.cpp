// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Fraction of the range by which the surface is continued beyond its borders.
constexpr double kBeyond = 0.05;
/// Number of samples along the longer direction. Along the other direction, samples have about the
/// same spacing, but there are at least kMinSamples.
constexpr int kSamples = 40, kMinSamples = 6;
constexpr int kRounds = 40;

std::vector<double> evenly(Range range, int count) {
  std::vector<double> at;
  for (int i = 0; i <= count; ++i) at.push_back(range.at(static_cast<double>(i) / count));
  return at;
}

}  // namespace

Sheet::Sheet(Knots u, Knots t, std::vector<Vector3d> poles)
    : u_(std::move(u)),
      t_(std::move(t)),
      poles_(std::move(poles)),
      extendedU_(u_.range().grown(kBeyond)),
      extendedT_(t_.range().grown(kBeyond)) {
  double longU = 0, longT = 0;
  const auto rows = u_.poleCount(), columns = t_.poleCount();
  for (std::size_t j = 0; j < columns; ++j) {
    double sum = 0;
    for (std::size_t i = 1; i < rows; ++i) sum += (pole(i, j) - pole(i - 1, j)).norm();
    longU = std::max(longU, sum);
  }
  for (std::size_t i = 0; i < rows; ++i) {
    double sum = 0;
    for (std::size_t j = 1; j < columns; ++j) sum += (pole(i, j) - pole(i, j - 1)).norm();
    longT = std::max(longT, sum);
  }
  spacing_ = std::max(longU, longT) / kSamples;
  const auto count = [&](double length) {
    return std::max(kMinSamples, static_cast<int>(length / std::max(spacing_, 1e-300)));
  };
  sampleU_ = evenly(u_.range(), count(longU));
  sampleT_ = evenly(t_.range(), count(longT));
  for (const double a : sampleU_) {
    for (const double b : sampleT_) samples_.push_back(at(a, b));
  }
}

Vector3d Sheet::at(double u, double t) const {
  const Knots::Basis basisU = u_.basis(u), basisT = t_.basis(t);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i <= u_.degree(); ++i) {
    Vector3d row = Vector3d::Zero();
    for (int j = 0; j <= t_.degree(); ++j)
      row += basisT.value[0][j] * pole(basisU.first + i, basisT.first + j);
    sum += basisU.value[0][i] * row;
  }
  return sum;
}

Sheet::Jet Sheet::jet(double u, double t) const {
  const Knots::Basis basisU = u_.basis(u), basisT = t_.basis(t);
  Jet jet;
  jet.at = jet.u = jet.t = jet.uu = jet.ut = jet.tt = Vector3d::Zero();
  for (int i = 0; i <= u_.degree(); ++i) {
    Vector3d row = Vector3d::Zero(), rowT = Vector3d::Zero(), rowTt = Vector3d::Zero();
    for (int j = 0; j <= t_.degree(); ++j) {
      const Vector3d& p = pole(basisU.first + i, basisT.first + j);
      row += basisT.value[0][j] * p;
      rowT += basisT.value[1][j] * p;
      rowTt += basisT.value[2][j] * p;
    }
    jet.at += basisU.value[0][i] * row;
    jet.u += basisU.value[1][i] * row;
    jet.uu += basisU.value[2][i] * row;
    jet.t += basisU.value[0][i] * rowT;
    jet.ut += basisU.value[1][i] * rowT;
    jet.tt += basisU.value[0][i] * rowTt;
  }
  return jet;
}

Sheet::Foot Sheet::footAt(double u, double t) const {
  const Jet j = jet(u, t);
  return {u, t, j.at, j.u, j.t, true};
}

Sheet::Foot Sheet::foot(const Vector3d& p) const {
  const auto columns = static_cast<std::ptrdiff_t>(sampleT_.size());
  const auto nearest = [&](std::ptrdiff_t apartFrom) {
    std::ptrdiff_t best = -1;
    double smallest = 1e300;
    for (std::ptrdiff_t i = 0; i < std::ssize(samples_); ++i) {
      const double d = (samples_[i] - p).squaredNorm();
      if (d >= smallest) continue;
      if (apartFrom >= 0 && std::abs(i / columns - apartFrom / columns) < 4 &&
          std::abs(i % columns - apartFrom % columns) < 4)
        continue;
      smallest = d;
      best = i;
    }
    return best;
  };
  const auto from = [&](std::ptrdiff_t i) {
    return foot(p, sampleU_[i / columns], sampleT_[i % columns]);
  };
  const std::ptrdiff_t first = nearest(-1);
  const Foot found = from(first);
  if (found.isInside && (found.at - p).norm() < 0.01 * spacing_) return found;
  // Another part of the surface may be nearer, although its samples are not.
  const std::ptrdiff_t second = nearest(first);
  if (second < 0) return found;
  const Foot other = from(second);
  return (other.at - p).norm() < (found.at - p).norm() ? other : found;
}

namespace {

// Returns whether the parameter x is at an end of its range and the step would leave the range.
bool isBlocked(const Range& range, double x, double step) {
  return (x <= range.from && step < 0) || (x >= range.to && step > 0);
}

// Returns the largest fraction of a step, at most 1, that stays in the range.
double fractionInRange(const Range& range, double x, double step) {
  if (step == 0) return 1;
  return std::min(1.0, ((step > 0 ? range.to : range.from) - x) / step);
}

}  // namespace

// Minimises the squared distance within the box of parameters. A step that does not reduce the
// distance is halved. Second derivatives that would lead to a saddle point are ignored.
Sheet::Foot Sheet::foot(const Vector3d& p, double u, double t) const {
  u = std::clamp(u, extendedU_.from, extendedU_.to);
  t = std::clamp(t, extendedT_.from, extendedT_.to);
  Jet j = jet(u, t);
  double distance = (j.at - p).norm();
  bool isAtEnd = false;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d d = j.at - p;
    const double gu = d.dot(j.u), gt = d.dot(j.t);
    const double e = j.u.squaredNorm(), f = j.u.dot(j.t), g = j.t.squaredNorm();
    double a = e + d.dot(j.uu), b = f + d.dot(j.ut), c = g + d.dot(j.tt);
    if (!(a > 0.05 * e && c > 0.05 * g && a * c - b * b > 0.05 * (e * g - f * f))) {
      a = e;
      b = f;
      c = g;
    }
    const double det = std::max(a * c - b * b, 1e-12 * a * c);
    double du = -(c * gu - b * gt) / det, dt = -(a * gt - b * gu) / det;
    // A parameter that would leave its range keeps its value, and the step of the other is computed
    // alone.
    const bool fixU = isBlocked(extendedU_, u, du) || isBlocked(extendedU_, u, -gu);
    if (fixU) {
      du = 0;
      dt = -gt / c;
    }
    const bool fixT = isBlocked(extendedT_, t, dt) || isBlocked(extendedT_, t, -gt);
    if (fixT) {
      dt = 0;
      du = fixU || isBlocked(extendedU_, u, -gu) ? 0 : -gu / a;
    }
    isAtEnd = fixU || fixT;
    double w = std::min(fractionInRange(extendedU_, u, du), fractionInRange(extendedT_, t, dt));
    if (du == 0 && dt == 0) break;
    const double slack = 1e-15 * (distance + p.norm());
    const double least = 1e-6 * w;
    Jet next = jet(u + w * du, t + w * dt);
    while ((next.at - p).norm() > distance + slack && w > least) {
      w /= 2;
      next = jet(u + w * du, t + w * dt);
    }
    if (w <= least) break;
    u = std::clamp(u + w * du, extendedU_.from, extendedU_.to);
    t = std::clamp(t + w * dt, extendedT_.from, extendedT_.to);
    j = next;
    distance = (j.at - p).norm();
    if (w * (std::abs(du) * std::sqrt(e) + std::abs(dt) * std::sqrt(g)) < 1e-12) break;
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
