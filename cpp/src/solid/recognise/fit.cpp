// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<Carrier> guessPlane(const Samples& samples, const PointSpread& spread) {
  Matrix3d covariance = Matrix3d::Zero();
  for (const Vector3d& p : samples.points) {
    covariance += (p - spread.mean) * (p - spread.mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(covariance);
  if (!(solver.eigenvalues()[1] > 1e-12 * solver.eigenvalues()[2])) return std::nullopt;
  Carrier surface;
  surface.kind = CarrierKind::Plane;
  surface.point = spread.mean;
  surface.axis = solver.eigenvectors().col(0).normalized();
  return surface;
}

// Solves p = centre + s n by least squares for the centre and s, where p are the points and n their
// normals. For a cylinder or a torus, points and normals must already be projected to a plane.
bool centreAlongNormals(const std::vector<Vector3d>& points, const std::vector<Vector3d>& normals,
                        Vector3d& centre, double& s) {
  const auto count = static_cast<double>(points.size());
  Vector3d meanP = Vector3d::Zero(), meanN = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    meanP += points[i] / count;
    meanN += normals[i] / count;
  }
  double nn = 0, pn = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    nn += (normals[i] - meanN).squaredNorm();
    pn += (normals[i] - meanN).dot(points[i] - meanP);
  }
  if (!(nn > 1e-9 * count)) return false;
  s = pn / nn;
  centre = meanP - s * meanN;
  return true;
}

std::optional<Carrier> guessSphere(const Samples& samples) {
  Carrier surface;
  surface.kind = CarrierKind::Sphere;
  double s = 0;
  if (!centreAlongNormals(samples.points, samples.normals, surface.point, s)) return std::nullopt;
  surface.radius = std::abs(s);
  return surface;
}

std::optional<Carrier> guessCylinder(const Samples& samples, const PointSpread& spread) {
  Matrix3d moments = Matrix3d::Zero();
  for (const Vector3d& n : samples.normals) moments += n * n.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(moments);
  Carrier surface;
  surface.kind = CarrierKind::Cylinder;
  surface.axis = solver.eigenvectors().col(0).normalized();
  std::vector<Vector3d> points, normals;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector3d d = samples.points[i] - spread.mean;
    points.push_back(d - d.dot(surface.axis) * surface.axis);
    const Vector3d& n = samples.normals[i];
    normals.push_back(n - n.dot(surface.axis) * surface.axis);
  }
  double s = 0;
  if (!centreAlongNormals(points, normals, surface.point, s)) return std::nullopt;
  surface.point += spread.mean;
  surface.radius = std::abs(s);
  return surface;
}

std::optional<Carrier> guessCone(const Samples& samples, const PointSpread& spread) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& n : samples.normals) mean += n;
  mean /= static_cast<double>(samples.normals.size());
  Matrix3d covariance = Matrix3d::Zero(), planes = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t i = 0; i < samples.normals.size(); ++i) {
    const Vector3d& n = samples.normals[i];
    covariance += (n - mean) * (n - mean).transpose();
    planes += n * n.transpose();
    right += n * n.dot(samples.points[i] - spread.mean);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(covariance);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> conditioned(planes);
  if (!(conditioned.eigenvalues()[0] > 1e-6 * conditioned.eigenvalues()[2])) return std::nullopt;
  Carrier surface;
  surface.kind = CarrierKind::Cone;
  surface.axis = solver.eigenvectors().col(0).normalized();
  const Vector3d apex = spread.mean + planes.ldlt().solve(right);
  double along = (spread.mean - apex).dot(surface.axis);
  if (along < 0) {
    surface.axis = -surface.axis;
    along = -along;
  }
  surface.setHalfAngle(std::asin(std::min(1.0, std::abs(mean.dot(surface.axis)))));
  if (!(surface.halfAngle > 0.01 && surface.halfAngle < 1.5)) return std::nullopt;
  surface.point = apex + along * surface.axis;
  surface.radius = along * std::tan(surface.halfAngle);
  return surface;
}

std::optional<Carrier> guessTorus(const Samples& samples, const PointSpread& spread) {
  const NormalsAxis axis = axisOfNormals(samples, spread);
  if (!(axis.direction.norm() > 1e-3)) return std::nullopt;
  Carrier surface;
  surface.kind = CarrierKind::Torus;
  surface.axis = axis.direction.normalized();
  const Vector3d& foot = axis.point;
  // Fits the circle of the tube in profile coordinates (distance from the axis, height), from
  // points and normals.
  std::vector<Vector3d> points, normals;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector3d d = samples.points[i] - foot;
    const double along = d.dot(surface.axis);
    const Vector3d radial = (d - along * surface.axis).normalized();
    points.emplace_back((d - along * surface.axis).norm(), along, 0);
    normals.emplace_back(samples.normals[i].dot(radial), samples.normals[i].dot(surface.axis), 0);
  }
  Vector3d centre;
  double s = 0;
  if (!centreAlongNormals(points, normals, centre, s)) return std::nullopt;
  surface.point = foot + centre.y() * surface.axis;
  surface.radius = centre.x();
  surface.minor = std::abs(s);
  // Spindle tori are rejected; simpler surfaces may fit.
  if (!(surface.radius > 1.02 * surface.minor)) return std::nullopt;
  return surface;
}

