// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/curve.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

#include "solid/carrier/bspline.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Cosine of 11 degrees. If the normals of two surfaces differ by less, they do not determine the
// position of the point across the line of contact.
constexpr double kTouchingCosine = 0.98;

double lengthScale(const Carrier& s) {
  switch (s.kind) {
    case CarrierKind::Torus:
      return s.minor;
    case CarrierKind::Cylinder:
    case CarrierKind::Sphere:
    case CarrierKind::Cone:
      return s.radius;
    case CarrierKind::Extrusion:
    case CarrierKind::Revolution:
      return s.profile->length() / (2 * M_PI);
    default:
      return 1e300;
  }
}

Eigen::VectorXd equations(const Vector3d& p, const std::vector<const Carrier*>& surfaces,
                          const std::vector<std::pair<int, int>>& touching) {
  Eigen::VectorXd value(surfaces.size() + 3 * touching.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) value[i] = surfaces[i]->distance(p);
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const Carrier& a = *surfaces[touching[k].first];
    const Carrier& b = *surfaces[touching[k].second];
    // These rows have less weight than the distances, because they only determine the direction
    // that the distances do not determine.
    const double scale = 0.1 * std::min(lengthScale(a), lengthScale(b));
    value.segment<3>(surfaces.size() + 3 * k) = scale * (a.normal(p) - b.normal(p));
  }
  return value;
}

}  // namespace

std::optional<Curve> circleThrough(const std::vector<Vector3d>& points, bool closed, double eps) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Vector3d normal = solver.eigenvectors().col(0).normalized();
  const Vector3d x = anyOrthogonal(normal), y = normal.cross(x);
  // The circle as an equation linear in a, b, c: x^2 + y^2 = 2 a x + 2 b y + c.
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  const double scale = std::sqrt(solver.eigenvalues().sum() / static_cast<double>(points.size()));
  if (!(scale > 0)) return std::nullopt;
  for (const Vector3d& p : points) {
    const double u = (p - mean).dot(x) / scale, v = (p - mean).dot(y) / scale;
    const Vector3d row(2 * u, 2 * v, 1);
    moments += row * row.transpose();
    right += row * (u * u + v * v);
  }
  const Vector3d solution = moments.ldlt().solve(right);
  const double radius2 = solution[2] + solution[0] * solution[0] + solution[1] * solution[1];
  if (!(radius2 > 0) || !solution.allFinite()) return std::nullopt;
  Curve curve;
  curve.kind = CurveKind::Circle;
  curve.radius = scale * std::sqrt(radius2);
  curve.start = mean + scale * (solution[0] * x + solution[1] * y);
  double turned = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d d = points[i] - curve.start;
    const double height = d.dot(normal);
    if (std::hypot(height, (d - height * normal).norm() - curve.radius) > eps) return std::nullopt;
    if (i == 0) continue;
    const Vector3d before = points[i - 1] - curve.start;
    turned += std::atan2(before.cross(d).dot(normal), before.dot(d));
  }
  const Vector3d first = points.front() - curve.start, end = points.back() - curve.start;
  curve.axis = turned >= 0 ? normal : Vector3d(-normal);
  curve.xdir = (first - first.dot(normal) * normal).normalized();
  if (closed) {
    curve.last = 2 * M_PI;
  } else {
    curve.last = std::atan2(curve.xdir.cross(end).dot(curve.axis), curve.xdir.dot(end));
    if (curve.last <= 0) curve.last += 2 * M_PI;
    // Points that turn back or go around more than once do not form an arc.
    if (std::abs(curve.last - std::abs(turned)) > 0.5) return std::nullopt;
  }
  return curve;
}

Curve splineAlong(const std::vector<Vector3d>& points, const std::vector<Vector3d>& tangents) {
  Curve curve;
  curve.kind = CurveKind::Spline;
  curve.last = 1;
  curve.knots.push_back(0);
  curve.poles.push_back(points.front());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = (points[i + 1] - points[i]).norm();
    curve.knots.push_back(curve.knots.back() + length);
    curve.poles.push_back(points[i] + length / 3 * tangents[i]);
    curve.poles.push_back(points[i + 1] - length / 3 * tangents[i + 1]);
  }
  curve.poles.push_back(points.back());
  const double total = curve.knots.back();
  for (double& k : curve.knots) k /= total;
  return curve;
}

