// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/fit_profile.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "solid/recognise/trace_points.h"

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kMaxSpans = 64;
constexpr int kHalvings = 6;
/// More spans must reduce the sum of squared distances to at most this fraction of its previous
/// value.
constexpr double kMaxRemaining = 0.6;
constexpr double kSmoothing = 1e-7;
constexpr double kEndFraction = 0.08;  // fraction of the length: straight pieces at the ends
constexpr double kTurnPerSpan = 0.6;
constexpr int kAxisRounds = 4;

struct CurvePoint {
  double t = 0;
  Vector2d at;
};

// Returns the values of the four cubic Hermite functions at the fraction w of a span of length h.
std::array<double, 4> basis(double w, double h) {
  const double m = 1 - w;
  return {m * m * (1 + 2 * w), w * w * (1 + 2 * m), h * w * m * m, -h * w * w * m};
}

// Finds points and slopes at the knots by least squares. Curvature has a small weight, so that
// spans without points stay smooth.
std::vector<Profile::Node> solveNodes(const std::vector<CurvePoint>& points,
                                      const std::vector<double>& knots, bool closed) {
  const auto spans = static_cast<int>(knots.size()) - 1;
  const int count = closed ? spans : spans + 1;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(2 * count, 2);
  const auto indices = [&](int span) {
    const int next = (span + 1) % count;
    return std::array<int, 4>{span, next, count + span, count + next};
  };
  std::size_t span = 0;
  for (const CurvePoint& p : points) {  // sorted by t
    while (static_cast<int>(span) + 1 < spans && p.t > knots[span + 1]) ++span;
    const double h = knots[span + 1] - knots[span];
    const std::array<double, 4> row = basis((p.t - knots[span]) / h, h);
    const std::array<int, 4> at = indices(static_cast<int>(span));
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) normal(at[i], at[j]) += row[i] * row[j];
      right.row(at[i]) += row[i] * p.at.transpose();
    }
  }
  const double weight = kSmoothing * static_cast<double>(points.size()) / spans;
  for (int s = 0; s < spans; ++s) {
    const double h = knots[s + 1] - knots[s];
    const std::array<int, 4> at = indices(s);
    // Second derivatives at both ends of the span, times h squared: a row of factors for each end.
    const std::array<std::array<double, 4>, 2> bends{
        {{-6, 6, -4 * h, -2 * h}, {6, -6, 2 * h, 4 * h}}};
    for (const auto& bend : bends) {
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) normal(at[i], at[j]) += weight * bend[i] * bend[j];
      }
    }
  }
  normal.diagonal().array() += 1e-14 * normal.trace();
  const Eigen::MatrixX2d solution = normal.ldlt().solve(right);
  std::vector<Profile::Node> nodes;
  for (int k = 0; k <= spans; ++k) {
    const int i = k % count;
    nodes.push_back({solution.row(i).transpose(), solution.row(count + i).transpose(),
                     knots[static_cast<std::size_t>(k)]});
  }
  return nodes;
}

bool isSound(const std::vector<Profile::Node>& nodes) {
  return std::all_of(nodes.begin(), nodes.end(), [](const Profile::Node& node) {
    const double slope = node.slope.norm();
    return node.at.allFinite() && slope > 0.3 && slope < 3;
  });
}

std::vector<double> firstKnots(const Trace& trace, const std::vector<CurvePoint>& points) {
  double from = 0, length = trace.along.back();
  if (!trace.closed) {
    const auto byParameter = [](const CurvePoint& a, const CurvePoint& b) { return a.t < b.t; };
    from = std::min_element(points.begin(), points.end(), byParameter)->t;
    length = std::max_element(points.begin(), points.end(), byParameter)->t - from;
  }
  const int spans = std::clamp(static_cast<int>(std::ceil(trace.turn / kTurnPerSpan)),
                               trace.closed ? 8 : 2, kMaxSpans / 2);
  std::vector<double> knots;
  for (int i = 0; i <= spans; ++i) knots.push_back(from + length * i / spans);
  return knots;
}

