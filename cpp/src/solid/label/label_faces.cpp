// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/label/label_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "solid/carrier/places.h"
#include "solid/label/swept_carriers.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kNone = -1;
/// mm: how exactly a point must lie on two carriers that meet.
constexpr double kMeet = 1e-5;

class Labeller {
 public:
  Labeller(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance, RunContext& run)
      : mesh_(mesh),
        origin_(origin),
        tolerance_(tolerance),
        run_(run),
        spacing_(spacingOf(mesh)),
        known_(*origin.shape, origin.trajectory, 4 * spacing_),
        of_(mesh.triangles.size(), kNone) {}

  Partition label(const std::vector<Vector3d>& open) {
    takeSources();
    known_.finish();
    run_.checkpoint(Phase::Export);
    for (int round = 0; round < kRounds; ++round) {
      const bool joined = joinSmall();
      const bool closed = closeStrips();
      const bool covered = coverShortBorders();
      const bool parted = untouch();
      if (!joined && !closed && !covered && !parted) break;
    }
    openBadCorners();
    openAround(open);
    untouch();
    return partition();
  }

 private:
  static constexpr int kRounds = 8;

  // Mean length of the edges of triangles.
  static double spacingOf(const HalfEdgeMesh& mesh) {
    return std::sqrt(2 * mesh.area / static_cast<double>(mesh.triangles.size()));
  }

  const Carrier& carrier(std::int32_t n) const { return known_.carriers()[n]; }
  double residual(std::int32_t t, std::int32_t n) const {
    return std::abs(carrier(n).distance(pointOf(t)));
  }
  const Vector3d& pointOf(std::int32_t t) const { return points_[t]; }

