// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/deviation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kBlock = 2048;
constexpr double kCommonFraction = 0.6;  // fraction of the limit that nearly all deviations exceed
/// A point splits an edge instead of the triangle if its distance from the edge is less than this
/// fraction of the triangle's height.
constexpr double kMaxEdgeFraction = 0.1;

struct Beyond {
  double distance = 0;
  std::int32_t vertex = -1, triangle = -1;
};

// Returns the barycentric coordinates of the foot point of p in the plane of the triangle c.
Vector3d barycentric(const Vector3d& p, const std::array<Vector3d, 3>& c) {
  const Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
  const double twice = normal.squaredNorm();
  Vector3d weights;
  for (int k = 0; k < 3; ++k)
    weights[k] = (c[(k + 1) % 3] - p).cross(c[(k + 2) % 3] - p).dot(normal) / twice;
  return weights;
}

// Replaces triangles of the mesh by finer ones. Passes on the points that must stay near them.
class Splitter {
 public:
  explicit Splitter(Decimated& small) : small_(small), taken_(small.mesh.triangles.size(), 0) {
    for (std::size_t t = 0; t < taken_.size(); ++t) triangles_.push_back(small.mesh.triangles[t]);
    points_ = small.mesh.points;
    label_ = small.partition.patchOf;
    attached_ = std::move(small.attached);
    attached_.resize(taken_.size());
    watched_ = std::move(small.watched);
    watched_.resize(taken_.size(), 0);
  }

  bool put(const Violation& violation) {
    const std::int32_t t = violation.triangle;
    if (taken_[t] || label_[t] >= 0) return false;
    const auto& tri = small_.mesh.triangles[t];
    const Vector3d weights =
        barycentric(violation.point, {points_[tri[0]], points_[tri[1]], points_[tri[2]]});
    int corner = 0;
    const double smallest = weights.minCoeff(&corner);
    const std::int32_t edge = 3 * t + (corner + 1) % 3;
    const std::int32_t back = small_.mesh.opposite[edge];
    const bool onEdge = !(smallest > kMaxEdgeFraction);
    if (onEdge && (label_[back / 3] >= 0 || taken_[back / 3])) return false;
    const auto vertex = static_cast<std::int32_t>(points_.size());
    points_.push_back(violation.point);
    std::vector<std::int32_t> added;
    fan(t, onEdge ? edge : -1, vertex, added);
    if (onEdge) fan(back / 3, back, vertex, added);
    attachToNearest(onEdge ? std::vector<std::int32_t>{t, back / 3} : std::vector<std::int32_t>{t},
                    added);
    return true;
  }

  void finish(RunContext& run) {
    TriMesh mesh;
    mesh.vertices = std::move(points_);
    mesh.triangles = std::move(triangles_);
    small_.mesh = buildHalfEdges(mesh, run);
    small_.partition.patchOf = std::move(label_);
    small_.attached = std::move(attached_);
    small_.watched = std::move(watched_);
  }

 private:
  // Replaces triangle t by triangles that connect `vertex` with each edge of t except `without`.
  // The first new triangle gets the index of the old one.
  void fan(std::int32_t t, std::int32_t without, std::int32_t vertex,
           std::vector<std::int32_t>& added) {
    bool first = true;
    taken_[t] = 1;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t h = 3 * t + k;
      if (h == without) continue;
      const std::array<std::int32_t, 3> corners{small_.mesh.origin(h), small_.mesh.target(h),
                                                vertex};
      if (first) {
        triangles_[t] = corners;
        added.push_back(t);
      } else {
        added.push_back(static_cast<std::int32_t>(triangles_.size()));
        triangles_.push_back(corners);
        label_.push_back(label_[t]);
        attached_.emplace_back();
        watched_.push_back(1);
      }
      first = false;
    }
  }

  void attachToNearest(const std::vector<std::int32_t>& old,
                       const std::vector<std::int32_t>& added) {
    std::vector<Vector3d> points;
    for (const std::int32_t t : old) {
      points.insert(points.end(), attached_[t].begin(), attached_[t].end());
      attached_[t].clear();
    }
    for (const Vector3d& p : points) {
      double smallest = 1e300;
      std::int32_t closest = added.front();
      for (const std::int32_t t : added) {
        const auto& tri = triangles_[t];
        const double d = squaredDistance(p, points_[tri[0]], points_[tri[1]], points_[tri[2]]);
        if (d >= smallest) continue;
        smallest = d;
        closest = t;
      }
      attached_[closest].push_back(p);
    }
  }

  Decimated& small_;
  std::vector<char> taken_;  // by triangle of the original mesh: 1 if it has changed
  std::vector<Vector3d> points_;
  std::vector<std::array<std::int32_t, 3>> triangles_;
  std::vector<std::int32_t> label_;
  std::vector<std::vector<Vector3d>> attached_;
  std::vector<char> watched_;
};

}  // namespace

