// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/crossing_refine.h"

#include <algorithm>
#include <cmath>

namespace swept {
namespace {
/// Smallest distance (cells) of crossings from lattice points, so that the crossings of all edges
/// at one lattice point stay apart. This is ten times the margin of vertices in their cells
/// (kCellMargin).
constexpr double kMinPointDistance = 1e-3;
/// If Newton's method ends farther from the lattice line than this (cells), it has not converged.
constexpr double kMaxOffLine = 1e-3;
}  // namespace

CrossingRefiner::CrossingRefiner(const SamplerInput& input, const MarkedEdges& marked)
    : input_(input), marked_(marked) {
  placements_.reserve(input.motion.placements.size());
  for (const Placement& p : input.motion.placements) placements_.push_back(input.grid.toGrid(p));
  for (std::size_t k = 0; k < input.motion.steps(); ++k) {
    const Placement mid = input.grid.toGrid(input.motion.midpoints[k]);
    const Placement &p = placements_[k], &q = placements_[k + 1];
    bulges_.push_back({mid.rotation - (p.rotation + q.rotation) / 2,
                       mid.translation - (p.translation + q.translation) / 2, mid.timeSeconds});
  }
}

CrossingRefiner::Hit CrossingRefiner::onFace(const SweptElement& element, int axis,
                                             const Eigen::Vector3d& line) const {
  const Placement& p = placements_[element.placement];
  const auto& t = input_.body.triangles[element.index()];
  const Eigen::Vector3d a = p.apply(input_.body.vertices[t[0]]);
  const Eigen::Vector3d b = p.apply(input_.body.vertices[t[1]]);
  const Eigen::Vector3d c = p.apply(input_.body.vertices[t[2]]);
  const Eigen::Vector3d n = (b - a).cross(c - a);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return {a[axis] + (n[u] * (a[u] - line[u]) + n[v] * (a[v] - line[v])) / n[axis], n,
          p.timeSeconds};
}

namespace {

/// A side patch that follows the curved motion of its step: x(r, s) = A(s) + r B(s). A is the path
/// of one end of the edge, and B is the edge vector.
class CurvedPatch {
 public:
  CurvedPatch(const Placement& p, const Placement& q, const Placement& m, const Eigen::Vector3d& va,
              const Eigen::Vector3d& vb)
      : a0_(p.apply(va)), a1_(q.apply(va) - a0_), a2_(4 * m.apply(va)) {
    const Eigen::Vector3d d = vb - va;
    b0_ = p.rotation * d;
    b1_ = q.rotation * d - b0_;
    b2_ = 4 * (m.rotation * d);
  }

  struct At {
    Eigen::Vector3d x, alongEdge, alongTime;
  };
  At at(double r, double s) const {
    const double bulge = s * (1 - s), bulgeSpeed = 1 - 2 * s;
    At at;
    at.alongEdge = b0_ + s * b1_ + bulge * b2_;
    at.x = a0_ + s * a1_ + bulge * a2_ + r * at.alongEdge;
    at.alongTime = a1_ + bulgeSpeed * a2_ + r * (b1_ + bulgeSpeed * b2_);
    return at;
  }

 private:
  Eigen::Vector3d a0_, a1_, a2_, b0_, b1_, b2_;
};

/// Searches for the point at which a lattice line meets a patch. The axes u and v are perpendicular
/// to the line.
struct LineSearch {
  const CurvedPatch& patch;
  const Eigen::Vector3d& line;
  int u, v;

  double offLine(const CurvedPatch::At& at) const {
    return std::max(std::abs(at.x[u] - line[u]), std::abs(at.x[v] - line[v]));
  }

  /// Improves (r, s) by Newton's method. If the method does not converge, the resulting point is
  /// not on the line.
  void newton(double& r, double& s) const {
    for (int iteration = 0; iteration < 4; ++iteration) {
      const CurvedPatch::At at = patch.at(r, s);
      const double det = at.alongEdge[u] * at.alongTime[v] - at.alongEdge[v] * at.alongTime[u];
      if (std::abs(det) < 1e-14) break;
      const double fu = line[u] - at.x[u], fv = line[v] - at.x[v];
      const double dr = (fu * at.alongTime[v] - fv * at.alongTime[u]) / det;
      const double ds = (at.alongEdge[u] * fv - at.alongEdge[v] * fu) / det;
      r = std::clamp(r + dr, -0.5, 1.5);
      s = std::clamp(s + ds, -0.5, 1.5);
      if (std::abs(dr) + std::abs(ds) < 1e-7) break;
    }
    r = std::clamp(r, 0.0, 1.0);
    s = std::clamp(s, 0.0, 1.0);
  }

