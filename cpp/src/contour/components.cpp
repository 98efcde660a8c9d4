// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/components.h"

#include <bit>
#include <cmath>

#include "contour/methods/methods.h"

namespace swept {
namespace {

constexpr std::array<std::uint32_t, kFaces> makeFaceMasks() {
  std::array<std::uint32_t, kFaces> masks{};
  for (int face = 0; face < kFaces; ++face) {
    for (const FaceStep& step : kFaceWalks[face]) masks[face] |= 3u << (2 * step.edge);
  }
  return masks;
}
constexpr auto kFaceMasks = makeFaceMasks();

/// A crossing on a face, as a stop of the walk round the face.
struct Stop {
  int slot;
  bool enters;  ///< at this crossing, the walk passes from outside to inside
  float x, y;   // position on the face
  const Crossing* crossing;
};

int collectStops(const Cell& cell, int face, const Crossing* crossings,
                 std::array<Stop, 8>& stops) {
  const int a = face >> 1, b = (a + 1) % 3, c = (a + 2) % 3;
  int n = 0;
  for (const FaceStep& step : kFaceWalks[face]) {
    for (int side = 0; side < 2; ++side) {
      const int slot = 2 * step.edge + (step.backward ? 1 - side : side);
      if (!cell.has(slot)) continue;
      // The walk enters the inside if the crossing is seen from that end of the edge at which the
      // walk along this edge begins.
      const bool fromLow = (slot & 1) == 0;
      Stop& stop = stops[n++];
      stop.slot = slot;
      stop.enters = fromLow != step.backward;
      if (crossings == nullptr) continue;
      stop.crossing = crossings + cell.crossing(slot);
      const Eigen::Vector3d p = localPosition(step.edge, stop.crossing->fraction);
      stop.x = static_cast<float>(p[b]);
      stop.y = static_cast<float>(p[c]);
    }
  }
  return n;
}

float pairCost(const Stop& p, const Stop& q, int a) {
  const int b = (a + 1) % 3, c = (a + 2) % 3;
  const Eigen::Vector3f &m = p.crossing->normal, &n = q.crossing->normal;
  float dx = q.x - p.x, dy = q.y - p.y;
  const float length = std::sqrt(dx * dx + dy * dy);
  if (length > 0) {
    dx /= length;
    dy /= length;
  }
  return 1 - (m[a] * n[a] + (m[b] * n[b] + m[c] * n[c])) + std::abs(m[b] * dx + m[c] * dy) +
         std::abs(n[b] * dx + n[c] * dy);
}

/// A matching of the n crossings on the border of a cell face: each has one partner, and the chords
/// between partners do not intersect. The crossings are numbered in the order of a walk round the
/// face. Element p is the partner of crossing p.
using Matching = std::array<std::int8_t, 8>;
/// Appends to `out` all matchings that complete `partial`. With an empty `partial`, the first
/// matching is 0-1, 2-3 and so on. The walk enters the inside at crossing 0, so this matching joins
/// each entering crossing to the next leaving one.
void enumerate(Matching partial, int n, std::array<Matching, 14>& out, int& count) {
  int p = 0;
  while (p < n && partial[p] >= 0) ++p;
  if (p == n) {
    out[count++] = partial;
    return;
  }
  for (int q = p + 1; q < n; q += 2) {
    if (partial[q] >= 0) continue;
    // Crossings between p and q may only be joined to each other.
    bool crosses = false;
    for (int r = p + 1; r < q; ++r)
      crosses |= partial[r] >= 0 && (partial[r] < p || partial[r] > q);
    if (crosses) continue;
    Matching next = partial;
    next[p] = static_cast<std::int8_t>(q);
    next[q] = static_cast<std::int8_t>(p);
    enumerate(next, n, out, count);
  }
}

struct MatchingList {
  std::array<Matching, 14> all;
  int count = 0;
};
MatchingList makeList(int n) {
  MatchingList list;
  Matching none;
  none.fill(-1);
  enumerate(none, n, list.all, list.count);
  return list;
}
const MatchingList& matchings(int n) {
  static const MatchingList four = makeList(4), six = makeList(6), eight = makeList(8);
  return n == 4 ? four : n == 6 ? six : eight;
}

}  // namespace

int faceCrossings(std::uint32_t mask, int face) { return std::popcount(mask & kFaceMasks[face]); }

bool hasChoice(std::uint32_t mask, int face) {
  std::uint32_t left = mask & kFaceMasks[face];
  left &= left - 1;
  return (left & (left - 1)) != 0;
}

FacePairs pairFace(const Cell& cell, int face, const Crossing* crossings) {
  std::array<Stop, 8> stops;
  // Two crossings can be paired in one way only, so their positions and normals are not needed
  // then.
  const bool choice = hasChoice(cell.mask, face);
  const int n = collectStops(cell, face, choice ? crossings : nullptr, stops);
  FacePairs pairs;
  pairs.count = n / 2;
  if (n == 2) {
    pairs.slots[0] = {static_cast<std::int8_t>(stops[0].slot),
                      static_cast<std::int8_t>(stops[1].slot)};
    return pairs;
  }
  if (n == 0) return pairs;
  // Number the crossings so that the walk enters the inside at crossing 0.
  const int shift = stops[0].enters ? 0 : 1;
  const auto at = [&](int i) -> const Stop& { return stops[(i + shift) % n]; };
  float cost[8][8];
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; j += 2) cost[i][j] = pairCost(at(i), at(j), face >> 1);
  }
  const MatchingList& list = matchings(n);
  int best = 0;
  float bestCost = 0;
  constexpr float kClearlyBetter = 1e-5f;
  for (int m = 0; m < list.count; ++m) {
    float sum = 0;
    for (int i = 0; i < n; ++i) {
      if (list.all[m][i] > i) sum += cost[i][list.all[m][i]];
    }
    if (m == 0 || sum < bestCost - kClearlyBetter) {
      best = m;
      bestCost = sum;
    }
  }
  int filled = 0;
  for (int i = 0; i < n; ++i) {
    const int j = list.all[best][i];
    if (j > i) {
      pairs.slots[filled++] = {static_cast<std::int8_t>(at(i).slot),
                               static_cast<std::int8_t>(at(j).slot)};
    }
  }
  return pairs;
}

