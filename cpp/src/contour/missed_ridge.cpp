// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/missed_ridge.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace swept {
namespace {

constexpr double kSame = 0.94;     ///< cosine from which two normals are of one side
constexpr double kKnown = 0.9;     ///< cosine from which a hit tells nothing new
constexpr std::size_t kLeast = 3;  ///< hits on a side

struct Point {
  Eigen::Vector3d position, normal;
};
using Points = std::vector<Point>;

/// Takes out the points whose normals are like that of the one with the most of its kind.
Points takeLargestSide(Points& points) {
  const auto alike = [](const Point& p, const Point& q) { return p.normal.dot(q.normal) > kSame; };
  std::size_t most = 0;
  Point of = points.front();
  for (const Point& p : points) {
    const auto count = static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](const Point& q) { return alike(p, q); }));
    if (count <= most) continue;
    most = count;
    of = p;
  }
  const auto rest = std::stable_partition(points.begin(), points.end(),
                                          [&](const Point& q) { return !alike(of, q); });
  Points side(rest, points.end());
  points.erase(rest, points.end());
  return side;
}

/// The points sorted to sides of at least so many.
std::vector<Points> sidesOf(Points points, std::size_t least) {
  std::vector<Points> sides;
  while (!points.empty()) {
    sides.push_back(takeLargestSide(points));
    if (sides.back().size() < least) sides.pop_back();
  }
  return sides;
}

Point mean(const Points& side) {
  Point m{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const Point& p : side) {
    m.position += p.position / static_cast<double>(side.size());
    m.normal += p.normal;
  }
  m.normal.normalize();
  return m;
}

/// Neither lies above the other's plane.
bool isRidge(const Point& p, const Point& q) {
  return p.normal.dot(q.position - p.position) < 0 && q.normal.dot(p.position - q.position) < 0;
}

/// First hits from the outside corners of the cell towards points spread over it, `steps` along
/// each side, that show a side unknown so far.
Points probeCell(const Cell& cell, const Eigen::Vector3i& at,
                 const std::vector<std::uint32_t>& indices, const Points& known, int steps,
                 const SurfaceProbe& probe) {
  const std::array<bool, 8> outside = outsideCorners(cell);
  const Eigen::Vector3d low = at.cast<double>();
  std::vector<ProbeLine> lines;
  for (int corner = 0; corner < 8; ++corner) {
    if (!outside[corner]) continue;
    const Eigen::Vector3d from(corner & 1, corner >> 1 & 1, corner >> 2);
    for (int n = 0; n < steps * steps * steps; ++n) {
      const Eigen::Vector3d to(n % steps, n / steps % steps, n / (steps * steps));
      // Beyond the point, as far as the cell reaches.
      const Eigen::Vector3d way = (to.array() + 0.5).matrix() / steps - from;
      ProbeLine line;
      line.from = low + from;
      line.to = line.from + way / way.cwiseAbs().maxCoeff();
      lines.push_back(line);
    }
  }
  probe.cast(at, indices, lines);
  Points fresh;
  for (const ProbeLine& line : lines) {
    if (!line.hit) continue;
    const auto isKnown = [&](const Point& p) { return p.normal.dot(line.normal) > kKnown; };
    if (std::any_of(known.begin(), known.end(), isKnown)) continue;
    fresh.push_back({line.point - low, line.normal});
  }
  return fresh;
}

}  // namespace

bool findMissedRidge(const Cell& cell, const Eigen::Vector3i& at, const Crossing* crossings,
                     const SurfaceProbe& probe, Qef& ridge) {
  Points known;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t left = cell.mask; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    indices.push_back(cell.crossing(slot));
    const Crossing& crossing = crossings[indices.back()];
    known.push_back({localPosition(slot >> 1, crossing.fraction), crossing.normal.cast<double>()});
  }
  // A few lines tell most cells without a ledge.
  if (probeCell(cell, at, indices, known, 1, probe).empty()) return false;
  const std::vector<Points> ledges = sidesOf(probeCell(cell, at, indices, known, 3, probe), kLeast);
  if (ledges.empty()) return false;
  double least = kSame;  // the sharpest ridge is taken
  bool found = false;
  for (const Points& plane : sidesOf(std::move(known), 1)) {
    const Point p = mean(plane);
    for (const Points& ledge : ledges) {
      const Point q = mean(ledge);
      if (!isRidge(p, q) || p.normal.dot(q.normal) >= least) continue;
      Qef planes;
      for (const Point& x : plane) planes.add(x.position, x.normal);
      for (const Point& x : ledge) planes.add(x.position, x.normal);
      Eigen::Vector3d meeting;
      planes.solve(0, meeting);
      if (meeting.minCoeff() < 0 || meeting.maxCoeff() > 1) continue;
      least = p.normal.dot(q.normal);
      ridge = planes;
      found = true;
    }
  }
  return found;
}

}  // namespace swept
