// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/exact_kinds.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "solid/sweep/central_difference.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kTests = 13;  // test points in each direction
/// Sines below this count as zero for the guess; the test points decide later.
constexpr double kTiny = 1e-7;
/// A revolution may not come nearer to its axis than this fraction of its size.
constexpr double kNearAxis = 1e-3;
/// A profile consists of cubics that meet with equal derivatives (C1). If it needs more than
/// kMaxNodes, a sheet is better, because it has fewer poles. The sheet also passes the kernel's
/// test of a shape for Boolean operations (BOPAlgo_ArgumentAnalyzer). In such profiles this test
/// finds curves off their surfaces (InvalidCurveOnSurface).
constexpr std::size_t kMinNodes = 4, kMaxNodes = 16;

// Points of the surface: for each of kTests values of u, a row of points along t.
struct Samples {
  std::vector<Vector3d> points;
  // `middle` of the patch, and S_u x S_t there as a unit vector; zero if the surface is singular
  // there
  Vector3d middle, normal;
  double size = 0;
  const Vector3d& at(int i, int j) const { return points[i * kTests + j]; }
};

Samples sampled(const ExactSurface& exact, Range u, Range t) {
  Samples samples;
  Eigen::AlignedBox3d box;
  for (int i = 0; i < kTests; ++i) {
    for (int j = 0; j < kTests; ++j) {
      samples.points.push_back(exact(u.at(i / (kTests - 1.0)), t.at(j / (kTests - 1.0))));
      box.extend(samples.points.back());
    }
  }
  constexpr int kMid = kTests / 2;
  samples.middle = samples.at(kMid, kMid);
  samples.normal = (samples.at(kMid + 1, kMid) - samples.at(kMid - 1, kMid))
                       .cross(samples.at(kMid, kMid + 1) - samples.at(kMid, kMid - 1));
  if (samples.normal.norm() > 0) samples.normal.normalize();
  samples.size = box.diagonal().norm();
  return samples;
}

// Returns whether all points lie on the carrier. Reverses the carrier if its outward side is not
// that of the samples.
bool containsAll(Carrier& carrier, const Samples& samples, double bound) {
  for (const Vector3d& p : samples.points) {
    if (!(std::abs(carrier.distance(p)) <= bound)) return false;
  }
  const Vector3d d = samples.middle - carrier.point;
  const Vector3d across = d - d.dot(carrier.axis) * carrier.axis;
  // This puts the seam of the kernel's surface opposite to the middle of the face.
  if (!carrier.isPlanar() && !carrier.hasProfile() && across.norm() > 0)
    carrier.xdir = -across.normalized();
  const bool turn = carrier.normal(samples.middle).dot(samples.normal) < 0;
  if (turn && carrier.isPlanar()) carrier.axis = -carrier.axis;
  if (turn && !carrier.isPlanar()) carrier.reversed = !carrier.reversed;
  return true;
}

Carrier ofKind(CarrierKind kind, const Vector3d& point, const Vector3d& axis) {
  Carrier carrier;
  carrier.kind = kind;
  carrier.point = point;
  carrier.axis = axis;
  return carrier;
}

Carrier planeGuess(const Samples& samples) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : samples.points) mean += p / static_cast<double>(samples.points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : samples.points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  return ofKind(CarrierKind::Plane, mean, solver.eigenvectors().col(0).normalized());
}

// Returns centre (x, y) and radius (z) of the circle through three points of a plane. Returns
// nothing if they lie on a line.
std::optional<Vector3d> circleOf(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  Eigen::Matrix2d rows;
  rows << (b - a).transpose(), (c - a).transpose();
  const double area = rows.determinant(), length = (b - a).norm() * (c - a).norm();
  if (!(std::abs(area) > kTiny * length)) return std::nullopt;
  const Vector2d right((b - a).squaredNorm() / 2, (c - a).squaredNorm() / 2);
  const Vector2d from = rows.inverse() * right;
  return Vector3d(a.x() + from.x(), a.y() + from.y(), from.norm());
}