void SlotLinks::setComponents(Components& out) const {
  out.count = 0;
  out.of.fill(-1);
  for (int slot = 0; slot < kSlots; ++slot) {
    if (!has(slot) || out.of[slot] >= 0) continue;
    int at = slot, from = -1;
    do {
      out.of[at] = static_cast<std::int8_t>(out.count);
      const int next = after(at, from);
      from = at;
      at = next;
    } while (out.of[at] < 0);
    ++out.count;
  }
}

SlotLinks linkSlots(const Cell& cell, const Crossing* crossings) {
  SlotLinks links;
  for (int face = 0; face < kFaces; ++face) {
    const FacePairs pairs = pairFace(cell, face, crossings);
    for (int i = 0; i < pairs.count; ++i) links.join(pairs.slots[i][0], pairs.slots[i][1]);
  }
  return links;
}

void ComponentFinder::find(const Cell& cell, const Crossing* crossings, Components& out) {
  if (method_ == ComponentMethod::DualContouring) {
    out.count = 1;
    for (int slot = 0; slot < kSlots; ++slot) out.of[slot] = cell.has(slot) ? 0 : -1;
    return;
  }
  if (method_ == ComponentMethod::DualMarchingCubes) return findDualMarchingCubes(cell, out);
  if (method_ == ComponentMethod::Equivalence) return findEquivalence(cell, out);
  if (method_ == ComponentMethod::Greedy) return findGreedy(cell, crossings, out);
  bool ambiguous = false;
  for (int face = 0; face < kFaces; ++face) ambiguous |= hasChoice(cell.mask, face);
  if (ambiguous) return linkSlots(cell, crossings).setComponents(out);
  Known& known = known_[(cell.mask * 2654435761u) >> 22];
  if (known.mask != cell.mask) {
    linkSlots(cell, nullptr).setComponents(known.components);
    known.mask = cell.mask;
  }
  out = known.components;
}

}  // namespace swept
