// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/near_pairs.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "geometry/certainly_apart.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

constexpr double kSlack = 1e-6;  ///< cells, far above rounding of the way into the frame
constexpr std::size_t kBlock = 1024;

template <class Visit>
void forCells(const Eigen::Vector3i& low, const Eigen::Vector3i& high, const Visit& visit) {
  for (int i = low[0]; i <= high[0]; ++i) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int k = low[2]; k <= high[2]; ++k) visit(i, j, k);
    }
  }
}

/// More than what rounding to float takes away.
constexpr double kFloatStep = 1.2e-7;
float below(double x) { return static_cast<float>(x - kFloatStep * std::abs(x)); }
float above(double x) { return static_cast<float>(x + kFloatStep * std::abs(x)); }

/// Cell of a place in the frame, which does not lie far below its origin.
int cellOf(double x) {
  constexpr int kBelow = 4;
  return static_cast<int>(x + kBelow) - kBelow;
}

}  // namespace

bool meetWrongly(const TriMesh& mesh, std::int32_t first, std::int32_t second) {
  return !certainlyApart(mesh, first, second) && trianglesIntersect(mesh, first, second) &&
         !hasNoArea(mesh, first) && !hasNoArea(mesh, second);
}

NearPairs::Box NearPairs::boxOf(std::int32_t triangle, CellRange& cells) const {
  const auto& tri = mesh_.triangles[triangle];
  const auto &a = mesh_.vertices[tri[0]], &b = mesh_.vertices[tri[1]], &c = mesh_.vertices[tri[2]];
  const auto slack = Eigen::Vector3d::Constant(kSlack);
  const Eigen::Vector3d low = (a.cwiseMin(b).cwiseMin(c) - frame_.origin) * cellsPerUnit_ - slack;
  const Eigen::Vector3d high = (a.cwiseMax(b).cwiseMax(c) - frame_.origin) * cellsPerUnit_ + slack;
  cells.low = {cellOf(low[0]), cellOf(low[1]), cellOf(low[2])};
  cells.high = {cellOf(high[0]), cellOf(high[1]), cellOf(high[2])};
  return {{below(low[0]), below(low[1]), below(low[2])},
          {above(high[0]), above(high[1]), above(high[2])},
          triangle};
}

/// visit(key, above) for the bricks that hold these cells: cells (2m, 2m + 1) along each axis.
template <class Visit>
void NearPairs::forBricks(const CellRange& cells, const Visit& visit) {
  const auto down = [](int cell) { return cell & ~1; };
  const Eigen::Vector3i first = cells.low.unaryExpr(down);
  for (int i = first[0]; i <= cells.high[0]; i += 2) {
    for (int j = first[1]; j <= cells.high[1]; j += 2) {
      for (int k = first[2]; k <= cells.high[2]; k += 2) {
        visit(keyOf(i, j, k),
              (i > first[0] ? 1u : 0u) | (j > first[1] ? 2u : 0u) | (k > first[2] ? 4u : 0u));
      }
    }
  }
}

NearPairs::NearPairs(const TriMesh& mesh, const CellFrame& frame,
                     const std::vector<std::int32_t>& members, RunContext& run)
    : mesh_(mesh), frame_(frame), cellsPerUnit_(1 / frame.cell), run_(run) {
  isMember_.assign(mesh.triangles.size(), 0);
  boxes_.resize(members.size());
  std::vector<CellRange> cells(members.size());
  parallelBlocks(members.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) {
      isMember_[members[m]] = 1;
      boxes_[m] = boxOf(members[m], cells[m]);
    }
  });
  enter(cells);
}

// Threads fill a bucket in any order: what is found is sorted.
void NearPairs::enter(const std::vector<CellRange>& cells) {
  constexpr std::size_t kMembersPerSlot = 16;
  const int slotBits =
      std::max(1, static_cast<int>(std::bit_width(cells.size() / kMembersPerSlot)));
  slotShift_ = 64 - slotBits;
  bits_.assign(std::size_t{1} << slotBits, 0);
  start_.assign((std::size_t{8} << slotBits) + 1, 0);
  parallelBlocks(cells.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) {
      forCells(cells[m].low, cells[m].high, [&](int i, int j, int k) {
        const Place place = placeOf(keyOf(i, j, k));
        std::atomic_ref<std::uint64_t>(bits_[place.slot])
            .fetch_or(std::uint64_t{1} << place.cell, std::memory_order_relaxed);
      });
      forBricks(cells[m], [&](std::uint64_t key, std::uint32_t) {
        std::atomic_ref<std::uint32_t>(start_[bucketOf(key)])
            .fetch_add(1, std::memory_order_relaxed);
      });
    }
  });
  // Inclusive sums; the fill counts each bucket down to its start.
  std::uint32_t sum = 0;
  for (auto& value : start_) value = sum += value;
  entries_ = RawArray<Entry>(sum);
  parallelBlocks(cells.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) {
      forBricks(cells[m], [&](std::uint64_t key, std::uint32_t above) {
        const std::uint32_t place = std::atomic_ref<std::uint32_t>(start_[bucketOf(key)])
                                        .fetch_sub(1, std::memory_order_relaxed) -
                                    1;
        entries_[place] = {key, static_cast<std::uint32_t>(m), above};
      });
    }
  });
}

bool NearPairs::anyBit(const CellRange& cells) const {
  for (int i = cells.low[0]; i <= cells.high[0]; ++i) {
    for (int j = cells.low[1]; j <= cells.high[1]; ++j) {
      for (int k = cells.low[2]; k <= cells.high[2]; ++k) {
        if (bit(keyOf(i, j, k))) return true;
      }
    }
  }
  return false;
}

void NearPairs::ask(std::int32_t triangle, Pairs& out) const {
  CellRange cells;
  const Box box = boxOf(triangle, cells);
  if (!anyBit(cells)) return;
  const bool isMember = isMember_[triangle] != 0;
  forBricks(cells, [&](std::uint64_t key, std::uint32_t above) {
    const std::size_t bucket = bucketOf(key);
    for (std::uint32_t e = start_[bucket]; e < start_[bucket + 1]; ++e) {
      // Two boxes share many bricks; the pair is asked in the lowest of them.
      if (entries_[e].key != key || (entries_[e].above & above) != 0) continue;
      const Box& other = boxes_[entries_[e].member];
      if (!box.meets(other)) continue;
      const std::int32_t member = other.triangle;
      if (member == triangle || (isMember && member > triangle)) continue;
      if (!meetWrongly(mesh_, member, triangle)) continue;
      out.emplace_back(std::min(member, triangle), std::max(member, triangle));
    }
  });
}

SelfIntersections NearPairs::find(const std::vector<std::int32_t>& others) const {
  SelfIntersections found;
  if (boxes_.empty()) return found;
  std::vector<Pairs> parts((others.size() + kBlock - 1) / kBlock);
  parallelFor(parts.size(), [&](std::size_t p) {
    run_.checkpoint(Phase::Check);
    for (std::size_t n = p * kBlock; n < std::min(others.size(), (p + 1) * kBlock); ++n) {
      ask(others[n], parts[p]);
    }
  });
  for (const Pairs& part : parts) {
    found.pairs.insert(found.pairs.end(), part.begin(), part.end());
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  found.count = static_cast<std::int64_t>(found.pairs.size());
  return found;
}

}  // namespace swept
