// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/label/label_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "solid/label/swept_carriers.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kNone = -1;

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

  Partition label() {
    takeSources();
    run_.checkpoint(Phase::Export);
    for (int round = 0; round < kRounds; ++round) {
      const bool joined = joinSmall();
      const bool smoothed = smoothBorders();
      if (!joined && !smoothed) break;
    }
    joinSmall();
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
    const bool speck = members.size() <= kSpeck;
    std::int32_t best = kNone;
    double smallest = speck ? spacing_ : joinLimit();
    for (const std::int32_t n : beside) {
      double worst = 0;
      for (const std::int32_t t : members) worst = std::max(worst, residual(t, n));
      if (worst >= smallest) continue;
      smallest = worst;
      best = n;
    }
    if (best < 0) return false;
    for (const std::int32_t t : members) of_[t] = best;
    return true;
  }
  double joinLimit() const { return std::min(0.5 * tolerance_, 0.3 * spacing_); }

  // A triangle with two sides on the border, or one that only touches its region at a corner, goes
  // to the region beyond if it is near that carrier.
  bool smoothBorders() {
    bool any = false;
    for (int round = 0; round < 4; ++round) {
      std::size_t changed = 0;
      for (std::size_t t = 0; t < of_.size(); ++t) changed += smooth(static_cast<std::int32_t>(t));
      changed += untouch();
      any = any || changed > 0;
      if (changed == 0) break;
    }
    return any;
  }

  bool mayJoin(std::int32_t t, std::int32_t n) const {
    return n >= 0 && residual(t, n) <= spacing_;
  }

  bool smooth(std::int32_t t) {
    const auto around = mesh_.neighbours(t);
    for (int k = 0; k < 3; ++k) {
      const std::int32_t other = of_[around[k]];
      if (other == of_[t] || other != of_[around[(k + 1) % 3]] || !mayJoin(t, other)) continue;
      of_[t] = other;
      return true;
    }
    return false;
  }

  // Where the same two regions meet twice at a vertex, gives the smaller fan away.
  std::size_t untouch() {
    std::size_t changed = 0;
    std::vector<char> seen(mesh_.points.size(), 0);
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const std::int32_t v = mesh_.origin(static_cast<std::int32_t>(h));
      if (seen[v]) continue;
      seen[v] = 1;
      changed += untouchAt(static_cast<std::int32_t>(h));
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
    if (fans.size() < 4) return false;
    const std::size_t count = fans.size();
    std::size_t best = count;
    std::int32_t target = kNone;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t own = of_[fans[i].front()];
      const bool twice =
          std::any_of(fans.begin(), fans.end(), [&](const std::vector<std::int32_t>& fan) {
            return &fan != &fans[i] && of_[fan.front()] == own;
          });
      if (!twice || (best < count && fans[i].size() >= fans[best].size())) continue;
      for (const std::size_t next : {(i + 1) % count, (i + count - 1) % count}) {
        const std::int32_t other = of_[fans[next].front()];
        const bool near = std::all_of(fans[i].begin(), fans[i].end(),
                                      [&](std::int32_t t) { return mayJoin(t, other); });
        if (!near) continue;
        best = i;
        target = other;
        break;
      }
    }
    if (best == count) return false;
    for (const std::int32_t t : fans[best]) of_[t] = target;
    return true;
  }

  Partition partition() {
    known_.finish();
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
                     RunContext& run) {
  return Labeller(mesh, origin, tolerance, run).label();
}

}  // namespace swept::step