// Halves each span whose points are too far from the profile (root mean square), if it has enough
// points. Returns false if no span was halved.
bool halveSpans(const std::vector<CurvePoint>& points, const Profile& profile, double exact,
                std::vector<double>& knots) {
  constexpr std::size_t kMinPoints = 8;
  std::vector<double> next{knots.front()};
  auto from = points.begin();
  for (std::size_t s = 0; s + 1 < knots.size(); ++s) {
    double sum = 0;
    std::size_t count = 0;
    for (; from != points.end() && (from->t <= knots[s + 1] || s + 2 == knots.size());
         ++from, ++count)
      sum += (profile.at(from->t) - from->at).squaredNorm();
    const bool rough = sum > exact * exact * static_cast<double>(count);
    if (rough && count >= 2 * kMinPoints) next.push_back((knots[s] + knots[s + 1]) / 2);
    next.push_back(knots[s + 1]);
  }
  const bool changed = next.size() > knots.size();
  knots.swap(next);
  return changed;
}

struct Moments {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
};

// Moves and tilts the axis so that the points come nearer to the unchanged profile. Returns the
// length of this step (mm), or 1e300 if it is too large and was not made.
double improveAxis(const Samples& samples, const Vector3d& mean, double size, Carrier& s) {
  const Vector3d e1 = s.xdir, e2 = s.axis.cross(e1);
  const double middle = (mean - s.point).dot(s.axis);
  Moments moments;
  for (const Vector3d& p : samples.points) {
    const Vector3d outward = s.normal(p), d = p - s.point;
    const double along = d.dot(s.axis) - middle, up = outward.dot(s.axis);
    const Vector3d radial = d - d.dot(s.axis) * s.axis;
    const bool isExtrusion = s.kind == CarrierKind::Extrusion;
    Eigen::Vector4d row;
    row[0] = -outward.dot(e1);
    row[1] = -outward.dot(e2);
    row[2] = (-along * outward.dot(e1) + (isExtrusion ? 0 : up * radial.dot(e1))) / size;
    row[3] = (-along * outward.dot(e2) + (isExtrusion ? 0 : up * radial.dot(e2))) / size;
    moments.normal += row * row.transpose();
    moments.right -= row * s.distance(p);
  }
  moments.normal.diagonal().array() += 1e-9 * moments.normal.trace();
  const Eigen::Vector4d step = moments.normal.ldlt().solve(moments.right);
  if (!step.allFinite() || step.norm() > 0.2 * size) return 1e300;
  const Vector3d pivot = s.point + middle * s.axis + step[0] * e1 + step[1] * e2;
  s.axis = (s.axis + (step[2] * e1 + step[3] * e2) / size).normalized();
  s.point = pivot;
  s.xdir = (e1 - e1.dot(s.axis) * s.axis).normalized();
  return step.norm();
}

Cloud cloudOf(const Samples& samples, const Carrier& s) {
  Cloud cloud;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector3d &p = samples.points[i], &n = samples.normals[i];
    const Vector3d d = p - s.point, radial = d - d.dot(s.axis) * s.axis;
    const Vector3d x = s.kind == CarrierKind::Extrusion ? s.xdir : Vector3d(radial.normalized());
    const Vector3d y = s.kind == CarrierKind::Extrusion ? s.axis.cross(s.xdir) : s.axis;
    const Vector2d flat(n.dot(x), n.dot(y));
    if (!(flat.norm() > 0.5)) continue;
    cloud.points.push_back(s.inProfile(p));
    cloud.normals.push_back(flat.normalized());
  }
  return cloud;
}

}  // namespace

