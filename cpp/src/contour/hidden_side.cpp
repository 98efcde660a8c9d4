// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/hidden_side.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "contour/qef.h"

namespace swept {
namespace {

/// Two arcs count as flat if the sum of their unevenness() is at most this.
constexpr double kMaxFlatUnevenness = 2e-3;
/// Probe lines start this far outside the surface and end as far inside (cells).
constexpr double kLineOvershoot = 0.02;
/// A hit lies on a known side if the |cosine| between its normal and that of a crossing is above
/// this (20 degrees).
constexpr double kMinKnownCosine = 0.94;
/// Half the length (cells) of the line that checks whether a vertex lies on the surface.
constexpr double kCheckReach = 0.1;
/// The corner in which all planes meet may lie up to this far outside the cell (cells).
constexpr double kCornerReach = 1;
/// The line of kCheckReach must hit the surface within this distance of the vertex (cells).
constexpr double kMaxCheckMiss = 0.06;
/// Planes count as meeting in a point if they miss it by less than this (cells).
constexpr double kMaxPlaneMiss = 0.03;

using Point = CrossingPoint;
using Points = std::vector<Point>;

/// Returns the crossings of the component in the order of its ring. The polygons of two successive
/// crossings share an edge.
Points ringOf(const Cell& cell, const Components& components, int component,
              const Crossing* crossings) {
  const SlotLinks links = linkSlots(cell, crossings);
  Points ring;
  int slot = 0, before = -1;
  while (components.of[slot] != component) ++slot;
  const int first = slot;
  do {
    ring.push_back(Point::of(cell, slot, crossings));
    const int next = links.after(slot, before);
    before = slot;
    slot = next;
  } while (slot != first);
  return ring;
}

Qef planesOf(const Points& points) {
  Qef planes;
  for (const Point& p : points) planes.add(p.position, p.normal);
  return planes;
}

/// Returns whether the ring has crossings on both sides of a thin wall. The functions of wall_end.h
/// handle such rings.
bool hasOpposed(const Points& ring) {
  for (const Point& p : ring) {
    for (const Point& q : ring) {
      if (p.normal.dot(q.normal) < kMaxOpposedCosine) return true;
    }
  }
  return false;
}

/// Returns the mean of `count` successive crossings of the ring, starting with number `begin`.
Point mean(const Points& ring, std::size_t begin, std::size_t count) {
  Point m{-1, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (std::size_t n = begin; n < begin + count; ++n) {
    m.position += ring[n % ring.size()].position / static_cast<double>(count);
    m.normal += ring[n % ring.size()].normal;
  }
  m.normal.normalize();
  return m;
}
Point mean(const Points& points) { return mean(points, 0, points.size()); }

/// Returns how far `count` crossings of the ring, starting with number `begin`, are from lying in
/// one plane: the sum of the squared differences between their normals and heights and those of the
/// mean.
double unevenness(const Points& ring, std::size_t begin, std::size_t count) {
  const Point m = mean(ring, begin, count);
  double sum = 0;
  for (std::size_t n = begin; n < begin + count; ++n) {
    const Point& p = ring[n % ring.size()];
    const double offset = m.normal.dot(p.position - m.position);
    sum += (p.normal - m.normal).squaredNorm() + offset * offset;
  }
  return sum;
}

/// Cuts the ring into two arcs. The first has `count` crossings and starts with number `begin`.
std::array<Points, 2> arcsOf(const Points& ring, std::size_t begin, std::size_t count) {
  std::array<Points, 2> arcs;
  for (std::size_t n = 0; n < ring.size(); ++n) {
    arcs[n < count ? 0 : 1].push_back(ring[(begin + n) % ring.size()]);
  }
  return arcs;
}

/// Cuts the ring into two arcs with the least sum of unevenness; `least` receives this sum.
std::array<Points, 2> flattestArcs(const Points& ring, double& least) {
  std::size_t bestBegin = 0, bestCount = 1;
  least = std::numeric_limits<double>::max();
  for (std::size_t begin = 0; begin < ring.size(); ++begin) {
    for (std::size_t count = 1; begin + count < ring.size(); ++count) {
      const double sum =
          unevenness(ring, begin, count) + unevenness(ring, begin + count, ring.size() - count);
      if (sum >= least) continue;
      least = sum;
      bestBegin = begin;
      bestCount = count;
    }
  }
  return arcsOf(ring, bestBegin, bestCount);
}

/// Returns whether crossing `at` of the ring and the crossing before it lie in different planes, so
/// that an arc may begin at `at`.
bool beginsArc(const Points& ring, std::size_t at) {
  constexpr double kMinAlikeCosine = 0.98, kMaxLevelOffset = 0.05;  // cosine; cells
  const Point &p = ring[(at + ring.size() - 1) % ring.size()], &q = ring[at % ring.size()];
  const Eigen::Vector3d direction = q.position - p.position;
  return p.normal.dot(q.normal) < kMinAlikeCosine ||
         std::abs(p.normal.dot(direction)) > kMaxLevelOffset ||
         std::abs(q.normal.dot(direction)) > kMaxLevelOffset;
}

/// Looks for a known side: a third side between two arcs of the ring, whose plane is known from a
/// crossing of the ring. Tries all pairs of cuts at which an arc may begin (beginsArc()), and for
/// each pair the crossings at the ends of both arcs. The planes of each arc, together with the
/// plane of the crossing, must form an edge or corner within the cell. Returns the crossing with
/// the smallest error of these planes, and its arcs in `arcs`. Returns nothing if all errors are
/// too large.
std::optional<Point> bestKnownSide(const Points& ring, std::array<Points, 2>& arcs) {
  std::optional<Point> found;
  double least = kMaxPlaneMiss * kMaxPlaneMiss * static_cast<double>(ring.size());
  for (std::size_t begin = 0; begin < ring.size(); ++begin) {
    if (!beginsArc(ring, begin)) continue;
    for (std::size_t count = 1; begin + count < ring.size(); ++count) {
      if (!beginsArc(ring, begin + count)) continue;
      const std::array<Points, 2> parts = arcsOf(ring, begin, count);
      const std::array<Qef, 2> bare{planesOf(parts[0]), planesOf(parts[1])};
      for (const Point& side :
           {parts[0].front(), parts[0].back(), parts[1].front(), parts[1].back()}) {
        std::array<Qef, 2> planes{bare[0], bare[1]};
        for (Qef& part : planes) part.add(side.position, side.normal);
        if (planes[0].sharpness() < kMinSharpness || planes[1].sharpness() < kMinSharpness)
          continue;
        double error = 0;
        Eigen::Vector3d free;
        for (int n = 0; n < 2 && error < least; ++n) {
          error += planes[n].error(planes[n].solve(kCellMargin, free));
        }
        if (error >= least) continue;
        least = error;
        arcs = parts;
        found = side;
      }
    }
  }
  return found;
}

/// Drops the hits on known sides (sides with crossings of the ring). Returns the largest group of
/// the other hits with similar normals.
std::vector<ProbeLine> hitsOfNewSide(const Points& ring, const std::vector<ProbeLine>& lines) {
  std::vector<ProbeLine> fresh, best;
  for (const ProbeLine& line : lines) {
    // A line that starts inside hits the back of a known side, so the sign of the normal does not
    // matter.
    const auto isKnown = [&](const Point& p) {
      return std::abs(p.normal.dot(line.normal)) > kMinKnownCosine;
    };
    if (line.hit && std::none_of(ring.begin(), ring.end(), isKnown)) fresh.push_back(line);
  }
  for (const ProbeLine& p : fresh) {
    std::vector<ProbeLine> alike;
    std::copy_if(fresh.begin(), fresh.end(), std::back_inserter(alike),
                 [&](const ProbeLine& q) { return p.normal.dot(q.normal) > kMinKnownCosine; });
    if (alike.size() > best.size()) best = alike;
  }
  return best;
}

class Search {
 public:
  Search(const Cell& cell, const Eigen::Vector3i& at, const Points& ring, const SurfaceProbe& probe)
      : corner_(at.cast<double>()), probe_(probe) {
    for (const Point& p : ring) {
      crossings_.push_back(cell.crossing(p.slot));
      bounds_.extend(corner_ + p.position);
    }
  }

  /// Casts lines between the arcs, in both directions. Returns the lines with their first hits.
  std::vector<ProbeLine> between(const std::array<Points, 2>& arcs) const {
    std::vector<ProbeLine> lines;
    const auto add = [&](const Point& p, const Point& q) {
      lines.push_back(
          line(p.position + kLineOvershoot * p.normal, q.position - kLineOvershoot * q.normal));
      lines.push_back(
          line(q.position + kLineOvershoot * q.normal, p.position - kLineOvershoot * p.normal));
    };
    // The mean of a bent arc lies beside the surface, perhaps inside the solid. A line from such a
    // point proves nothing, so only the means of flat arcs are joined.
    constexpr double kMaxBent = 0.02;
    if (unevenness(arcs[0], 0, arcs[0].size()) < kMaxBent &&
        unevenness(arcs[1], 0, arcs[1].size()) < kMaxBent) {
      add(mean(arcs[0]), mean(arcs[1]));
    }
    add(arcs[0].front(), arcs[1].back());
    add(arcs[0].back(), arcs[1].front());
    cast(lines);
    return lines;
  }

  /// Returns whether the planes of the points and of the hits meet in one point on the surface. The
  /// point must lie in the cell, or at most `outside` cells away from the cell.
  bool meets(const Points& points, const std::vector<ProbeLine>& hits, double outside = 0) const {
    Qef planes = planesOf(points);
    Eigen::Vector3d direction = mean(points).normal, free;
    for (const ProbeLine& hit : hits) {
      planes.add(hit.point - corner_, hit.normal);
      direction += hit.normal / static_cast<double>(hits.size());
    }
    const Eigen::Vector3d best = planes.solve(kCellMargin, free);
    const Eigen::Vector3d vertex = outside == 0 ? best : free;
    if (vertex.minCoeff() < -outside || vertex.maxCoeff() > 1 + outside) return false;
    if (planes.error(vertex) > kMaxPlaneMiss * kMaxPlaneMiss * planes.count()) return false;
    direction.normalize();
    std::vector<ProbeLine> proof{
        line(vertex + kCheckReach * direction, vertex - kCheckReach * direction)};
    cast(proof);
    return proof[0].hit && (proof[0].point - corner_ - vertex).norm() < kMaxCheckMiss;
  }

 private:
  ProbeLine line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    ProbeLine line;
    line.from = corner_ + from;
    line.to = corner_ + to;
    return line;
  }

  void cast(std::vector<ProbeLine>& lines) const {
    Eigen::AlignedBox3d region = bounds_;
    for (const ProbeLine& l : lines) region.extend(l.from).extend(l.to);
    probe_.cast(region, crossings_, lines);
  }

  Eigen::Vector3d corner_;
  Eigen::AlignedBox3d bounds_;
  std::vector<std::uint32_t> crossings_;
  const SurfaceProbe& probe_;
};

void setParts(const std::array<Points, 2>& arcs, VertexSplit& out) {
  out.part.fill(-1);
  for (int n = 0; n < 2; ++n) {
    for (const Point& p : arcs[n]) out.part[p.slot] = static_cast<std::int8_t>(n);
  }
}

}  // namespace

bool findKnownSide(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                   int component, const Crossing* crossings, const SurfaceProbe& probe,
                   VertexSplit& out) {
  const Points ring = ringOf(cell, components, component, crossings);
  if (ring.size() < 3) return false;
  std::array<Points, 2> arcs;
  const auto known = bestKnownSide(ring, arcs);
  if (!known) return false;
  VertexSplit split;
  setParts(arcs, split);
  split.findFolds(cell, components, component, crossings);
  if (split.folds.empty()) return false;
  // If all planes meet in a corner, a vertex there is preferred to two vertices on edges, even if
  // the corner lies in the next cell.
  const Search search(cell, at, ring, probe);
  if (search.meets(ring, {}, kCornerReach)) return false;
  ProbeLine side;
  side.from = side.to = side.point = at.cast<double>() + known->position;
  side.normal = known->normal;
  split.between = {side};
  if (!search.meets(arcs[0], split.between) || !search.meets(arcs[1], split.between)) return false;
  split.seen = known->position;
  out = split;
  return true;
}

bool findHiddenSide(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                    int component, const Crossing* crossings, const SurfaceProbe& probe,
                    bool betweenPlanes, VertexSplit& out) {
  const Points ring = ringOf(cell, components, component, crossings);
  if (ring.size() < 3 || hasOpposed(ring)) return false;
  double uneven;
  std::array<Points, 2> arcs = flattestArcs(ring, uneven);
  if (betweenPlanes && uneven > kMaxFlatUnevenness) return false;
  const Search search(cell, at, ring, probe);
  out.between = hitsOfNewSide(ring, search.between(arcs));
  if (out.between.empty()) return false;
  const bool corner = search.meets(ring, out.between, kCornerReach);
  const std::array<bool, 2> meets{corner || search.meets(arcs[0], out.between),
                                  corner || search.meets(arcs[1], out.between)};
  if (!meets[0] && !meets[1]) return false;
  setParts(arcs, out);
  if (!corner && meets[0] && meets[1]) out.findFolds(cell, components, component, crossings);
  if (!out.folds.empty()) return true;
  for (auto& part : out.part) {
    const bool kept = part >= 0 && (corner || part == (meets[0] ? 0 : 1));
    part = kept ? 0 : -1;
  }
  return true;
}

}  // namespace swept