// For surfaces that turn about the axis: their points form one curve in the coordinates (distance
// from the axis, height). Three of the points give a guess of the surface.
std::optional<Carrier> turnedGuess(const Samples& samples, const FixedAxis& axis, double bound) {
  std::vector<Vector2d> flat;
  for (const Vector3d& p : samples.points) {
    const Vector3d d = p - axis.point;
    const double height = d.dot(axis.direction);
    flat.emplace_back((d - height * axis.direction).norm(), height);
  }
  const auto along = [&](int i) { return flat[i * kTests + kTests / 2]; };
  const Vector2d a = along(0), b = along(kTests / 2), c = along(kTests - 1);
  Carrier round = ofKind(CarrierKind::Cylinder, axis.point, axis.direction);
  round.radius = b.x();
  if (containsAll(round, samples, bound)) return round;
  if (a.x() != c.x()) {
    round.kind = CarrierKind::Cone;
    const double sign = c.y() >= a.y() ? 1 : -1;
    round.setHalfAngle(std::atan2(sign * (c.x() - a.x()), sign * (c.y() - a.y())));
    round.point = axis.point + b.y() * axis.direction;
    double nearest = 1e300;
    for (const Vector2d& q : flat) nearest = std::min(nearest, q.x());
    if (std::abs(round.cosine) > kTiny && nearest > kNearAxis * samples.size &&
        containsAll(round, samples, bound))
      return round;
  }
  const auto circle = circleOf(a, b, c);
  if (!circle) return std::nullopt;
  round = ofKind(CarrierKind::Sphere, axis.point + circle->y() * axis.direction, axis.direction);
  round.radius = circle->z();
  if (containsAll(round, samples, bound)) return round;
  round.kind = CarrierKind::Torus;
  round.radius = std::abs(circle->x());
  round.minor = circle->z();
  round.tubeMid = std::atan2(b.y() - circle->y(), b.x() - circle->x());
  // A torus that intersects itself would consist of two surfaces.
  if (round.minor < round.radius && containsAll(round, samples, bound)) return round;
  return std::nullopt;
}

// Returns the profile through plane points at(v). Slopes are difference quotients of these points.
std::shared_ptr<const Profile> profileThrough(const std::function<Vector2d(double)>& at,
                                              Range range, std::size_t count) {
  std::vector<Profile::Node> nodes;
  const double h = 1e-5 * range.length();
  for (std::size_t i = 0; i <= count; ++i) {
    const double v = range.at(static_cast<double>(i) / static_cast<double>(count));
    const Vector2d slope = centralDifference([&](double off) { return at(v + off); }, h);
    nodes.push_back({at(v), slope, v});
  }
  // Scales the parameter so that it is about the length along the profile. All nodes get the same
  // factor, so that the cubics on both sides of a node have the same slope there.
  double length = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    length += (nodes[i + 1].at - nodes[i].at).norm();
  const double scale = length / range.length();
  if (!(scale > 0)) return nullptr;
  for (Profile::Node& node : nodes) {
    if (!(node.slope.norm() > kNearAxis * scale)) return nullptr;  // the profile turns back
    node.slope /= scale;
    node.knot = (node.knot - range.from) * scale;
  }
  return std::make_shared<const Profile>(std::move(nodes), false, 0.02 * length);
}

std::optional<Carrier> withProfile(Carrier carrier, const ExactCurve& generator, Range range,
                                   const Samples& samples, double bound) {
  const auto at = [&](double v) { return carrier.inProfile(generator(v)); };
  for (std::size_t count = kMinNodes; count <= kMaxNodes; count *= 2) {
    carrier.profile = profileThrough(at, range, count);
    if (!carrier.profile) return std::nullopt;
    double error = 0;
    for (std::size_t i = 0; i <= 4 * count; ++i) {
      const double v = range.at(static_cast<double>(i) / static_cast<double>(4 * count));
      error = std::max(error, std::abs(carrier.distance(generator(v))));
    }
    // The profile is accurate now. If points lie off its surface, more nodes would not help.
    if (error <= 0.5 * bound)
      return containsAll(carrier, samples, bound) ? std::optional(carrier) : std::nullopt;
  }
  return std::nullopt;
}

