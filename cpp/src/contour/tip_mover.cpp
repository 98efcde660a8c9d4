// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/tip_mover.h"

#include <algorithm>
#include <memory>
#include <unordered_set>

#include "base/parallel.h"
#include "contour/components.h"
#include "grid/marked_edges.h"

namespace swept {
namespace {

/// Returns the cell at `at`, with the crossings found by binary search in the edge lists. A cell
/// without crossings or outside the grid has the mask 0.
Cell gatherCell(const HermiteGrid& grid, const Eigen::Vector3i& at) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (at[axis] < 0 || at[axis] + 1 >= grid.plan.points[axis]) return cell;
  }
  cell.k = static_cast<std::uint16_t>(at[2]);
  for (int axis = 0; axis < 3; ++axis) {
    for (int ob = 0; ob < 2; ++ob) {
      for (int oc = 0; oc < 2; ++oc) {
        Eigen::Vector3i low = at;
        low[(axis + 1) % 3] += ob;
        low[(axis + 2) % 3] += oc;
        const HermiteLayer& layer = grid.layers[low[0]];
        const HermiteEdge* edge =
            findEdge(layer.edges[axis], layer.columnStart[axis], low[1], low[2]);
        if (edge == nullptr) continue;
        const int number = edgeOf(axis, ob, oc);
        cell.mask |= static_cast<std::uint32_t>(edge->sides) << (2 * number);
        cell.first[number] = edge->first;
      }
    }
  }
  return cell;
}

class TipMover {
 public:
  TipMover(const HermiteGrid& grid, ComponentMethod method, DualSurface& surface)
      : grid_(grid), method_(method), surface_(surface) {}

  void move(const std::vector<std::vector<Escape>>& escapes) {
    std::vector<std::vector<Proposal>> byLayer(escapes.size());
    parallelFor(escapes.size(), [&](std::size_t layer) {
      const auto finder = std::make_unique<ComponentFinder>(method_);
      for (const Escape& escape : escapes[layer]) {
        propose(static_cast<std::uint32_t>(layer), escape, *finder, byLayer[layer]);
      }
    });
    std::vector<Proposal> proposals;
    for (const auto& part : byLayer) proposals.insert(proposals.end(), part.begin(), part.end());
    std::stable_sort(proposals.begin(), proposals.end(), [](const Proposal& x, const Proposal& y) {
      for (int axis = 0; axis < 3; ++axis) {
        if (x.cell[axis] != y.cell[axis]) return x.cell[axis] < y.cell[axis];
      }
      if (x.corner != y.corner) return x.corner;
      return x.distance < y.distance;
    });
    // First moves the vertices whose own planes meet outside their cell. Then moves other vertices
    // to points at which the planes of a neighbouring vertex meet.
    std::unordered_set<std::uint64_t> moved;
    for (const bool own : {true, false}) {
      std::size_t group = 0;  // index of the first proposal for the same cell
      for (std::size_t n = 0; n < proposals.size(); ++n) {
        if (proposals[n].cell != proposals[group].cell) group = n;
        if (proposals[n].own == own) accept(proposals, group, n, moved);
      }
    }
  }

 private:
  struct Proposal {
    Eigen::Vector3i cell;
    double distance;  // cells, from the mass point to `point`
    std::uint32_t layer, vertex;
    Eigen::Vector3d point;  // grid coordinates
    bool own;     // true: the vertex's own planes meet at `point`; false: a neighbour's planes do
    bool corner;  // three planes meet at `point`; corners are accepted before creases
    bool accepted = false;
  };
  void accept(std::vector<Proposal>& proposals, std::size_t group, std::size_t n,
              std::unordered_set<std::uint64_t>& moved) {
    Proposal& proposal = proposals[n];
    const auto key = static_cast<std::uint64_t>(proposal.layer) << 32 | proposal.vertex;
    if (moved.contains(key)) return;
    for (std::size_t m = group; m < proposals.size() && proposals[m].cell == proposal.cell; ++m) {
      if (proposals[m].accepted && (proposals[m].point - proposal.point).norm() <= kMinDistance)
        return;
    }
    proposal.accepted = true;
    moved.insert(key);
    DualVertex& v = surface_.vertices[proposal.layer][proposal.vertex];
    v.local = (proposal.point - Eigen::Vector3d(v.i, v.j, v.k)).cast<float>();
  }

  /// Smallest distance (cells) between two vertices that move into one cell. Vertices nearer than
  /// this count as the same point of a crease.
  static constexpr double kMinDistance = 0.1;

