// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/flat_polygons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace swept {
namespace {

using Point = Eigen::Vector2d;

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// A corner of a loop: the index of its point, and the coordinates of the point in the plane.
struct Corner {
  std::int32_t vertex;
  Point at;
};
using Polygon = std::vector<Corner>;

double areaOf(const Polygon& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += turn(polygon[0].at, polygon[i].at, polygon[(i + 1) % polygon.size()].at);
  return 0.5 * area;
}

bool contains(const Polygon& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i].at, &b = polygon[j].at;
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

/// Returns whether two segments cross or an end of one lies on the other. Also returns true for all
/// segments on one line, and false for segments with a common end.
bool segmentsCross(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (a == c || a == d || b == c || b == d) return false;
  const double c1 = turn(a, b, c), d1 = turn(a, b, d), a1 = turn(c, d, a), b1 = turn(c, d, b);
  return ((c1 >= 0) != (d1 > 0) || (c1 > 0) != (d1 >= 0)) &&
         ((a1 >= 0) != (b1 > 0) || (a1 > 0) != (b1 >= 0));
}

/// Joins a hole to its polygon along the shortest candidate line that crosses neither of them. If
/// there is no such line, takes the shortest candidate.
void joinHole(Polygon& polygon, const Polygon& hole) {
  struct Bridge {
    double length;
    std::size_t outer, inner;
  };
  // Candidates: lines from the corner of the hole farthest towards +x to each corner of the
  // polygon, the shortest first.
  std::size_t start = 0;
  for (std::size_t k = 1; k < hole.size(); ++k)
    if (hole[k].at.x() > hole[start].at.x()) start = k;
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    bridges.push_back({(polygon[i].at - hole[start].at).squaredNorm(), i, start});
  std::sort(bridges.begin(), bridges.end(), [](const Bridge& x, const Bridge& y) {
    return x.length != y.length ? x.length < y.length : x.outer < y.outer;
  });
  const auto isFree = [&](const Bridge& bridge) {
    const Point &a = polygon[bridge.outer].at, &b = hole[bridge.inner].at;
    for (const Polygon* loop : {static_cast<const Polygon*>(&polygon), &hole})
      for (std::size_t i = 0; i < loop->size(); ++i)
        if (segmentsCross(a, b, (*loop)[i].at, (*loop)[(i + 1) % loop->size()].at)) return false;
    // The line must lead from the polygon's corner into the polygon.
    const std::size_t n = polygon.size();
    const Point &before = polygon[(bridge.outer + n - 1) % n].at,
                &after = polygon[(bridge.outer + 1) % n].at;
    const bool left = turn(before, a, b) > 0, right = turn(a, after, b) > 0;
    return turn(before, a, after) > 0 ? left && right : left || right;
  };
  const auto found = std::find_if(bridges.begin(), bridges.end(), isFree);
  const Bridge bridge = found == bridges.end() ? bridges.front() : *found;
  Polygon joined(polygon.begin(), polygon.begin() + bridge.outer + 1);
  for (std::size_t k = 0; k <= hole.size(); ++k)
    joined.push_back(hole[(bridge.inner + k) % hole.size()]);
  joined.insert(joined.end(), polygon.begin() + bridge.outer, polygon.end());
  polygon = std::move(joined);
}

class EarClipper {
 public:
  EarClipper(const Polygon& polygon, double flat) : corners_(polygon), flat_(flat) {
    const std::size_t n = polygon.size();
    next_.resize(n);
    before_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      before_[i] = (i + n - 1) % n;
    }
  }

  void clip(std::vector<std::array<std::int32_t, 3>>& triangles) {
    std::size_t left = corners_.size(), at = 0, tried = 0;
    while (left > 3) {
      if (tried < left && !isEar(at)) {
        at = next_[at];
        ++tried;
        continue;
      }
      if (tried >= left) at = flattestCorner(at, left);
      emit(at, triangles);
      next_[before_[at]] = next_[at];
      before_[next_[at]] = before_[at];
      at = next_[next_[at]];  // skips a corner, because successive ears would form a fan of slivers
      --left;
      tried = 0;
    }
    emit(at, triangles);
  }

 private:
  void emit(std::size_t i, std::vector<std::array<std::int32_t, 3>>& triangles) const {
    triangles.push_back(
        {corners_[before_[i]].vertex, corners_[i].vertex, corners_[next_[i]].vertex});
  }
  double area(std::size_t i) const {
    return turn(corners_[before_[i]].at, corners_[i].at, corners_[next_[i]].at);
  }

  bool isEar(std::size_t i) const {
    if (area(i) <= flat_) return false;
    const Point &a = corners_[before_[i]].at, &b = corners_[i].at, &c = corners_[next_[i]].at;
    for (std::size_t k = next_[next_[i]]; k != before_[i]; k = next_[k]) {
      const Point& p = corners_[k].at;
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  /// Returns the corner with the smallest area, for a polygon in which rounding has left no ear.
  /// Cutting it off changes the polygon least.
  std::size_t flattestCorner(std::size_t at, std::size_t left) const {
    std::size_t best = at;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < left; ++k, at = next_[at])
      if (const double size = std::abs(area(at)); size < least) {
        least = size;
        best = at;
      }
    return best;
  }

  const Polygon& corners_;
  double flat_;
  std::vector<std::size_t> next_, before_;
};

}  // namespace

void cutIntoTriangles(const std::vector<Loop>& loops, const std::vector<Eigen::Vector3d>& points,
                      const Eigen::Vector3d& normal,
                      std::vector<std::array<std::int32_t, 3>>& triangles) {
  if (loops.size() == 1 && loops[0].size() == 3) {
    triangles.push_back({loops[0][0], loops[0][1], loops[0][2]});
    return;
  }
  // Projects along the coordinate axis nearest to the normal, seen from the side to which the
  // normal points.
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const bool reversed = normal[axis] < 0;
  std::vector<Polygon> outer, holes;
  double size = 0;
  for (const Loop& loop : loops) {
    Polygon polygon;
    for (const std::int32_t i : loop) {
      const Eigen::Vector3d p = points[i] - points[loops[0][0]];
      polygon.push_back({i, reversed ? Point(p[v], p[u]) : Point(p[u], p[v])});
      size = std::max(size, p.squaredNorm());
    }
    (areaOf(polygon) < 0 ? holes : outer).push_back(std::move(polygon));
  }
  constexpr double kFlat = 1e-14;
  // Without an outer loop, the loops are slivers whose orientation rounding has reversed.
  if (outer.empty()) outer.swap(holes);
  // Joins the holes from right to left, so that a hole can be joined to a hole farther right.
  const auto right = [](const Polygon& polygon) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Corner& corner : polygon) most = std::max(most, corner.at.x());
    return most;
  };
  std::stable_sort(holes.begin(), holes.end(),
                   [&](const Polygon& a, const Polygon& b) { return right(a) > right(b); });
  for (const Polygon& hole : holes) {
    std::size_t container = outer.size();
    for (std::size_t k = 0; k < outer.size(); ++k)
      if (contains(outer[k], hole[0].at) &&
          (container == outer.size() || areaOf(outer[k]) < areaOf(outer[container])))
        container = k;
    if (container == outer.size())
      outer.push_back(hole);  // a sliver whose orientation rounding has reversed
    else
      joinHole(outer[container], hole);
  }
  for (const Polygon& polygon : outer)
    if (polygon.size() >= 3) EarClipper(polygon, kFlat * size).clip(triangles);
}

}  // namespace swept