std::optional<Profile> fitProfile(const Cloud& cloud, double exact) {
  const std::optional<Trace> trace = tracePoints(cloud.points, cloud.normals);
  if (!trace) return std::nullopt;
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double t = trace->parameterOf(cloud.points[i], cloud.normals[i]);
    if (t >= 0) points.push_back({t, cloud.points[i]});
  }
  if (points.size() < 12) return std::nullopt;
  const auto byParameter = [](const CurvePoint& a, const CurvePoint& b) {
    return a.t != b.t ? a.t < b.t : a.at.x() < b.at.x();
  };
  std::vector<double> knots = firstKnots(*trace, points);
  const double beyond = trace->closed ? 0 : kEndFraction * trace->along.back();
  std::optional<Profile> result;
  double before = 1e300;
  for (int round = 0; round <= kHalvings; ++round) {
    std::sort(points.begin(), points.end(), byParameter);
    std::vector<Profile::Node> nodes = solveNodes(points, knots, trace->closed);
    if (!isSound(nodes)) return result;
    // Without straight end pieces, the parameters stay within the knots.
    const Profile bare(nodes, trace->closed, 0);
    double squares = 0;
    for (CurvePoint& p : points) {
      const Profile::Foot foot = bare.foot(p.at);
      p.t = foot.t;
      squares += (foot.at - p.at).squaredNorm();
    }
    // Further spans would only follow the scatter of the points.
    if (squares > kMaxRemaining * before) break;
    before = squares;
    result.emplace(std::move(nodes), trace->closed, beyond);
    std::sort(points.begin(), points.end(), byParameter);
    if (knots.size() > kMaxSpans || !halveSpans(points, bare, exact, knots)) break;
  }
  return result;
}

std::optional<Carrier> guessAxis(CarrierKind kind, const Samples& samples, double& spread) {
  const auto count = static_cast<double>(samples.points.size());
  const PointSpread around = spreadOf(samples);
  Carrier surface;
  surface.kind = kind;
  if (kind == CarrierKind::Extrusion) {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Vector3d& n : samples.normals) moments += n * n.transpose() / count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    // On a nearly plane region any direction in the plane would fit.
    if (!(solver.eigenvalues()[1] > 4 * solver.eigenvalues()[0] + 1e-3)) return std::nullopt;
    spread = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
    surface.axis = solver.eigenvectors().col(0).normalized();
    surface.point = around.mean;
  } else {
    const NormalsAxis axis = axisOfNormals(samples, around);
    if (!(axis.direction.norm() > 0.05) || !(axis.second > 4 * axis.smallest + 1e-6))
      return std::nullopt;
    // A helix has no axis of revolution.
    if (std::abs(axis.direction.dot(axis.moment)) > 0.02 * axis.direction.squaredNorm())
      return std::nullopt;
    surface.axis = axis.direction.normalized();
    surface.point = axis.point;
    double sum = 0;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const Vector3d turning = surface.axis.cross(samples.points[i] - surface.point).normalized();
      sum += std::pow(turning.dot(samples.normals[i]), 2) / count;
    }
    spread = std::sqrt(sum);
  }
  surface.xdir = anyOrthogonal(surface.axis);
  return surface;
}

bool fitAlong(const Samples& samples, double exact, Carrier& surface) {
  const Vector3d mean = spreadOf(samples).mean;
  double size = 0;
  for (const Vector3d& p : samples.points) size = std::max(size, (p - mean).norm());
  for (int round = 0; round <= kAxisRounds; ++round) {
    std::optional<Profile> profile = fitProfile(cloudOf(samples, surface), exact);
    if (!profile) return false;
    surface.profile = std::make_shared<const Profile>(std::move(*profile));
    orient(samples, surface);
    if (round == kAxisRounds) break;
    const Carrier before = surface;
    const double step = improveAxis(samples, mean, size, surface);
    if (step > 1e299) surface = before;
    if (step > 1e299 || step < 0.02 * exact) break;
  }
  return true;
}

}  // namespace swept::step