  /// Finds the point of the patch nearest to the line. Starts at the best of several points, and
  /// damps the steps until they reduce the distance (Levenberg 1944, Marquardt 1963). This is for
  /// edges that slide along themselves: they sweep hardly any area, and the steps of newton() leave
  /// the patch.
  void nearest(double& r, double& s) const {
    const auto square = [&](double x, double y) {
      const CurvedPatch::At at = patch.at(x, y);
      return Eigen::Vector2d(at.x[u] - line[u], at.x[v] - line[v]).squaredNorm();
    };
    constexpr int kSamples = 4, kSteps = 40;
    double best = square(r, s);
    for (int i = 0; i <= kSamples; ++i) {
      for (int j = 0; j <= kSamples; ++j) {
        const double x = static_cast<double>(i) / kSamples, y = static_cast<double>(j) / kSamples;
        const double here = square(x, y);
        if (here >= best) continue;
        best = here;
        r = x;
        s = y;
      }
    }
    double damping = 1e-3;
    for (int step = 0; step < kSteps && damping < 1e9; ++step) {
      const CurvedPatch::At at = patch.at(r, s);
      Eigen::Matrix2d j;
      j << at.alongEdge[u], at.alongTime[u], at.alongEdge[v], at.alongTime[v];
      const Eigen::Vector2d off(at.x[u] - line[u], at.x[v] - line[v]);
      Eigen::Matrix2d normal = j.transpose() * j;
      normal.diagonal() *= 1 + damping;
      normal.diagonal().array() += 1e-30;
      const Eigen::Vector2d change = normal.inverse() * (j.transpose() * off);
      const double x = std::clamp(r - change[0], 0.0, 1.0), y = std::clamp(s - change[1], 0.0, 1.0);
      const double here = square(x, y);
      damping *= here < best ? 0.2 : 5;
      if (!(here < best)) continue;
      best = here;
      r = x;
      s = y;
    }
  }
};

}  // namespace

CrossingRefiner::Hit CrossingRefiner::onSidePatch(const SweptElement& element, int axis,
                                                  const Eigen::Vector3d& line) const {
  const Placement &p = placements_[element.placement], &q = placements_[element.placement + 1];
  const BodyEdge& edge = input_.topology.edges[element.index()];
  const CurvedPatch patch(p, q, bulges_[element.placement], input_.body.vertices[edge.a],
                          input_.body.vertices[edge.b]);
  const LineSearch search{patch, line, (axis + 1) % 3, (axis + 2) % 3};
  const int u = search.u, v = search.v;
  double r = 0.5, s = 0.5;
  search.newton(r, s);
  CurvedPatch::At at = patch.at(r, s);
  if (search.offLine(at) > kMaxOffLine) {
    search.nearest(r, s);
    at = patch.at(r, s);
  }
  const Eigen::Vector3d n = at.alongEdge.cross(at.alongTime);
  // The point is still slightly off the lattice line. Use the intersection of the line with the
  // tangent plane.
  double along = at.x[axis];
  if (std::abs(n[axis]) > 0.1 * n.norm()) {
    along += (n[u] * (at.x[u] - line[u]) + n[v] * (at.x[v] - line[v])) / n[axis];
  }
  return {along, n, p.timeSeconds + s * (q.timeSeconds - p.timeSeconds), search.offLine(at)};
}

double CrossingRefiner::nearestTime(const SweptElement& element,
                                    const Eigen::Vector3d& point) const {
  const Placement &p = placements_[element.placement], &q = placements_[element.placement + 1];
  const BodyEdge& edge = input_.topology.edges[element.index()];
  const CurvedPatch patch(p, q, bulges_[element.placement], input_.body.vertices[edge.a],
                          input_.body.vertices[edge.b]);
  const auto distance = [&](double s) {
    const CurvedPatch::At at = patch.at(0, s);
    const Eigen::Vector3d& direction = at.alongEdge;
    const double along =
        std::clamp((point - at.x).dot(direction) / direction.squaredNorm(), 0.0, 1.0);
    return (point - at.x - along * direction).squaredNorm();
  };
  // A few samples find the interval of the minimum, because the step is short. Then a search with
  // halved widths finds the minimum.
  constexpr int kSamples = 16, kHalvings = 30;
  int nearest = 0;
  for (int sample = 1; sample <= kSamples; ++sample) {
    if (distance(static_cast<double>(sample) / kSamples) <
        distance(static_cast<double>(nearest) / kSamples)) {
      nearest = sample;
    }
  }
  double best = static_cast<double>(nearest) / kSamples, width = 1.0 / kSamples;
  for (int halving = 0; halving < kHalvings; ++halving, width /= 2) {
    const double now = best;
    for (const double s : {std::max(now - width, 0.0), std::min(now + width, 1.0)}) {
      if (distance(s) < distance(best)) best = s;
    }
  }
  return p.timeSeconds + best * (q.timeSeconds - p.timeSeconds);
}

Crossing CrossingRefiner::refine(int axis, std::int32_t i, std::int32_t j, std::int32_t k,
                                 float fraction, std::uint32_t elementIndex, bool low,
                                 double* exactSeconds) const {
  const Eigen::Vector3d line(i, j, k);
  const SweptElement& element = marked_.elements[elementIndex];
  const Hit hit =
      element.isSidePatch() ? onSidePatch(element, axis, line) : onFace(element, axis, line);
  Crossing crossing;
  crossing.timeSeconds = static_cast<float>(hit.timeSeconds);
  const double exact = hit.along - line[axis];
  // A grazing face or a degenerate side patch has no well-defined intersection. The sampled
  // fraction is kept if the exact point is farther from it than this (cells).
  constexpr double kMaxCorrection = 0.25;
  const double position =
      std::isfinite(exact) && std::abs(exact - fraction) < kMaxCorrection ? exact : fraction;
  crossing.fraction =
      static_cast<float>(std::clamp(position, kMinPointDistance, 1 - kMinPointDistance));
  if (exactSeconds != nullptr) {
    constexpr double kOnLine = 1e-5;  // cells
    *exactSeconds = hit.timeSeconds;
    if (element.isSidePatch() && !(hit.offLine < kOnLine && position == exact)) {
      Eigen::Vector3d point = line;
      point[axis] += crossing.fraction;
      *exactSeconds = nearestTime(element, point);
    }
  }
  const double length = hit.normal.norm();
  if (length > 0) {
    const bool towardsHigh = hit.normal[axis] > 0;
    crossing.normal = (hit.normal / (towardsHigh == low ? -length : length)).cast<float>();
  } else {
    crossing.normal[axis] = low ? -1.0f : 1.0f;
  }
  return crossing;
}

}  // namespace swept