bool isSane(const Carrier& s, const PointSpread& spread) {
  const double limit = 200 * spread.size;
  switch (s.kind) {
    case CarrierKind::Sphere:
    case CarrierKind::Cylinder:
      return s.radius > 1e-6 && s.radius < limit;
    case CarrierKind::Cone:
      return s.radius > 0 && s.radius < limit && std::abs(s.halfAngle) > 0.01 &&
             std::abs(s.halfAngle) < 1.5;
    case CarrierKind::Torus:
      return s.minor > 1e-6 && s.radius < limit && s.radius > 1.02 * s.minor;
    default:
      return true;
  }
}

// Returns the surface after a small change of its parameters. delta, all in mm: shifts along e1, e2
// and the axis; tilts of the axis towards e1 and e2; change of the radius; change of the minor
// radius (torus) or of the half angle (cone). Tilts and half angle are given by the displacement at
// the distance `size`.
Carrier moved(const Carrier& from, const Vector3d& e1, const Vector3d& e2, const double delta[7],
              double size) {
  Carrier s = from;
  s.point += delta[0] * e1 + delta[1] * e2 + delta[2] * from.axis;
  s.axis = (from.axis + (delta[3] * e1 + delta[4] * e2) / size).normalized();
  s.radius += delta[5];
  if (s.kind == CarrierKind::Torus) s.minor += delta[6];
  if (s.kind == CarrierKind::Cone) s.setHalfAngle(s.halfAngle + delta[6] / size);
  return s;
}

// Derivative of the distance of p with respect to the parameters of moved().
using Gradient = Eigen::Matrix<double, 7, 1>;
// One row per free parameter, at most 7, so that no heap allocation is needed.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;
Gradient gradientOf(const Carrier& s, const Vector3d& p, const Vector3d& e1, const Vector3d& e2,
                    double size) {
  const Vector3d d = p - s.point, outward = s.normal(p);
  const double along = d.dot(s.axis), side = s.reversed ? -1 : 1;
  const Vector3d radial = d - along * s.axis;
  const double rho = radial.norm();
  // Components of the normal in the plane through the axis: away from the axis, and along it.
  const double away = rho > 0 ? outward.dot(radial) / rho : 0, up = outward.dot(s.axis);
  Gradient g = Gradient::Zero();
  g[0] = -outward.dot(e1);
  g[1] = -outward.dot(e2);
  g[2] = -up;
  if (rho > 0) {
    g[3] = (up * d.dot(e1) - away * along * radial.dot(e1) / rho) / size;
    g[4] = (up * d.dot(e2) - away * along * radial.dot(e2) / rho) / size;
  }
  g[5] = -side;
  if (s.kind == CarrierKind::Torus) {
    g[5] = -away;
    g[6] = -side;
  } else if (s.kind == CarrierKind::Cone) {
    g[5] = -side * s.cosine;
    g[6] = -side * ((rho - s.radius) * s.sine + along * s.cosine) / size;
  }
  return g;
}

std::vector<int> freeParameters(CarrierKind kind) {
  switch (kind) {
    case CarrierKind::Sphere:
      return {0, 1, 2, 5};
    case CarrierKind::Cylinder:
      return {0, 1, 3, 4, 5};
    case CarrierKind::Cone:
      return {0, 1, 3, 4, 5, 6};
    case CarrierKind::Torus:
      return {0, 1, 2, 3, 4, 5, 6};
    default:
      return {2, 3, 4};
  }
}

}  // namespace

PointSpread spreadOf(const Samples& samples) {
  PointSpread spread;
  const auto count = static_cast<double>(samples.points.size());
  for (const Vector3d& p : samples.points) spread.mean += p / count;
  for (const Vector3d& p : samples.points) spread.size += (p - spread.mean).squaredNorm() / count;
  spread.size = std::sqrt(spread.size);
  return spread;
}