namespace {

// Drops points that turn back or are too close to the previous one. Both ends stay.
std::vector<Vector3d> inOrder(const std::vector<Vector3d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  const double spacing = std::max(length / 60, 1.5 * length / static_cast<double>(points.size()));
  std::vector<Vector3d> result{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vector3d step = points[i] - result.back();
    if (step.norm() < spacing || (points.back() - points[i]).norm() < 0.7 * spacing) continue;
    if (result.size() > 1) {
      const Vector3d before = result.back() - result[result.size() - 2];
      if (before.dot(step) < 0.5 * before.norm() * step.norm()) continue;
    }
    result.push_back(points[i]);
  }
  result.push_back(points.back());
  return result;
}

Curve splineThrough(const std::vector<Vector3d>& points, bool closed,
                    const std::vector<const Carrier*>& surfaces) {
  const std::size_t count = points.size();
  std::vector<Vector3d> tangent(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d before = i > 0    ? Vector3d(points[i] - points[i - 1])
                            : closed ? Vector3d(points[0] - points[count - 2])
                                     : Vector3d::Zero();
    const Vector3d after = i + 1 < count ? Vector3d(points[i + 1] - points[i])
                           : closed      ? Vector3d(points[1] - points[0])
                                         : Vector3d::Zero();
    const double lb = before.norm(), la = after.norm();
    Vector3d chord = lb == 0   ? Vector3d(after / la)
                     : la == 0 ? Vector3d(before / lb)
                               : Vector3d((after / la * lb + before / lb * la).normalized());
    if (surfaces.size() >= 2) {
      const Vector3d a = surfaces[0]->normal(points[i]), b = surfaces[1]->normal(points[i]);
      const Vector3d cross = a.cross(b);
      if (std::abs(a.dot(b)) < kTouchingCosine && std::abs(cross.normalized().dot(chord)) > 0.7) {
        chord = cross.dot(chord) > 0 ? Vector3d(cross.normalized()) : Vector3d(-cross.normalized());
      }
    }
    tangent[i] = chord;
  }
  return splineAlong(points, tangent);
}

}  // namespace

Vector3d Curve::at(double t) const {
  if (kind == CurveKind::Line) return start + t * axis;
  if (kind == CurveKind::Circle) {
    return start + radius * (std::cos(t) * xdir + std::sin(t) * axis.cross(xdir));
  }
  if (degree != 3 || joints != 2) {
    const Knots::Basis basis = Knots(degree, knots, joints).basis(t);
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k <= degree; ++k) sum += basis.value[k] * poles[basis.first + k];
    return sum;
  }
  std::size_t i = 0;
  while (i + 2 < knots.size() && knots[i + 1] < t) ++i;
  // Bezier points of span i. The curve point at an inner knot lies between the two poles next to
  // it, in the ratio of the knot spacings.
  auto joint = [&](std::size_t k) -> Vector3d {
    if (k == 0) return poles.front();
    if (k + 1 == knots.size()) return poles.back();
    const double left = knots[k] - knots[k - 1], right = knots[k + 1] - knots[k];
    return (right * poles[2 * k] + left * poles[2 * k + 1]) / (left + right);
  };
  const double w = (t - knots[i]) / (knots[i + 1] - knots[i]), m = 1 - w;
  return m * m * m * joint(i) + 3 * m * m * w * poles[2 * i + 1] +
         3 * m * w * w * poles[2 * i + 2] + w * w * w * joint(i + 1);
}

Curve partOf(const Curve& curve, double from, double to) {
  if (curve.kind == CurveKind::Line) return lineThrough(curve.at(from), curve.at(to));
  Curve part = curve;
  part.last = to - from;
  if (curve.kind == CurveKind::Circle) {
    part.xdir = (curve.at(from) - curve.start).normalized();
    return part;
  }
  Eigen::MatrixXd poles(curve.poles.size(), 3);
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    poles.row(static_cast<Eigen::Index>(i)) = curve.poles[i].transpose();
  Knots knots;
  poles = partOf(Knots(curve.degree, curve.knots, curve.joints), poles, {from, to}, knots);
  part.knots = knots.breaks();
  for (double& knot : part.knots) knot -= from;
  part.poles.clear();
  for (Eigen::Index i = 0; i < poles.rows(); ++i) part.poles.emplace_back(poles.row(i).transpose());
  return part;
}

Curve lineThrough(const Vector3d& a, const Vector3d& b) {
  Curve curve;
  curve.start = a;
  curve.last = (b - a).norm();
  if (curve.last > 0) curve.axis = (b - a) / curve.last;
  return curve;
}