  void takeSources() {
    const std::vector<SurfaceSource>& rows = *origin_.sources.rows;
    std::vector<const std::vector<std::int32_t>*> allowed(mesh_.triangles.size(), nullptr);
    points_.resize(mesh_.triangles.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if ((t & 0xffffU) == 0) run_.checkpoint(Phase::Export);
      const std::uint32_t row = origin_.sources.of[t];
      const auto& [a, b, c] = mesh_.triangles[t];
      points_[t] = (mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3;
      if (row == Sources::kNone) continue;
      points_[t] = rows[row].point;
      allowed[t] = &known_.carriersOf(rows[row]);
    }
    const double limit = std::min(tolerance_, 3 * origin_.chordError + 0.02 * spacing_);
    parallelBlocks(allowed.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        if (allowed[t] == nullptr) continue;
        double smallest = limit;
        for (const std::int32_t n : *allowed[t]) {
          const double off = residual(static_cast<std::int32_t>(t), n);
          if (off >= smallest) continue;
          smallest = off;
          of_[t] = n;
        }
      }
    });
  }

  struct Regions {
    std::vector<std::int32_t> of;                      // by triangle
    std::vector<std::vector<std::int32_t>> triangles;  // by region
  };
  Regions regions() const {
    Regions found;
    found.of.assign(of_.size(), kNone);
    for (std::size_t first = 0; first < of_.size(); ++first) {
      if (found.of[first] >= 0) continue;
      const auto id = static_cast<std::int32_t>(found.triangles.size());
      std::vector<std::int32_t> members{static_cast<std::int32_t>(first)};
      found.of[first] = id;
      for (std::size_t i = 0; i < members.size(); ++i) {
        for (const std::int32_t t : mesh_.neighbours(members[i])) {
          if (found.of[t] >= 0 || of_[t] != of_[first]) continue;
          found.of[t] = id;
          members.push_back(t);
        }
      }
      found.triangles.push_back(std::move(members));
    }
    return found;
  }

  // Gives small regions to the neighbour that explains their points best, smallest first.
  bool joinSmall() {
    const Regions all = regions();
    std::vector<std::int32_t> order(all.triangles.size());
    for (std::size_t r = 0; r < order.size(); ++r) order[r] = static_cast<std::int32_t>(r);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return all.triangles[a].size() < all.triangles[b].size();
    });
    bool any = false;
    for (const std::int32_t r : order) {
      const auto& members = all.triangles[r];
      const bool open = of_[members.front()] < 0;
      if (members.size() > (open ? kMostOpen : kMostSmall)) continue;
      any = joinBest(members) || any;
    }
    return any;
  }

  static constexpr std::size_t kMostSmall = 400, kMostOpen = 2000, kSpeck = 6;

  bool joinBest(const std::vector<std::int32_t>& members) {
    const std::int32_t own = of_[members.front()];
    std::vector<std::int32_t> beside;
    for (const std::int32_t t : members) {
      for (const std::int32_t other : mesh_.neighbours(t)) {
        if (of_[other] >= 0 && of_[other] != own) beside.push_back(of_[other]);
      }
    }
    sortUnique(beside);
    std::int32_t best = kNone;
    // An island within another region is noise if that region explains it.
    if (beside.size() == 1 && own >= 0 && worstOff(members, beside[0]) <= tolerance_)
      best = beside[0];
    double smallest = own < 0 && members.size() <= kSpeck ? 1e300 : joinLimit();
    for (const std::int32_t n : beside) {
      const double worst = worstOff(members, n);
      if (worst >= smallest) continue;
      smallest = worst;
      best = n;
    }
    if (best < 0) return false;
    for (const std::int32_t t : members) of_[t] = best;
    return true;
  }
  double worstOff(const std::vector<std::int32_t>& members, std::int32_t n) const {
    double worst = 0;
    for (const std::int32_t t : members) worst = std::max(worst, residual(t, n));
    return worst;
  }
  double joinLimit() const { return std::min(0.5 * tolerance_, 0.3 * spacing_); }

  bool mayJoin(std::int32_t t, std::int32_t n) const {
    return n >= 0 && residual(t, n) <= spacing_;
  }

  // Where a region meets itself at a vertex, another one lies between. Gives that to the region if
  // it is near its carrier, the smallest fan of triangles first. So narrow strips become connected,
  // and borders do not touch themselves.
  bool untouch() {
    bool changed = false;
    std::vector<char> seen(mesh_.points.size(), 0);
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const std::int32_t v = mesh_.origin(static_cast<std::int32_t>(h));
      if (seen[v]) continue;
      seen[v] = 1;
      changed = untouchAt(static_cast<std::int32_t>(h)) || changed;
    }
    return changed;
  }

  bool untouchAt(std::int32_t first) {
    // Fans of equal carriers around the vertex, in order.
    std::vector<std::vector<std::int32_t>> fans;
    std::int32_t h = first;
    do {
      const std::int32_t t = h / 3;
      if (fans.empty() || of_[fans.back().front()] != of_[t]) fans.emplace_back();
      fans.back().push_back(t);
      h = mesh_.opposite[HalfEdgeMesh::previous(h)];
    } while (h != first);
    if (fans.size() > 1 && of_[fans.front().front()] == of_[fans.back().front()]) {
      fans.front().insert(fans.front().begin(), fans.back().begin(), fans.back().end());
      fans.pop_back();
    }
    const std::size_t count = fans.size();
    if (count < 4) return false;
    std::size_t best = count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t around = of_[fans[(i + 1) % count].front()];
      if (around != of_[fans[(i + count - 1) % count].front()]) continue;
      if (best < count && fans[i].size() >= fans[best].size()) continue;
      const bool near = std::all_of(fans[i].begin(), fans[i].end(),
                                    [&](std::int32_t t) { return mayJoin(t, around); });
      if (near) best = i;
    }
    if (best == count) return false;
    const std::int32_t around = of_[fans[(best + 1) % count].front()];
    for (const std::int32_t t : fans[best]) of_[t] = around;
    return true;
  }

  // Two regions can only meet where their carriers do. If they do not, a narrow strip lies between
  // them that has too few crossings to be connected. Gives the triangles along the border to it.
  bool closeStrips() {
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> borders;
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const std::int32_t a = of_[h / 3], b = of_[mesh_.opposite[h] / 3];
      if (a >= 0 && b > a) borders[{a, b}].push_back(static_cast<std::int32_t>(h));
    }
    bool changed = false;
    for (const auto& [pair, halfEdges] : borders) {
      for (const std::int32_t h : halfEdges) {
        const Vector3d middle =
            (mesh_.points[mesh_.origin(h)] + mesh_.points[mesh_.target(h)]) / 2;
        if (meet(middle, pair.first, pair.second)) continue;
        const std::int32_t between = strip(h, middle, pair.first, pair.second);
        if (between < 0) continue;
        for (const std::int32_t t : {h / 3, mesh_.opposite[h] / 3}) of_[t] = between;
        changed = true;
      }
    }
    return changed;
  }

  bool meet(const Vector3d& near, std::int32_t a, std::int32_t b) const {
    // Newton's method is not needed where two near surfaces clearly cross.
    constexpr double kClearly = 0.3;
    if (std::max(std::abs(carrier(a).distance(near)), std::abs(carrier(b).distance(near))) <
            0.5 * spacing_ &&
        carrier(a).normal(near).cross(carrier(b).normal(near)).norm() > kClearly)
      return true;
    const Vector3d p = meetingPoint(near, {&carrier(a), &carrier(b)});
    return (p - near).norm() <= 3 * spacing_ &&
           std::max(std::abs(carrier(a).distance(p)), std::abs(carrier(b).distance(p))) <= kMeet;
  }

  // Returns a carrier near this half-edge that meets both.
  std::int32_t strip(std::int32_t h, const Vector3d& middle, std::int32_t a,
                     std::int32_t b) const {
    constexpr std::size_t kRing = 60;
    std::vector<std::int32_t> ring{h / 3, mesh_.opposite[h] / 3}, beside;
    for (std::size_t i = 0; i < ring.size() && ring.size() < kRing; ++i) {
      for (const std::int32_t t : mesh_.neighbours(ring[i])) {
        if (std::find(ring.begin(), ring.end(), t) != ring.end()) continue;
        ring.push_back(t);
        if (of_[t] >= 0 && of_[t] != a && of_[t] != b) beside.push_back(of_[t]);
      }
    }
    sortUnique(beside);
    std::int32_t best = kNone;
    double smallest = spacing_;
    for (const std::int32_t n : beside) {
      const double off = std::abs(carrier(n).distance(middle));
      if (off >= smallest || !meet(middle, a, n) || !meet(middle, n, b)) continue;
      smallest = off;
      best = n;
    }
    return best;
  }

  // Three regions that meet at a vertex of the mesh need a common point of their carriers. If there
  // is none, the shortest of the three borders does not exist: the third region covers it.
  bool coverShortBorders() {
    bool changed = false;
    std::vector<char> seen(mesh_.points.size(), 0);
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const std::int32_t v = mesh_.origin(static_cast<std::int32_t>(h));
      if (seen[v]) continue;
      seen[v] = 1;
      changed = coverAt(static_cast<std::int32_t>(h)) || changed;
    }
    return changed;
  }

  bool isBorder(std::int32_t h) const { return of_[h / 3] != of_[mesh_.opposite[h] / 3]; }

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

  // Triangles of one region around the origin of a border half-edge, from that on.
  std::vector<std::int32_t> fanFrom(std::int32_t h) const {
    std::vector<std::int32_t> fan;
    do {
      fan.push_back(h / 3);
      h = mesh_.opposite[HalfEdgeMesh::previous(h)];
    } while (!isBorder(h));
    return fan;
  }

  // Where regions meet at a vertex whose carriers have no common point, the ground stays open.
  void openBadCorners() {
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

  void openAround(const std::vector<Vector3d>& open) {
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

  // Half-edges of the border between the same two regions, from the origin of this one.
  std::vector<std::int32_t> chainFrom(std::int32_t h) const {
    const std::int32_t left = of_[h / 3], right = of_[mesh_.opposite[h] / 3];
    std::vector<std::int32_t> chain{h};
    while (chain.size() <= kLongestCover) {
      std::int32_t n = HalfEdgeMesh::next(chain.back());
      while (!isBorder(n)) n = HalfEdgeMesh::next(mesh_.opposite[n]);
      if (of_[n / 3] != left || of_[mesh_.opposite[n] / 3] != right || n == h) break;
      chain.push_back(n);
    }
    return chain;
  }

  static constexpr std::size_t kLongestCover = 24;

  bool meetAll(const Vector3d& near, const std::vector<std::int32_t>& around) const {
    std::vector<const Carrier*> all;
    for (const std::int32_t n : around) all.push_back(&carrier(n));
    if (knownPlace(near, all, 4 * spacing_)) return true;
    const Vector3d p = meetingPoint(near, all);
    if (!((p - near).norm() <= 6 * spacing_)) return false;
    return std::all_of(all.begin(), all.end(), [&](const Carrier* s) {
      return std::abs(s->distance(p)) <= kMeet;
    });
  }

  Partition partition() {
    Partition partition;
    partition.patchOf.assign(of_.size(), kNone);
    const Regions all = regions();
    for (const auto& members : all.triangles) {
      const std::int32_t n = of_[members.front()];
      if (n < 0) continue;
      const auto id = static_cast<std::int32_t>(partition.patches.size());
      for (const std::int32_t t : members) partition.patchOf[t] = id;
      partition.patches.push_back({outward(carrier(n), members), members, 0, id});
    }
    cutRoundPatches(mesh_, partition);
    return partition;
  }

  // The carrier with its normal pointing away from the material.
  Carrier outward(const Carrier& given, const std::vector<std::int32_t>& members) const {
    double sum = 0;
    for (const std::int32_t t : members) sum += given.normal(pointOf(t)).dot(mesh_.areaVector(t));
    Carrier carrier = given;
    if (sum < 0 && carrier.isPlanar()) carrier.axis = -carrier.axis;
    if (sum < 0 && !carrier.isPlanar()) carrier.reversed = !carrier.reversed;
    return carrier;
  }

  const HalfEdgeMesh& mesh_;
  const SolidOrigin& origin_;
  const double tolerance_;
  RunContext& run_;
  const double spacing_;
  SweptCarriers known_;
  std::vector<std::int32_t> of_;  // by triangle: number of its carrier
  std::vector<Vector3d> points_;  // by triangle: its crossing
};

}  // namespace

Partition labelFaces(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance,
                     const std::vector<Vector3d>& open, RunContext& run) {
  return Labeller(mesh, origin, tolerance, run).label(open);
}

}  // namespace swept::step