  void propose(std::uint32_t layer, const Escape& escape, ComponentFinder& finder,
               std::vector<Proposal>& out) {
    if (escape.error > kMaxPlaneError || escape.planes.sharpness() < kMinTipSharpness) return;
    const DualVertex& v = surface_.vertices[layer][escape.vertex];
    const Eigen::Vector3i own(v.i, v.j, v.k);
    const Eigen::Vector3d direction = escape.to - escape.from;
    const Eigen::Vector3i target = own + escape.to.array().floor().matrix().cast<int>();
    const Eigen::Vector3d point = escape.to + own.cast<double>();
    const double count = escape.planes.count();
    const bool corner =
        escape.planes.matrix().determinant() > kMinCornerDeterminant * count * count * count;
    const Cell cell = gatherCell(grid_, target);
    if (cell.mask != 0) {
      const auto [vertex, allPlanes] = findAgreeing(cell, target, point, finder);
      if (vertex == DualSurface::kNone) return;
      const DualVertex& neighbour = surface_.vertices[target[0]][vertex];
      const Eigen::Vector3d neighbourPosition =
          Eigen::Vector3d(neighbour.i, neighbour.j, neighbour.k) + neighbour.local.cast<double>();
      const double missed =
          escape.planes.error(neighbourPosition - own.cast<double>()) / escape.planes.count();
      if (missed > kMaxPlaneError) {
        if (!allPlanes) return;
        out.push_back({target, direction.norm(), static_cast<std::uint32_t>(target[0]), vertex,
                       point, false, corner});
      } else if ((neighbourPosition - point).norm() > kMinDistance) {
        // The neighbour's vertex lies on the same crease at another position, so this vertex may
        // move along the crease, too.
        out.push_back({target, direction.norm(), layer, escape.vertex, point, true, corner});
      }
      return;
    }
    // Sample the segment to the point. The samples may miss a cell that the segment only cuts at a
    // corner.
    constexpr int kSamples = 16;
    for (int s = 1; s < kSamples; ++s) {
      const Eigen::Vector3d x = escape.from + direction * (static_cast<double>(s) / kSamples);
      const Eigen::Vector3i step = x.array().floor().matrix().cast<int>();
      if (step == Eigen::Vector3i::Zero()) continue;
      const Cell passed = gatherCell(grid_, own + step);
      if (passed.mask != 0 &&
          findAgreeing(passed, own + step, point, finder).vertex == DualSurface::kNone) {
        return;
      }
    }
    out.push_back({target, direction.norm(), layer, escape.vertex, point, true, corner});
  }

  struct Agreement {
    std::uint32_t vertex = DualSurface::kNone;
    bool allPlanes = false;  // all planes of the component pass through the point
  };
  /// Finds the first component of a leaf cell whose planes agree with the point; `vertex` is kNone
  /// if no component agrees. The planes agree if all of them pass through the point. They also
  /// agree if some of them form a crease through the point and the point lies behind the others. In
  /// this case the crease ends in a corner inside this cell.
  Agreement findAgreeing(const Cell& cell, const Eigen::Vector3i& at, const Eigen::Vector3d& point,
                         ComponentFinder& finder) const {
    Components components;
    finder.find(cell, grid_.crossings.data(), components);
    const Eigen::Vector3d local = point - at.cast<double>();
    for (int c = 0; c < components.count; ++c) {
      Qef all, through;
      bool behind = true;
      std::uint32_t vertex = DualSurface::kNone;
      for (int slot = 0; slot < kSlots; ++slot) {
        if (components.of[slot] != c) continue;
        const Crossing& crossing = grid_.crossings[cell.crossing(slot)];
        const Eigen::Vector3d position = localPosition(slot >> 1, crossing.fraction);
        const Eigen::Vector3d normal = crossing.normal.cast<double>();
        const double distance = normal.dot(local - position);
        all.add(position, normal);
        if (distance * distance <= kMaxPlaneError) {
          through.add(position, normal);
        } else {
          behind &= distance < 0;
        }
        vertex = surface_.quads[cell.crossing(slot)][quadCorner(slot >> 1)];
      }
      if (all.error(local) <= kMaxPlaneError * all.count()) return {vertex, true};
      if (behind && through.count() > 1 && through.sharpness() >= kMinTipSharpness)
        return {vertex, false};
    }
    return {};
  }

  static constexpr double kMinTipSharpness = 0.05;  // two planes that differ by 26 degrees
  /// Smallest determinant of the mean normal tensor at a corner (0.037 at the corner of a cube).
  static constexpr double kMinCornerDeterminant = 1e-3;
  /// Largest mean squared distance of planes from a point (cells^2), equal to a distance of 0.01
  /// cells.
  static constexpr double kMaxPlaneError = 1e-4;

  const HermiteGrid& grid_;
  ComponentMethod method_;
  DualSurface& surface_;
};

}  // namespace

void moveTips(const HermiteGrid& grid, ComponentMethod method,
              const std::vector<std::vector<Escape>>& escapes, DualSurface& surface) {
  TipMover(grid, method, surface).move(escapes);
}

}  // namespace swept