Curve profileOf(const Carrier& surface) {
  const Vector3d& x = surface.xdir;
  const Vector3d y =
      surface.kind == CarrierKind::Extrusion ? surface.axis.cross(x) : Vector3d(surface.axis);
  const std::vector<Profile::Node>& nodes = surface.profile->nodes();
  const double from = nodes.front().knot;
  const auto inSpace = [&](const Eigen::Vector2d& q) {
    return Vector3d(surface.point + q.x() * x + q.y() * y);
  };
  Curve curve;
  curve.kind = CurveKind::Spline;
  curve.last = surface.profile->length();
  curve.poles.push_back(inSpace(nodes.front().at));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    curve.knots.push_back(nodes[i].knot - from);
    if (i + 1 == nodes.size()) break;
    const double third = (nodes[i + 1].knot - nodes[i].knot) / 3;
    curve.poles.push_back(inSpace(nodes[i].at + third * nodes[i].slope));
    curve.poles.push_back(inSpace(nodes[i + 1].at - third * nodes[i + 1].slope));
  }
  curve.poles.push_back(inSpace(nodes.back().at));
  return curve;
}

Curve curveThrough(std::vector<Vector3d> points, bool closed, double eps,
                   const std::vector<const Carrier*>& surfaces) {
  if (!closed) {
    const Curve line = lineThrough(points.front(), points.back());
    double worst = 0;
    for (const Vector3d& p : points) {
      const Vector3d d = p - line.start;
      const double t = std::clamp(d.dot(line.axis), 0.0, line.last);
      worst = std::max(worst, (d - t * line.axis).norm());
    }
    if (worst <= eps) return line;
  }
  if (points.size() >= 4) {
    if (auto circle = circleThrough(points, closed, eps)) return *circle;
  }
  return splineThrough(inOrder(points), closed, surfaces);
}

std::size_t farthestPoint(const std::vector<Vector3d>& points, std::size_t from, std::size_t to,
                          double& distance) {
  const Vector3d a = points[from], ab = points[to] - a;
  const double length2 = ab.squaredNorm();
  std::size_t best = from;
  distance = -1;
  for (std::size_t i = from + 1; i < to; ++i) {
    const Vector3d d = points[i] - a;
    const double t = length2 > 0 ? std::clamp(d.dot(ab) / length2, 0.0, 1.0) : 0.0;
    const double here = (d - t * ab).norm();
    if (here <= distance) continue;
    distance = here;
    best = i;
  }
  return best;
}

void keepBends(const std::vector<Vector3d>& points,
               std::vector<std::pair<std::size_t, std::size_t>> spans, double tolerance,
               std::vector<char>& kept) {
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double distance = 0;
    const std::size_t split = farthestPoint(points, from, to, distance);
    if (distance <= tolerance) continue;
    kept[split] = 1;
    spans.emplace_back(from, split);
    spans.emplace_back(split, to);
  }
}

Curve curveAlong(const std::vector<Vector3d>& points, bool closed, double tolerance) {
  // Makes the spline pass through corners that it would otherwise round by more than the tolerance.
  std::vector<char> kept(points.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, points.size() - 1}};
  if (closed) {
    const std::size_t third = points.size() / 3;
    spans = {{0, third}, {third, 2 * third}, {2 * third, points.size() - 1}};
    kept[third] = kept[2 * third] = 1;
  }
  keepBends(points, std::move(spans), tolerance, kept);
  std::vector<Vector3d> left;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) left.push_back(points[i]);
  }
  if (left.size() == 2) return lineThrough(left[0], left[1]);
  return splineThrough(left, closed, {});
}

Vector3d meetingPoint(const Vector3d& from, const std::vector<const Carrier*>& surfaces) {
  Vector3d point = from;
  std::vector<std::pair<int, int>> touching;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = i + 1; j < surfaces.size(); ++j) {
      if (surfaces[i]->isPlanar() && surfaces[j]->isPlanar()) continue;
      if (surfaces[i]->normal(from).dot(surfaces[j]->normal(from)) > kTouchingCosine) {
        touching.emplace_back(i, j);
      }
    }
  }
  for (int round = 0; round < 12; ++round) {
    const Eigen::VectorXd value = equations(point, surfaces, touching);
    Eigen::MatrixXd jacobian(value.size(), 3);
    constexpr double kStep = 1e-5;
    for (int k = 0; k < 3; ++k) {
      const Vector3d h = kStep * Vector3d::Unit(k);
      jacobian.col(k) =
          (equations(point + h, surfaces, touching) - equations(point - h, surfaces, touching)) /
          (2 * kStep);
    }
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(touching.empty() ? 0.03 : 0.01);
    const Vector3d step = svd.solve(value);
    point -= step;
    if (step.norm() < 1e-12) break;
  }
  return point;
}

}  // namespace swept::step
