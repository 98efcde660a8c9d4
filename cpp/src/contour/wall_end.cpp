// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/wall_end.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace swept {
namespace {

/// A crossing lies on a side if the |cosine| between its normal and the wall's is at least this (45
/// degrees).
constexpr double kMinSideCosine = 0.7;
/// A side is flat if the heights of its crossings differ by at most this (cells).
constexpr double kMaxUnevenness = 0.2;
/// Largest thickness of walls and gaps (cells); grid edges meet the rims of thicker ones.
constexpr double kMaxWallThickness = 1.0;
/// A hit lies on the rim, not on a side, if the |cosine| between its normal and the wall's is below
/// this (37 degrees).
constexpr double kMaxRimCosine = 0.8;

/// The middle plane of a wall, half way between its sides: normal . x = middle, in the coordinates
/// of the cell.
struct Wall {
  Eigen::Vector3d normal;
  double middle = 0;
};

/// Quick test that rejects nearly all components. Returns false if all normals are similar to the
/// first one, as on one side of a wall.
bool hasSpreadNormals(const Cell& cell, const Components& components, int component,
                      const Crossing* crossings) {
  Eigen::Vector3d first;
  bool any = false, found = false;
  for (std::uint32_t left = cell.mask; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    if (components.of[slot] != component) continue;
    const Eigen::Vector3d normal = crossings[cell.crossing(slot)].normal.cast<double>();
    if (!any) first = normal;
    any = true;
    found |= first.dot(normal) < 0.3;
  }
  return found;
}

/// Returns the direction across the wall, or nothing if no two normals of the component are
/// opposed.
std::optional<Eigen::Vector3d> directionAcross(const std::vector<CrossingPoint>& points) {
  double least = kMaxOpposedCosine;
  std::optional<Eigen::Vector3d> best;
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t q = p + 1; q < points.size(); ++q) {
      const double dot = points[p].normal.dot(points[q].normal);
      if (dot >= least) continue;
      least = dot;
      best = (points[p].normal - points[q].normal).normalized();
    }
  }
  return best;
}

/// Assigns the crossings to the two sides. Returns nothing if the sides do not form a thin, nearly
/// flat wall.
std::optional<Wall> assignSides(const std::vector<CrossingPoint>& points,
                                const Eigen::Vector3d& normal, VertexSplit& out) {
  std::array<double, 2> sum{0, 0}, low{1e9, 1e9}, high{-1e9, -1e9};
  std::array<int, 2> count{0, 0};
  out.part.fill(-1);
  for (const CrossingPoint& p : points) {
    const double along = p.normal.dot(normal), offset = p.position.dot(normal);
    if (std::abs(along) < kMinSideCosine) continue;
    const int s = along > 0 ? 0 : 1;
    out.part[p.slot] = static_cast<std::int8_t>(s);
    sum[s] += offset;
    ++count[s];
    low[s] = std::min(low[s], offset);
    high[s] = std::max(high[s], offset);
  }
  if (count[0] == 0 || count[1] == 0) return std::nullopt;
  if (high[0] - low[0] > kMaxUnevenness || high[1] - low[1] > kMaxUnevenness) return std::nullopt;
  const double top = sum[0] / count[0], bottom = sum[1] / count[1];
  if (std::abs(top - bottom) > kMaxWallThickness) return std::nullopt;
  return Wall{normal, (top + bottom) / 2};
}

/// Returns for each corner of the cell (number x + 2 y + 4 z) whether it lies outside. Both ends of
/// an edge without a crossing lie on the same side of the surface.
std::array<bool, 8> outsideCorners(const Cell& cell) {
  std::array<std::int8_t, 8> sign;  // 1 outside, 0 inside, -1 not known yet
  sign.fill(-1);
  for (int edge = 0; edge < kEdges; ++edge) {
    if (!cell.has(2 * edge) && !cell.has(2 * edge + 1)) continue;
    for (const int end : {0, 1}) sign[cornerOf(edge, end)] = cell.has(2 * edge + end) ? 1 : 0;
  }
  for (int round = 0; round < 3; ++round) {  // passes known signs along edges without a crossing
    for (int edge = 0; edge < kEdges; ++edge) {
      const int low = cornerOf(edge, 0), high = cornerOf(edge, 1);
      if (cell.has(2 * edge) || cell.has(2 * edge + 1)) continue;
      if (sign[low] < 0) sign[low] = sign[high];
      if (sign[high] < 0) sign[high] = sign[low];
    }
  }
  std::array<bool, 8> outside;
  for (int corner = 0; corner < 8; ++corner) outside[corner] = sign[corner] != 0;
  return outside;
}

/// Collects the points where the middle plane of the wall cuts the edges of the cell: those outside
/// the swept volume in `outside`, the others in `inside`.
void cutEdges(const Cell& cell, const Wall& wall, const Crossing* crossings,
              std::vector<Eigen::Vector3d>& outside, std::vector<Eigen::Vector3d>& inside) {
  const std::array<bool, 8> out = outsideCorners(cell);
  for (int edge = 0; edge < kEdges; ++edge) {
    const Eigen::Vector3d low = localPosition(edge, 0), high = localPosition(edge, 1);
    const double dl = wall.normal.dot(low) - wall.middle, dh = wall.normal.dot(high) - wall.middle;
    if ((dl > 0) == (dh > 0)) continue;
    const double x = dl / (dl - dh);
    const bool hasLow = cell.has(2 * edge), hasHigh = cell.has(2 * edge + 1);
    bool isOut = out[cornerOf(edge, 0)];
    if (hasLow || hasHigh) {
      isOut = (hasLow && x < crossings[cell.crossing(2 * edge)].fraction) ||
              (hasHigh && x > crossings[cell.crossing(2 * edge + 1)].fraction);
    }
    (isOut ? outside : inside).push_back(low + x * (high - low));
  }
}

}  // namespace

bool findWallEnd(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                 int component, const Crossing* crossings, const SurfaceProbe& probe,
                 VertexSplit& out) {
  if (!hasSpreadNormals(cell, components, component, crossings)) return false;
  std::vector<CrossingPoint> points;
  std::vector<std::uint32_t> indices;
  for (int slot = 0; slot < kSlots; ++slot) {
    if (components.of[slot] != component) continue;
    indices.push_back(cell.crossing(slot));
    points.push_back(CrossingPoint::of(cell, slot, crossings));
  }
  const auto normal = directionAcross(points);
  if (!normal) return false;
  const auto wall = assignSides(points, *normal, out);
  if (!wall) return false;
  std::vector<Eigen::Vector3d> outside, inside;
  cutEdges(cell, *wall, crossings, outside, inside);
  std::vector<ProbeLine> lines;
  const Eigen::Vector3d corner = at.cast<double>();
  for (const auto& from : outside) {
    for (const auto& to : inside) {
      ProbeLine line;
      line.from = corner + from;
      line.to = corner + to;
      lines.push_back(line);
    }
  }
  if (lines.empty()) return false;
  probe.cast({corner, corner + Eigen::Vector3d::Ones()}, indices, lines);
  for (const ProbeLine& line : lines) {
    const bool isRim = line.hit && std::abs(line.normal.dot(wall->normal)) < kMaxRimCosine;
    if (isRim) out.between.push_back(line);
  }
  if (out.between.empty()) return false;
  out.findFolds(cell, components, component, crossings);
  if (out.folds.empty()) {
    for (int slot = 0; slot < kSlots; ++slot) {
      out.part[slot] = components.of[slot] == component ? 0 : -1;
    }
  }
  return true;
}

}  // namespace swept