// Returns the common direction of the chords from the first to the last sample along u (or along
// t). Returns nothing if they are not parallel.
std::optional<Vector3d> commonDirection(const Samples& samples, bool alongU) {
  Vector3d longest = Vector3d::Zero();
  std::vector<Vector3d> chords;
  for (int i = 0; i < kTests; ++i) {
    const Vector3d chord = alongU ? samples.at(kTests - 1, i) - samples.at(0, i)
                                  : samples.at(i, kTests - 1) - samples.at(i, 0);
    chords.push_back(chord);
    if (chord.norm() > longest.norm()) longest = chord;
  }
  if (!(longest.norm() > 0)) return std::nullopt;
  for (const Vector3d& chord : chords) {
    if (!(chord.cross(longest).norm() <= kTiny * chord.norm() * longest.norm()))
      return std::nullopt;
  }
  return longest.normalized();
}

std::optional<Carrier> extrusion(const ExactSurface& exact, Range u, Range t,
                                 const Samples& samples, double bound) {
  for (const bool alongU : {true, false}) {
    const auto direction = commonDirection(samples, alongU);
    if (!direction) continue;
    Carrier carrier = ofKind(CarrierKind::Extrusion, samples.middle, *direction);
    carrier.xdir = anyOrthogonal(carrier.axis);
    const ExactCurve generator = [&](double v) {
      return alongU ? exact(u.at(0.5), v) : exact(v, t.at(0.5));
    };
    const Range range = alongU ? t : u;
    std::vector<Vector3d> flat;
    for (int i = 0; i < 4 * kTests; ++i) {
      const Vector3d d = generator(range.at(i / (4 * kTests - 1.0))) - carrier.point;
      flat.emplace_back(carrier.point + d - d.dot(carrier.axis) * carrier.axis);
    }
    if (const auto circle = circleThrough(flat, false, bound)) {
      Carrier round = ofKind(CarrierKind::Cylinder, circle->start, carrier.axis);
      round.radius = circle->radius;
      if (containsAll(round, samples, bound)) return round;
    }
    if (auto made = withProfile(carrier, generator, range, samples, bound)) return made;
  }
  return std::nullopt;
}

std::optional<Carrier> revolution(const ExactSurface& exact, Range u, Range t,
                                  const Samples& samples, const FixedAxis& axis, double bound) {
  Carrier carrier = ofKind(CarrierKind::Revolution, axis.point, axis.direction);
  // The profile lies in the half plane of xdir, opposite to the middle of the face. So the seam of
  // the kernel's surface is far from the face.
  const Vector3d d = samples.middle - axis.point;
  const Vector3d across = d - d.dot(axis.direction) * axis.direction;
  if (!(across.norm() > 0)) return std::nullopt;
  carrier.xdir = -across.normalized();
  for (const Vector3d& p : samples.points) {
    if (!((p - axis.point).cross(axis.direction).norm() > kNearAxis * samples.size))
      return std::nullopt;
  }
  // A general motion does not sweep a surface of revolution. Then the profiles at the two ends of
  // the turn differ.
  for (int i = 0; i < kTests; ++i) {
    const Vector2d a = carrier.inProfile(samples.at(i, 0)),
                   b = carrier.inProfile(samples.at(i, kTests - 1));
    if (!((a - b).norm() <= bound)) return std::nullopt;
  }
  const ExactCurve generator = [&](double v) { return exact(v, t.at(0.5)); };
  return withProfile(carrier, generator, u, samples, bound);
}

}  // namespace

std::optional<FixedAxis> fixedAxis(const StepPath& path) {
  if (path.isScrew()) return FixedAxis{path.axisPoint(), path.axis()};
  const Vector3d from = path.poseAt(0).translation, shift = path.poseAt(1).translation - from;
  const Vector3d axis = path.axis();
  if (!(path.angle() > 0) || shift.cross(axis).norm() > kTiny * shift.norm()) return std::nullopt;
  return FixedAxis{from, axis};
}

std::optional<Carrier> exactKind(const ExactSurface& exact, Range u, Range t, const StepPath& path,
                                 double bound) {
  const Samples samples = sampled(exact, u, t);
  for (const Vector3d& p : samples.points) {
    if (!p.allFinite()) return std::nullopt;
  }
  Carrier plane = planeGuess(samples);
  if (containsAll(plane, samples, bound)) return plane;
  const auto axis = fixedAxis(path);
  if (axis) {
    if (auto made = turnedGuess(samples, *axis, bound)) return made;
  }
  if (auto made = extrusion(exact, u, t, samples, bound)) return made;
  return axis ? revolution(exact, u, t, samples, *axis, bound) : std::nullopt;
}

}  // namespace swept::step
