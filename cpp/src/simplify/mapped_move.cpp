// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/mapped_move.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace swept {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kOverlap = std::numeric_limits<double>::infinity();
/// Areas below this fraction of the squared size count as overlaps. The fraction is far above
/// rounding.
constexpr double kMinArea = 1e-12;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The ring, projected along the mean normal: positions in the plane, and heights.
struct Projection {
  std::vector<Vector2d> at;
  std::vector<double> height;
};

Projection projectAlong(const Vector3d& normal, const std::vector<Vector3d>& ring) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Projection projection;
  for (const Vector3d& p : ring) {
    projection.at.emplace_back(u.dot(p), v.dot(p));
    projection.height.push_back(normal.dot(p));
  }
  return projection;
}

/// Returns whether the triangles do not overlap, before and after the collapse. Triangles between
/// the origin and the ring must go round the origin exactly once. Triangles between ring[0] and the
/// rest of the ring must all have the same orientation.
bool isFreeOfOverlap(const std::vector<Vector2d>& at, double minArea) {
  int rounds = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Vector2d &a = at[k], &b = at[(k + 1) % at.size()];
    if (!(cross(a, b) > minArea)) return false;
    if (a.y() < 0 && b.y() >= 0) ++rounds;
    if (k == 0 || k + 1 == at.size()) continue;
    if (!(cross(a - at[0], b - at[0]) > minArea)) return false;
  }
  return rounds == 1;
}

/// Returns the height of the new surface at the origin.
double heightAtOrigin(const Projection& projection) {
  const Vector2d& v = projection.at[0];
  // The triangle that contains the origin is the one whose smallest barycentric coordinate there is
  // largest. This choice needs no tolerance for rounding.
  double best = -std::numeric_limits<double>::infinity(), height = 0;
  for (std::size_t k = 1; k + 1 < projection.at.size(); ++k) {
    const Vector2d &a = projection.at[k], &b = projection.at[k + 1];
    const double ofV = cross(a, b), ofA = cross(b, v), ofB = cross(v, a), sum = ofV + ofA + ofB;
    const double least = std::min({ofV, ofA, ofB}) / sum;
    if (least <= best) continue;
    best = least;
    height =
        (ofV * projection.height[0] + ofA * projection.height[k] + ofB * projection.height[k + 1]) /
        sum;
  }
  return height;
}

}  // namespace

double mappedMove(const std::vector<Vector3d>& ring) {
  const std::size_t count = ring.size();
  Vector3d mean = Vector3d::Zero();
  double size = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d &a = ring[k], &b = ring[(k + 1) % count], area = a.cross(b);
    const double twice = area.norm();
    if (twice > 0) mean += std::atan2(twice, a.dot(b)) / twice * area;
    size = std::max(size, ring[k].squaredNorm());
  }
  const double length = mean.norm();
  if (!(length > 0)) return kOverlap;
  const Projection projection = projectAlong(mean / length, ring);
  if (!isFreeOfOverlap(projection.at, kMinArea * size)) return kOverlap;
  double farthest = std::abs(heightAtOrigin(projection));
  // Tests where the new edges, from ring[0] to ring[i], cross the old ones, from the origin to
  // ring[j].
  for (std::size_t i = 2; i + 1 < count; ++i) {
    const Vector2d along = projection.at[i] - projection.at[0];
    for (std::size_t j = 1; j < count; ++j) {
      // s * at[j] = at[0] + t * along
      const double area = cross(projection.at[j], along);
      if (j == i || area == 0) continue;
      const double s = cross(projection.at[0], along) / area,
                   t = cross(projection.at[0], projection.at[j]) / area;
      if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) continue;
      const double after = projection.height[0] + t * (projection.height[i] - projection.height[0]);
      farthest = std::max(farthest, std::abs(after - s * projection.height[j]));
    }
  }
  return farthest;
}

}  // namespace swept
