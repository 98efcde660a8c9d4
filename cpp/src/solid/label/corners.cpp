// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <set>

#include "solid/label/label_steps.h"

namespace swept::step {
namespace {

class Corners : LabelTools {
 public:
  using LabelTools::LabelTools;

  // The carriers of three regions that meet at a vertex of the mesh should have a common point. If
  // they have none, two of the exact faces have no common border, and the shortest of the three
  // borders is an error of the labels. Gives the triangles along this border to the third region.
  bool removeShortBorders() {
    return anyVertex([this](std::int32_t h) { return removeShortBorderAt(h); });
  }

  bool removeShortBorderAt(std::int32_t first) {
    std::vector<std::int32_t> borders;
    std::int32_t h = first;
    do {
      if (isBorder(h)) borders.push_back(h);
      h = mesh_.opposite[HalfEdgeMesh::previous(h)];
    } while (h != first);
    if (borders.size() == 4) return separateAt(borders);
    if (borders.size() != 3) return false;
    const std::vector<std::int32_t> around{of_[borders[0] / 3], of_[borders[1] / 3],
                                           of_[borders[2] / 3]};
    if (*std::min_element(around.begin(), around.end()) < 0 || around[0] == around[1] ||
        around[1] == around[2] || around[0] == around[2] ||
        meetAll(mesh_.points[mesh_.origin(first)], around))
      return false;
    std::vector<std::int32_t> shortest;
    for (const std::int32_t border : borders) {
      std::vector<std::int32_t> chain = chainFrom(border);
      if (shortest.empty() || chain.size() < shortest.size()) shortest = std::move(chain);
    }
    if (shortest.size() > kMaxShortBorder) return false;
    std::int32_t third = kNone;
    for (const std::int32_t n : around) {
      if (n != of_[shortest.front() / 3] && n != of_[mesh_.opposite[shortest.front()] / 3])
        third = n;
    }
    std::vector<std::int32_t> taken;
    for (const std::int32_t e : shortest) {
      for (const std::int32_t t : {e / 3, mesh_.opposite[e] / 3}) {
        if (residual(t, third) > 2 * spacing_) return false;
        taken.push_back(t);
      }
    }
    for (const std::int32_t t : taken) of_[t] = third;
    return true;
  }

  // Four regions rarely meet at one point. If their carriers have no common point, two opposite
  // regions must be neighbours there. Makes neighbours of the pair whose carriers have a common
  // point with the carrier of each of the other two regions.
  bool separateAt(const std::vector<std::int32_t>& borders) {
    std::vector<std::int32_t> around;
    for (const std::int32_t h : borders) around.push_back(of_[h / 3]);
    if (*std::min_element(around.begin(), around.end()) < 0) return false;
    std::vector<std::int32_t> distinct = around;
    sortUnique(distinct);
    const Vector3d& at = mesh_.points[mesh_.origin(borders[0])];
    if (distinct.size() < 4 || meetAll(at, around)) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int32_t x = around[k], z = around[k + 2];
      if (!meetAll(at, {x, z, around[k + 1]}) || !meetAll(at, {x, z, around[(k + 3) % 4]}))
        continue;
      const auto first = fanFrom(borders[k + 1]), second = fanFrom(borders[(k + 3) % 4]);
      for (const std::int32_t t : first.size() <= second.size() ? first : second) of_[t] = x;
      return true;
    }
    return false;
  }

  // Removes the labels around vertices at which the carriers of the regions have no common point.
  // These triangles become facets.
  void unlabelBadCorners() {
    std::vector<char> bad(mesh_.points.size(), 0), seen(mesh_.points.size(), 0);
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const auto first = static_cast<std::int32_t>(h);
      const std::int32_t v = mesh_.origin(first);
      if (seen[v]) continue;
      seen[v] = 1;
      std::vector<std::int32_t> around;
      std::int32_t g = first;
      do {
        if (isBorder(g) && of_[g / 3] >= 0) around.push_back(of_[g / 3]);
        g = mesh_.opposite[HalfEdgeMesh::previous(g)];
      } while (g != first);
      sortUnique(around);
      bad[v] = around.size() > 2 && !meetAll(mesh_.points[v], around);
    }
    constexpr int kRings = 2;
    for (int ring = 0; ring < kRings; ++ring) {
      std::vector<char> next = bad;
      for (std::size_t t = 0; t < of_.size(); ++t) {
        const auto& tri = mesh_.triangles[t];
        if (!bad[tri[0]] && !bad[tri[1]] && !bad[tri[2]]) continue;
        of_[t] = kNone;
        for (const std::int32_t v : tri) next[v] = 1;
      }
      bad.swap(next);
    }
  }

  void unlabelAround(const std::vector<Vector3d>& open) {
    if (open.empty()) return;
    const double cell = 1.5 * spacing_;
    using Key = std::array<std::int64_t, 3>;
    const auto keyOf = [&](const Vector3d& p) {
      Key key{};
      for (int k = 0; k < 3; ++k) key[k] = static_cast<std::int64_t>(std::floor(p[k] / cell));
      return key;
    };
    std::set<Key> near;
    for (const Vector3d& p : open) {
      const Key key = keyOf(p);
      for (int n = 0; n < 27; ++n)
        near.insert({key[0] + n % 3 - 1, key[1] + n / 3 % 3 - 1, key[2] + n / 9 - 1});
    }
    for (std::size_t t = 0; t < of_.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const Vector3d centre = (mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3;
      if (near.count(keyOf(centre)) != 0) of_[t] = kNone;
    }
  }
};

}  // namespace

bool mendCorners(Labels& labels) { return Corners(labels).removeShortBorders(); }

void makeFacets(const std::vector<Eigen::Vector3d>& around, Labels& labels) {
  Corners corners(labels);
  corners.unlabelBadCorners();
  corners.unlabelAround(around);
}

}  // namespace swept::step
