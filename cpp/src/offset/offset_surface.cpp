// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/offset_surface.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace swept::offset {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-6;   // cells: gaps are stored as floats
constexpr double kFromPoint = 1e-3;  // cells: smallest distance of crossings from lattice points
// Dips are only searched for below this offset distance (cells), because a dip (offset_surface.h)
// is less deep than 1 / (8 distance).
constexpr double kDipsBelow = 2;
constexpr double kMinDip = 1.0 / 32;  // fraction of an edge: shorter dips are not searched for
// Limits of the offset distance (cells).
constexpr double kApart = 0.5;  // below this distance, an edge may pass through two separate walls
constexpr double kThin = kMinDip / 2;  // below this distance, shorter dips are searched for, too
// Below this distance, crossings have the normals of the cover triangles.
constexpr double kFlat = 1e-3;

/// Returns the smallest t in [0, 1] at which origin + t * path is within `radius` of the triangle.
/// Returns 1 if the path does not come so near.
double entry(const Vector3d& origin, const Vector3d& path, const CoverTriangle& triangle,
             double radius) {
  double t = 0;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vector3d x = origin + t * path;
    const Vector3d apart = x - nearestOnTriangle(x, triangle);
    const double distance = apart.norm(), over = distance - radius;
    if (over <= 1e-10) break;
    const double speed = -apart.dot(path) / distance;
    if (!(speed > 1e-9)) return 1;  // the path does not come nearer
    t += over / speed;
    if (t >= 1) return 1;
  }
  return t;
}

struct Entry {
  double t = 1;  ///< fraction of the path, 1 if there is no entry
  std::int32_t triangle = -1;
};

/// Finds where a path along an axis first comes within `distance` plus slack of a triangle. If this
/// never happens, the result has the triangle -1.
Entry firstEntry(const CoverSearch& tree, double distance, const Vector3d& origin,
                 const Vector3d& path) {
  Entry first;
  const Vector3d end = origin + path;
  tree.forNear(origin.cwiseMin(end), origin.cwiseMax(end), distance, [&](std::int32_t index) {
    const CoverTriangle& triangle = tree.triangle(index);
    const double t = entry(origin, path, triangle, distance + triangle.slack);
    if (t < first.t) first = {t, index};
  });
  return first;
}

/// Searches an edge between t0 and t1 for a point with a gap of at most 0. Returns its position on
/// the edge, or -1 if there is none. `gap0` and `gap1`: the gaps at t0 and t1.
double findDip(const CoverSearch& tree, double distance, const Vector3d& origin, int axis,
               double t0, double gap0, double t1, double gap1) {
  if (gap0 + gap1 >= t1 - t0 + kRounding) return -1;
  if (t1 - t0 < kMinDip) {
    if (distance >= kThin) return -1;
    Vector3d from = origin;
    from[axis] += t0;
    const Entry found = firstEntry(tree, distance, from, (t1 - t0) * Vector3d::Unit(axis));
    return found.triangle >= 0 ? t0 + found.t * (t1 - t0) : -1;
  }
  const double middle = (t0 + t1) / 2, most = distance + (t1 - t0) / 2;
  Vector3d x = origin;
  x[axis] += middle;
  const double gap = tree.nearest(x, most).reach - distance;
  if (gap <= 0) return middle;
  const double below = findDip(tree, distance, origin, axis, t0, gap0, middle, gap);
  return below >= 0 ? below : findDip(tree, distance, origin, axis, middle, gap, t1, gap1);
}

/// Finds where the path enters the offset body. The end of the path must lie inside.
Entry entryOf(const CoverSearch& tree, double distance, const Vector3d& origin,
              const Vector3d& path) {
  const auto atEnd = [&] { return tree.nearest(origin + path, distance + kRounding); };
  if (distance < kApart) {
    const Entry first = firstEntry(tree, distance, origin, path);
    return first.triangle >= 0 ? first : Entry{1, atEnd().triangle};
  }
  Entry first;
  CoverSearch::Nearest found = atEnd();
  for (int round = 0; found.triangle >= 0 && round < 32; ++round) {
    const CoverTriangle& triangle = tree.triangle(found.triangle);
    const double at = entry(origin, path, triangle, distance + triangle.slack);
    if (round > 0 && !(at < first.t - 1e-9)) break;
    first = {at, found.triangle};
    found = tree.nearest(origin + at * path, distance - 1e-7, found.triangle);
  }
  return first;
}

/// Returns the unit normal of the triangle that points against the path. If the triangle has no
/// area, returns the reversed direction of the path.
Vector3d normalAgainst(const Vector3d& path, const CoverTriangle& t) {
  const Vector3d normal = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
  if (!(normal.norm() > 0)) return -path.normalized();
  return normal.normalized() * (normal.dot(path) > 0 ? -1 : 1);
}

