// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/crossing_refine.h"

#include <algorithm>
#include <cmath>

namespace swept {
namespace {
/// Cells: crossings keep this distance from lattice points, so that the crossings of the edges at
/// one lattice point stay apart. It is ten times the margin of vertices in their cells
/// (kCellMargin).
constexpr double kMinPointDistance = 1e-3;
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

CrossingRefiner::Hit CrossingRefiner::onSidePatch(const SweptElement& element, int axis,
                                                  const Eigen::Vector3d& line) const {
  const Placement &p = placements_[element.placement], &q = placements_[element.placement + 1];
  const Placement& m = bulges_[element.placement];
  const BodyEdge& edge = input_.topology.edges[element.index()];
  const Eigen::Vector3d &va = input_.body.vertices[edge.a], &vb = input_.body.vertices[edge.b];
  // x(r, s) = A(s) + r B(s), with A the path of vertex a and B the edge vector.
  const Eigen::Vector3d a0 = p.apply(va), a1 = q.apply(va) - a0, a2 = 4 * m.apply(va);
  const Eigen::Vector3d d = vb - va;
  const Eigen::Vector3d b0 = p.rotation * d, b1 = q.rotation * d - b0, b2 = 4 * (m.rotation * d);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double r = 0.5, s = 0.5;
  Eigen::Vector3d alongEdge = b0, alongTime = a1;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const double bulge = s * (1 - s), bulgeSpeed = 1 - 2 * s;
    alongEdge = b0 + s * b1 + bulge * b2;
    const Eigen::Vector3d x = a0 + s * a1 + bulge * a2 + r * alongEdge;
    alongTime = a1 + bulgeSpeed * a2 + r * (b1 + bulgeSpeed * b2);
    const double det = alongEdge[u] * alongTime[v] - alongEdge[v] * alongTime[u];
    if (std::abs(det) < 1e-14) break;
    const double fu = line[u] - x[u], fv = line[v] - x[v];
    const double dr = (fu * alongTime[v] - fv * alongTime[u]) / det;
    const double ds = (alongEdge[u] * fv - alongEdge[v] * fu) / det;
    r = std::clamp(r + dr, -0.5, 1.5);
    s = std::clamp(s + ds, -0.5, 1.5);
    if (std::abs(dr) + std::abs(ds) < 1e-7) break;
  }
  r = std::clamp(r, 0.0, 1.0);
  s = std::clamp(s, 0.0, 1.0);
  const double bulge = s * (1 - s);
  alongEdge = b0 + s * b1 + bulge * b2;
  alongTime = a1 + (1 - 2 * s) * a2 + r * (b1 + (1 - 2 * s) * b2);
  const Eigen::Vector3d x = a0 + s * a1 + bulge * a2 + r * alongEdge;
  const Eigen::Vector3d n = alongEdge.cross(alongTime);
  const double offLine = std::max(std::abs(x[u] - line[u]), std::abs(x[v] - line[v]));
  // Newton's method leaves a small distance from the lattice line; move along the line until the
  // tangent plane is reached.
  double along = x[axis];
  if (std::abs(n[axis]) > 0.1 * n.norm()) {
    along += (n[u] * (x[u] - line[u]) + n[v] * (x[v] - line[v])) / n[axis];
  }
  return {along, n, p.timeSeconds + s * (q.timeSeconds - p.timeSeconds), offLine};
}

double CrossingRefiner::nearestTime(const SweptElement& element,
                                    const Eigen::Vector3d& point) const {
  const Placement &p = placements_[element.placement], &q = placements_[element.placement + 1];
  const Placement& m = bulges_[element.placement];
  const BodyEdge& edge = input_.topology.edges[element.index()];
  const auto at = [&](double s, const Eigen::Vector3d& v) {
    return Eigen::Vector3d((1 - s) * p.apply(v) + s * q.apply(v) + 4 * s * (1 - s) * m.apply(v));
  };
  const auto distance = [&](double s) {
    const Eigen::Vector3d a = at(s, input_.body.vertices[edge.a]),
                          way = at(s, input_.body.vertices[edge.b]) - a;
    const double along = std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (point - a - along * way).squaredNorm();
  };
  // The step is short: some looks find the valley, halving its width the bottom.
  constexpr int kLooks = 16, kHalvings = 30;
  int nearest = 0;
  for (int look = 1; look <= kLooks; ++look) {
    if (distance(static_cast<double>(look) / kLooks) <
        distance(static_cast<double>(nearest) / kLooks)) {
      nearest = look;
    }
  }
  double best = static_cast<double>(nearest) / kLooks, width = 1.0 / kLooks;
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
  // Cells. A grazing face or a degenerate side patch has no well-defined intersection: farther than
  // this from the sampler's crossing, the sampler's fraction is kept.
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
