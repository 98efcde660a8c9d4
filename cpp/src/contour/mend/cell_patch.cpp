// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/cell_patch.h"

#include <algorithm>
#include <map>

#include "contour/mend/ring_sides.h"
#include "geometry/flat_polygons.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

using Triangle = std::array<std::int32_t, 3>;

/// Sizes of the innermost and the outermost copy of the cell at which rings end (fractions of the
/// cell).
constexpr double kInnerCopy = 0.05, kOuterCopy = 0.1;
/// Distance that the common point of all rings keeps from the walls (cells).
constexpr double kCentreMargin = 0.2;

class Patcher {
 public:
  Patcher(const std::vector<CellRing>& rings, const std::vector<PatchRing>& points)
      : rings_(rings), points_(points) {
    std::int32_t count = 0;
    for (const PatchRing& ring : points) {
      first_.push_back(count);
      count += static_cast<std::int32_t>(ring.points.size());
    }
    firstAdded_ = count;
  }

  /// Fills each ring by a fan about the n-th preferred position of its vertex. Returns false if
  /// fans intersect, or if a ring has no n-th position.
  bool fans(std::size_t n) {
    patch_ = {};
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (points_[r].vertices.size() <= n) return false;
      const std::int32_t vertex = add(r, points_[r].vertices[n]);
      forSides(r, [&](std::int32_t a, std::int32_t b, std::int8_t slot) {
        emit({vertex, a, b}, slot);
      });
    }
    return rings_.size() == 1 || areApart();
  }

  void layers(const Cell& cell, const Crossing* crossings, const CellBox& box) {
    patch_ = {};
    patch_.layered = true;
    const RingSides sides(cell, crossings, rings_);
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const PatchRing& ring : points_) {
      for (const Eigen::Vector3d& p : ring.points) centre += box.toLocal(p) / firstAdded_;
    }
    centre = centre.cwiseMax(kCentreMargin).cwiseMin(1 - kCentreMargin);
    const Nesting nesting = sides.nesting();
    const int most = *std::max_element(nesting.height.begin(), nesting.height.end());
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const double scale =
          kOuterCopy - (kOuterCopy - kInnerCopy) * (nesting.height[r] - 1) / std::max(1, most);
      fill(r, sides, nesting.left[r], [&](const Eigen::Vector3d& local) {
        return add(r, box.toWorld(centre + scale * (local - centre)));
      });
    }
  }

  CellPatch take() { return std::move(patch_); }

 private:
  template <class Use>
  void forSides(std::size_t r, const Use& use) const {
    const auto n = static_cast<std::int32_t>(points_[r].points.size());
    for (std::int32_t k = 0; k < n; ++k) {
      // Even k: the side from a crossing to the point on its chord. Odd k: the side from this point
      // to the next crossing.
      const std::size_t slot = static_cast<std::size_t>((k + 1) / 2) % rings_[r].slots.size();
      use(first_[r] + k, first_[r] + (k + 1) % n, rings_[r].slots[slot]);
    }
  }
  std::int32_t add(std::size_t ring, const Eigen::Vector3d& point) {
    patch_.added.push_back(point);
    patch_.ringOf.push_back(ring);
    return firstAdded_ + static_cast<std::int32_t>(patch_.added.size()) - 1;
  }
  void emit(const Triangle& triangle, std::int8_t slot) {
    patch_.triangles.push_back(triangle);
    patch_.slotOf.push_back(slot);
  }

  const Eigen::Vector3d& at(std::int32_t number) const {
    if (number >= firstAdded_) return patch_.added[number - firstAdded_];
    const std::size_t r =
        std::upper_bound(first_.begin(), first_.end(), number) - first_.begin() - 1;
    return points_[r].points[number - first_[r]];
  }

  /// Returns whether the triangles of different rings do not touch. Two rings share no corner, so
  /// any contact is an intersection.
  bool areApart() const {
    std::vector<Corners> corners;
    std::vector<std::int32_t> ringOf;
    for (const Triangle& t : patch_.triangles) {
      corners.push_back({&at(t[0]), &at(t[1]), &at(t[2])});
      ringOf.push_back(t[0]);  // the fan's vertex
    }
    for (std::size_t t = 0; t < corners.size(); ++t) {
      for (std::size_t u = t + 1; u < corners.size(); ++u) {
        if (ringOf[t] != ringOf[u] && trianglesMeet(corners[t], corners[u])) return false;
      }
    }
    return true;
  }

  /// Connects a ring with its small copy by triangles. Closes the copy with that part of the small
  /// cell's walls that lies on one side of the copy.
  template <class Copy>
  void fill(std::size_t r, const RingSides& sides, bool left, const Copy& copy) {
    const std::vector<Eigen::Vector3d> walls = sides.wallPoints(r);
    std::map<std::int32_t, std::int32_t> copies;
    const auto copyOf = [&](std::int32_t wall) {
      const auto [found, isNew] = copies.try_emplace(wall, 0);
      if (isNew) found->second = copy(walls[wall]);
      return found->second;
    };
    forSides(r, [&](std::int32_t a, std::int32_t b, std::int8_t slot) {
      const std::int32_t p = copyOf(a - first_[r]), q = copyOf(b - first_[r]);
      emit({a, b, q}, slot);
      emit({a, q, p}, slot);
    });
    std::vector<Triangle> triangles;
    for (const RingSides::Piece& piece : sides.pieces(r, left)) {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      normal[piece.face >> 1] = (piece.face & 1) != 0 ? 1 : -1;
      cutIntoTriangles({piece.corners}, walls, normal, triangles);
    }
    for (Triangle& t : triangles) {
      for (std::int32_t& v : t) v = copyOf(v);
      if (!left) std::swap(t[1], t[2]);
      emit(t, rings_[r].slots.front());
    }
  }

  const std::vector<CellRing>& rings_;
  const std::vector<PatchRing>& points_;
  std::vector<std::int32_t> first_;
  std::int32_t firstAdded_;
  CellPatch patch_;
};

}  // namespace

CellPatch patchOf(const Cell& cell, const Crossing* crossings, const std::vector<CellRing>& rings,
                  const std::vector<PatchRing>& points, const CellBox& box) {
  if (rings.empty()) return {};
  Patcher patcher(rings, points);
  std::size_t most = 0;
  for (const PatchRing& ring : points) most = std::max(most, ring.vertices.size());
  for (std::size_t n = 0; n < most; ++n) {
    if (patcher.fans(n)) return patcher.take();
  }
  patcher.layers(cell, crossings, box);
  return patcher.take();
}

}  // namespace swept