float timeAt(const CoverTriangle& t, const Vector3d& p) {
  const Vector3d u = t.corner[1] - t.corner[0], v = t.corner[2] - t.corner[0], w = p - t.corner[0];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double det = uu * vv - uv * uv;
  if (!(det > 1e-12 * uu * vv)) {  // a needle: interpolate along its longer side
    const int far = uu > vv ? 1 : 2;
    const double s = std::max(uu, vv) > 0 ? w.dot(uu > vv ? u : v) / std::max(uu, vv) : 0;
    return static_cast<float>((1 - s) * t.timeSeconds[0] + s * t.timeSeconds[far]);
  }
  const double b = (vv * w.dot(u) - uv * w.dot(v)) / det, c = (uu * w.dot(v) - uv * w.dot(u)) / det;
  return static_cast<float>((1 - b - c) * t.timeSeconds[0] + b * t.timeSeconds[1] +
                            c * t.timeSeconds[2]);
}

/// Marks the edges of one lattice layer.
class LayerMarker {
 public:
  LayerMarker(const OffsetField& field, const CoverSearch& tree, const GridPlan& grid,
              std::int32_t i, LayerEdges& out)
      : field_(field), tree_(tree), points_(grid.points), i_(i), out_(out) {}

  void mark() {
    for (int axis = 0; axis < 3; ++axis) {
      out_.columnStart[axis].assign(static_cast<std::size_t>(points_[1]) + 1, 0);
      if (axis == 0 && i_ + 1 == points_[0]) continue;
      const std::int32_t columns = axis == 1 ? points_[1] - 1 : points_[1];
      for (std::int32_t j = 0; j < points_[1]; ++j) {
        out_.columnStart[axis][j] = static_cast<std::uint32_t>(out_.edges[axis].size());
        if (j < columns) column(axis, j);
      }
      out_.columnStart[axis][points_[1]] = static_cast<std::uint32_t>(out_.edges[axis].size());
    }
  }

 private:
  void column(int axis, std::int32_t j) {
    constexpr std::int32_t kBlock = OffsetField::kBlock;
    const std::int32_t end = axis == 2 ? points_[2] - 1 : points_[2];
    for (std::int32_t k = 0; k < end;) {
      const std::int32_t next = std::min((k / kBlock + 1) * kBlock, end);
      if (field_.isMixed(i_ / kBlock, j / kBlock, k / kBlock)) {
        for (; k < next; ++k) edge(axis, j, k);
      }
      k = next;
    }
  }
  void edge(int axis, std::int32_t j, std::int32_t k) {
    const float low = field_.gap(i_, j, k);
    const float high = field_.gap(i_ + (axis == 0), j + (axis == 1), k + (axis == 2));
    double inside = -1;
    if ((low > 0) != (high > 0)) {
      inside = low > 0 ? 1 : 0;
    } else if (low > 0 && low + high < 1 + kRounding && field_.distance() < kDipsBelow) {
      inside = findDip(tree_, field_.distance(), Vector3d(i_, j, k), axis, 0, low, 1, high);
    }
    if (inside < 0) return;
    MarkedEdge marked;
    marked.lowFraction = marked.highFraction = static_cast<float>(inside);
    marked.k = static_cast<std::uint16_t>(k);
    out_.edges[axis].push_back(marked);
  }

  const OffsetField& field_;
  const CoverSearch& tree_;
  const std::array<std::int32_t, 3> points_;
  const std::int32_t i_;
  LayerEdges& out_;
};

}  // namespace

MarkedEdges markOffset(const OffsetField& field, const CoverSearch& tree, const GridPlan& grid,
                       RunContext& run) {
  MarkedEdges out;
  const auto layers = static_cast<std::size_t>(grid.points[0]);
  out.layers.resize(layers);
  parallelFor(layers, [&](std::size_t layer) {
    run.checkpoint(Phase::Sampling, layer, layers);
    LayerMarker(field, tree, grid, static_cast<std::int32_t>(layer), out.layers[layer]).mark();
  });
  return out;
}

Crossing offsetCrossing(const CoverSearch& tree, double distance, int axis, std::int32_t i,
                        std::int32_t j, const MarkedEdge& edge, bool fromLow) {
  Vector3d low(i, j, edge.k), path = Vector3d::Zero();
  const double inside = edge.lowFraction;
  Vector3d origin = low;
  path[axis] = inside;
  if (!fromLow) {
    origin[axis] += 1;
    path[axis] = inside - 1;
  }
  const Entry first = entryOf(tree, distance, origin, path);
  const Vector3d x = origin + first.t * path;
  Vector3d normal = -path.normalized();
  Crossing crossing;
  if (first.triangle >= 0) {
    const CoverTriangle& triangle = tree.triangle(first.triangle);
    const Vector3d foot = nearestOnTriangle(x, triangle);
    if (distance < kFlat) {
      normal = normalAgainst(path, triangle);
    } else if ((x - foot).norm() > 1e-9) {
      normal = (x - foot).normalized();
    }
    crossing.timeSeconds = timeAt(triangle, foot);
  }
  crossing.normal = normal.cast<float>();
  crossing.fraction =
      static_cast<float>(std::clamp(x[axis] - low[axis], kFromPoint, 1 - kFromPoint));
  return crossing;
}

}  // namespace swept::offset