NormalsAxis axisOfNormals(const Samples& samples, const PointSpread& spread) {
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  Matrix6d moments = Matrix6d::Zero();
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    Eigen::Matrix<double, 6, 1> line;
    line << ((samples.points[i] - spread.mean) / spread.size).cross(samples.normals[i]),
        samples.normals[i];
    moments += line * line.transpose() / static_cast<double>(samples.points.size());
  }
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(moments);
  NormalsAxis axis{solver.eigenvectors().col(0).head<3>(), solver.eigenvectors().col(0).tail<3>(),
                   spread.mean, solver.eigenvalues()[0], solver.eigenvalues()[1]};
  axis.point += spread.size * axis.direction.cross(axis.moment) / axis.direction.squaredNorm();
  return axis;
}

void orient(const Samples& samples, Carrier& surface) {
  surface.reversed = false;
  double sum = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    sum += surface.normal(samples.points[i]).dot(samples.normals[i]);
  }
  if (surface.isPlanar()) {
    if (sum < 0) surface.axis = -surface.axis;
  } else {
    surface.reversed = sum < 0;
  }
}

std::optional<Carrier> guessSurface(CarrierKind kind, const Samples& samples) {
  if (samples.points.size() < 6) return std::nullopt;
  const PointSpread spread = spreadOf(samples);
  std::optional<Carrier> surface;
  switch (kind) {
    case CarrierKind::Sphere:
      surface = guessSphere(samples);
      break;
    case CarrierKind::Cylinder:
      surface = guessCylinder(samples, spread);
      break;
    case CarrierKind::Cone:
      surface = guessCone(samples, spread);
      break;
    case CarrierKind::Torus:
      surface = guessTorus(samples, spread);
      break;
    default:
      surface = guessPlane(samples, spread);
      break;
  }
  if (!surface || !isSane(*surface, spread)) return std::nullopt;
  orient(samples, *surface);
  return surface;
}

void refineSurface(const Samples& samples, Carrier& surface, std::size_t maxCount) {
  if (surface.hasProfile()) return;  // fit_profile.h refines these
  const PointSpread spread = spreadOf(samples);
  if (surface.isPlanar()) {
    if (auto plane = guessPlane(samples, spread)) {
      orient(samples, *plane);
      surface = *plane;
    }
    return;
  }
  const std::size_t stride = std::max<std::size_t>(1, samples.points.size() / maxCount);
  const std::vector<int> parameters = freeParameters(surface.kind);
  const auto count = static_cast<int>(parameters.size());
  auto cost = [&](const Carrier& s) {
    double sum = 0;
    for (std::size_t i = 0; i < samples.points.size(); i += stride) {
      const double d = s.distance(samples.points[i]);
      sum += d * d;
    }
    return sum;
  };
  double best = cost(surface), damping = 1e-6;
  for (int round = 0; round < 8; ++round) {
    // Moves the reference point along the axis to the samples. Otherwise a small tilt would move
    // distant parts a long way.
    if (surface.kind == CarrierKind::Cylinder || surface.kind == CarrierKind::Cone) {
      const double along = (spread.mean - surface.point).dot(surface.axis);
      surface.point += along * surface.axis;
      if (surface.kind == CarrierKind::Cone) surface.radius += along * std::tan(surface.halfAngle);
    }
    const Vector3d e1 = anyOrthogonal(surface.axis), e2 = surface.axis.cross(e1);
    SmallMatrix normal = SmallMatrix::Zero(count, count);
    SmallVector right = SmallVector::Zero(count), row(count);
    for (std::size_t i = 0; i < samples.points.size(); i += stride) {
      const Gradient all = gradientOf(surface, samples.points[i], e1, e2, spread.size);
      for (int k = 0; k < count; ++k) row[k] = all[parameters[k]];
      normal.noalias() += row * row.transpose();
      right.noalias() -= row * surface.distance(samples.points[i]);
    }
    bool better = false;
    for (int attempt = 0; attempt < 4 && !better; ++attempt) {
      SmallMatrix damped = normal;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-14 * normal.trace();
      const SmallVector solution = damped.ldlt().solve(right);
      double delta[7] = {};
      for (int k = 0; k < count; ++k) delta[parameters[k]] = solution[k];
      const Carrier next = moved(surface, e1, e2, delta, spread.size);
      const double value = isSane(next, spread) ? cost(next) : best;
      if (value < best) {
        better = value < 0.9999 * best;
        surface = next;
        best = value;
        damping *= 0.1;
        if (!better) return;
      } else {
        damping = std::max(1e-6, damping) * 30;
      }
    }
    if (!better) return;
  }
}

Residuals residuals(const Samples& samples, const Carrier& surface) {
  std::vector<double> values;
  values.reserve(samples.points.size());
  for (const Vector3d& p : samples.points) values.push_back(std::abs(surface.distance(p)));
  Residuals result;
  if (values.empty()) return result;
  result.largest = *std::max_element(values.begin(), values.end());
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  result.median = values[values.size() / 2];
  return result;
}

}  // namespace swept::step
