// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/sweep_deviation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// At most this many points are examined, the farthest first. The others count with their distance.
constexpr std::size_t kMaxExamined = 200000;
/// So many are examined at once, first and later.
constexpr std::size_t kFirstExamined = 64, kExaminedAtOnce = 4096;
/// If more of the mesh lies elsewhere, it belongs to another motion.
constexpr double kMaxFraction = 0.1;
/// Triangles of a solid deviate from it by a tenth of a cell, unless the user chooses otherwise. So
/// this suffices for grids of 25 cells and more.
constexpr double kCoarseMesh = 1.0 / 250;
constexpr std::size_t kBlock = 256;

struct FootPoint {
  double distance;
  std::uint32_t point;
  Vector3d foot;
  std::int32_t triangle;
};

// Returns, for each point, its nearest point on the triangles.
std::vector<FootPoint> feetOf(const std::vector<Vector3d>& points, const TriMesh& mesh) {
  const NearestTriangle nearest(mesh.vertices, mesh.triangles);
  std::vector<FootPoint> feet(points.size());
  parallelBlocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::int32_t hint = -1;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = nearest.query(points[i], HUGE_VAL, 0, hint);
      const Foot foot = footOnTriangle(points[i], mesh, hint);
      feet[i] = {std::sqrt(squared), static_cast<std::uint32_t>(i), foot.point, hint};
    }
  });
  return feet;
}

// Returns whether the surface of the swept volume passes the ball.
bool passes(const SweptInterior& sweep, const Vector3d& centre, const Vector3d& along,
            double radius) {
  const bool inside = sweep.contains(centre + radius * along);
  if (sweep.contains(centre - radius * along) != inside) return true;
  // The corners and the middles of the faces of a cube, for places at sharp edges.
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Vector3d to(x, y, z);
        if (std::abs(x) + std::abs(y) + std::abs(z) == 2 || to.isZero()) continue;
        if (sweep.contains(centre + radius * to.normalized()) != inside) return true;
      }
    }
  }
  return false;
}

// Lowers the distance of a foot point to the distance of the swept volume's surface from there.
void examine(FootPoint& foot, const Vector3d& point, const SweptInterior& sweep, double accuracy) {
  const Vector3d along = (point - foot.foot).normalized();
  for (double radius = accuracy; radius < foot.distance; radius *= 2) {
    if (!passes(sweep, foot.foot, along, radius)) continue;
    foot.distance = radius;
    break;
  }
}

}  // namespace

double farthestMesh(const std::vector<Vector3d>& points, double tolerance) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  return std::max(tolerance, kCoarseMesh * box.diagonal().norm());
}

SweepDeviation sweepDeviation(const TriMesh& solid, const std::vector<Vector3d>& points,
                              const SweptInterior& sweep, double accuracy, double tolerance) {
  if (points.empty()) return {};
  std::vector<FootPoint> feet = feetOf(points, solid);
  std::sort(feet.begin(), feet.end(), [](const FootPoint& a, const FootPoint& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.point < b.point;
  });
  const auto tenth = static_cast<std::size_t>(kMaxFraction * static_cast<double>(feet.size()));
  const double meshError = feet[tenth].distance;
  if (meshError > farthestMesh(points, tolerance)) return {feet.front().distance, meshError};
  const std::size_t most = std::min(feet.size(), kMaxExamined);
  double examinedLargest = 0;
  std::size_t begin = 0, count = kFirstExamined;
  while (begin < most && feet[begin].distance > examinedLargest) {
    const std::size_t end = std::min(most, begin + count);
    count = std::min(2 * count, kExaminedAtOnce);
    // Smaller distances than the largest one so far do not matter.
    const double least = std::max(accuracy, examinedLargest);
    parallelBlocks(end - begin, 16, [&](std::size_t from, std::size_t until) {
      for (std::size_t i = begin + from; i < begin + until; ++i)
        examine(feet[i], points[feet[i].point], sweep, least);
    });
    for (; begin < end; ++begin) examinedLargest = std::max(examinedLargest, feet[begin].distance);
  }
  const double rest = begin < feet.size() ? feet[begin].distance : 0;
  return {std::max(examinedLargest, rest), meshError};
}

std::vector<FarFoot> feetBeyond(const TriMesh& solid, const std::vector<Vector3d>& points,
                                const SweptInterior& sweep, double accuracy, double tolerance) {
  std::vector<FootPoint> feet = feetOf(points, solid);
  std::erase_if(feet, [&](const FootPoint& foot) { return foot.distance <= tolerance; });
  parallelBlocks(feet.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      examine(feet[i], points[feet[i].point], sweep, accuracy);
  });
  std::vector<FarFoot> result;
  for (const FootPoint& foot : feet) {
    if (foot.distance > tolerance) result.push_back({foot.foot, solid.faceOf[foot.triangle]});
  }
  return result;
}

}  // namespace swept::step
