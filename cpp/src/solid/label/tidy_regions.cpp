// SPDX-License-Identifier: LGPL-2.1-or-later
#include <map>

#include "solid/label/label_steps.h"

namespace swept::step {
namespace {

class Tidier : LabelTools {
 public:
  using LabelTools::LabelTools;

  bool tidy() {
    const bool joined = joinSmall(), closed = closeStrips(), separated = removeSelfContacts();
    return joined || closed || separated;
  }

 private:
  // Gives small regions to the neighbour whose carrier is nearest to their points, smallest first.
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
      if (members.size() > (open ? kMaxOpen : kMaxSmall)) continue;
      any = joinBest(members) || any;
    }
    return any;
  }

  static constexpr std::size_t kMaxSmall = 400, kMaxOpen = 2000, kSpeck = 6;

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
    // A region with a single neighbour is noise if its points lie within the tolerance of the
    // neighbour's carrier.
    if (beside.size() == 1 && own >= 0 && largestResidual(members, beside[0]) <= tolerance_)
      best = beside[0];
    double smallest = own < 0 && members.size() <= kSpeck ? 1e300 : joinLimit();
    for (const std::int32_t n : beside) {
      const double worst = largestResidual(members, n);
      if (worst >= smallest) continue;
      smallest = worst;
      best = n;
    }
    if (best < 0) return false;
    for (const std::int32_t t : members) of_[t] = best;
    return true;
  }
  double largestResidual(const std::vector<std::int32_t>& members, std::int32_t n) const {
    double worst = 0;
    for (const std::int32_t t : members) worst = std::max(worst, residual(t, n));
    return worst;
  }
  double joinLimit() const { return std::min(0.5 * tolerance_, 0.3 * spacing_); }

  // A region can touch itself at a vertex: around this vertex, the region has two separate fans of
  // triangles, with fans of other regions between them. Of these other fans, those near the
  // region's carrier are candidates, and the smallest candidate joins the region. Afterwards narrow
  // strips are connected, and no border touches itself.
  bool removeSelfContacts() {
    return anyVertex([this](std::int32_t h) { return removeSelfContactAt(h); });
  }

  bool removeSelfContactAt(std::int32_t first) {
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

  // If two regions touch where their carriers do not meet, a narrow strip of a third surface lies
  // between them. The strip has too few crossings to be connected. Gives the triangles along the
  // border to that surface.
  bool closeStrips() {
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> borders;
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const std::int32_t a = of_[h / 3], b = of_[mesh_.opposite[h] / 3];
      if (a >= 0 && b > a) borders[{a, b}].push_back(static_cast<std::int32_t>(h));
    }
    bool changed = false;
    for (const auto& [pair, halfEdges] : borders) {
      for (const std::int32_t h : halfEdges) {
        const Vector3d middle = (mesh_.points[mesh_.origin(h)] + mesh_.points[mesh_.target(h)]) / 2;
        if (meet(middle, pair.first, pair.second)) continue;
        const std::int32_t between = stripCarrier(h, middle, pair.first, pair.second);
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

  // Returns a carrier near this half-edge that meets the carriers a and b; kNone if there is none.
  std::int32_t stripCarrier(std::int32_t h, const Vector3d& middle, std::int32_t a,
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
};

}  // namespace

bool tidyRegions(Labels& labels) { return Tidier(labels).tidy(); }

}  // namespace swept::step