Deviation measureDeviation(const std::vector<Vector3d>& points, const Decimated& small,
                           const std::vector<Vector3d>& positions, double limit) {
  const NearestTriangle nearest(positions, small.mesh.triangles);
  const std::size_t blocks = (points.size() + kBlock - 1) / kBlock;
  std::vector<std::vector<Beyond>> found(blocks);
  std::vector<double> largestOf(blocks, 0);
  // Distances below `smallest`, or below the largest distance known so far, need not be exact.
  const auto measure = [&](double smallest) {
    parallelBlocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      double& largest = largestOf[begin / kBlock];
      std::int32_t triangle = -1;
      for (std::size_t v = begin; v < end; ++v) {
        const Vector3d& p = points[v];
        const double enough = std::min(std::max(largest, smallest), limit);
        double distance = std::sqrt(nearest.query(p, 1e300, enough * enough, triangle));
        if (distance <= enough) continue;
        const Carrier& surface = small.partition.patches[small.partition.patchOf[triangle]].surface;
        if (surface.kind != CarrierKind::Facet)
          distance = std::min(distance, std::abs(surface.distance(p)));
        largest = std::max(largest, distance);
        if (distance > limit)
          found[begin / kBlock].push_back({distance, static_cast<std::int32_t>(v), triangle});
      }
    });
    return *std::max_element(largestOf.begin(), largestOf.end());
  };
  Deviation result;
  if (points.empty()) return result;
  result.largest = measure(kCommonFraction * limit);
  if (result.largest <= kCommonFraction * limit) result.largest = measure(0);
  std::vector<Beyond> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end(), [](const Beyond& a, const Beyond& b) {
    if (a.triangle != b.triangle) return a.triangle < b.triangle;
    return a.distance != b.distance ? a.distance > b.distance : a.vertex < b.vertex;
  });
  for (const Beyond& b : all) {
    if (result.beyond.empty() || result.beyond.back().triangle != b.triangle)
      result.beyond.push_back({points[b.vertex], b.triangle});
  }
  return result;
}

std::vector<Vector3d> pointsAbout(const std::vector<Violation>& corners, const Decimated& before,
                                  double limit, const std::vector<Vector3d>& points) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Violation& corner : corners) {
    Eigen::AlignedBox3d box(corner.point);
    for (int k = 0; k < 3; ++k) {
      // A vertex on an edge also splits the triangle beyond that edge.
      const std::int32_t beyond = before.mesh.opposite[3 * corner.triangle + k] / 3;
      for (const std::int32_t v : before.mesh.triangles[beyond]) box.extend(before.mesh.points[v]);
    }
    box.min().array() -= limit;
    box.max().array() += limit;
    boxes.push_back(box);
  }
  std::vector<Vector3d> result;
  for (const Vector3d& p : points) {
    const bool near = std::any_of(boxes.begin(), boxes.end(),
                                  [&](const Eigen::AlignedBox3d& box) { return box.contains(p); });
    if (near) result.push_back(p);
  }
  return result;
}

bool putCorners(const std::vector<Violation>& points, Decimated& small, RunContext& run) {
  Splitter splitter(small);
  bool any = false;
  for (const Violation& violation : points) any = splitter.put(violation) || any;
  splitter.finish(run);
  return any;
}

}  // namespace swept::step
