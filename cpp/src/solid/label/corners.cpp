// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <map>

#include "solid/label/label_steps.h"

namespace swept::step {
namespace {

class Corners : LabelTools {
 public:
  using LabelTools::LabelTools;

  // Three regions that meet at a vertex of the mesh need a common point of their carriers. If there
  // is none, the shortest of the three borders does not exist: the third region covers it.
  bool coverShortBorders() {
    return anyVertex([this](std::int32_t h) { return coverAt(h); });
  }

  bool coverAt(std::int32_t first) {
    std::vector<std::int32_t> borders;
    std::int32_t h = first;
    do {
      if (isBorder(h)) borders.push_back(h);
      h = mesh_.opposite[HalfEdgeMesh::previous(h)];
    } while (h != first);
    if (borders.size() == 4) return partAt(borders);
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
    if (shortest.size() > kLongestCover) return false;
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

  // Four regions rarely meet at one point. Unless they do, makes those two neighbours that have a
  // common point with each of the other two.
  bool partAt(const std::vector<std::int32_t>& borders) {
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
};

// Opens labelled ground.
class Opener : LabelTools {
 public:
  using LabelTools::LabelTools;

  void open(const std::vector<OpenSpot>& spots) {
    double widest = 0;
    for (const OpenSpot& spot : spots) widest = std::max(widest, spot.radius * spacing_);
    const auto keyOf = [&](const Vector3d& p) {
      Key key{};
      for (int k = 0; k < 3; ++k) key[k] = static_cast<std::int64_t>(std::floor(p[k] / widest));
      return key;
    };
    std::map<Key, std::vector<const OpenSpot*>> byCell;
    for (const OpenSpot& spot : spots) byCell[keyOf(spot.at)].push_back(&spot);
    const auto isNear = [&](const Vector3d& p) {
      const Key key = keyOf(p);
      for (int n = 0; n < 27; ++n) {
        const auto cell =
            byCell.find({key[0] + n % 3 - 1, key[1] + n / 3 % 3 - 1, key[2] + n / 9 - 1});
        if (cell == byCell.end()) continue;
        for (const OpenSpot* spot : cell->second) {
          if ((spot->at - p).norm() <= spot->radius * spacing_) return true;
        }
      }
      return false;
    };
    for (std::size_t t = 0; t < of_.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      if (isNear((mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3)) of_[t] = kNone;
    }
    openSpecks();
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  static constexpr std::size_t kSpeck = 12;

  // A speck beside open ground has more border than it is worth.
  void openSpecks() {
    const Regions all = regions();
    for (const auto& members : all.triangles) {
      if (members.size() > kSpeck || of_[members.front()] < 0) continue;
      const bool besideOpen = std::any_of(members.begin(), members.end(), [&](std::int32_t t) {
        const auto around = mesh_.neighbours(t);
        return std::any_of(around.begin(), around.end(),
                           [&](std::int32_t other) { return of_[other] < 0; });
      });
      if (!besideOpen) continue;
      for (const std::int32_t t : members) of_[t] = kNone;
    }
  }
};

}  // namespace

bool mendCorners(Labels& labels) { return Corners(labels).coverShortBorders(); }

void openGround(const std::vector<OpenSpot>& spots, Labels& labels) {
  if (!spots.empty()) Opener(labels).open(spots);
}

}  // namespace swept::step
