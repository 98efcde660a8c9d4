// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/near_pairs.h"

#include <algorithm>
#include <bit>

#include "base/parallel.h"
#include "check/certainly_apart.h"
#include "check/triangle_pairs.h"

namespace swept {
namespace {

constexpr double kSlack = 1e-6;  ///< cells, far above rounding of the way into the frame

template <class Visit>
void forCells(const Eigen::Vector3i& low, const Eigen::Vector3i& high, const Visit& visit) {
  for (int i = low[0]; i <= high[0]; ++i) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int k = low[2]; k <= high[2]; ++k) visit(i, j, k);
    }
  }
}

}  // namespace

NearPairs::Box NearPairs::boxOf(std::int32_t triangle) const {
  const auto& tri = mesh_.triangles[triangle];
  const auto &a = mesh_.vertices[tri[0]], &b = mesh_.vertices[tri[1]], &c = mesh_.vertices[tri[2]];
  Box box;
  box.low = a.cwiseMin(b).cwiseMin(c);
  box.high = a.cwiseMax(b).cwiseMax(c);
  const auto cell = [&](const Eigen::Vector3d& x, double slack) -> Eigen::Vector3i {
    return (((x - frame_.origin) / frame_.cell).array() + slack).floor().matrix().cast<int>();
  };
  box.lowCell = cell(box.low, -kSlack);
  box.highCell = cell(box.high, kSlack);
  return box;
}

NearPairs::NearPairs(const TriMesh& mesh, const CellFrame& frame, std::vector<std::int32_t> members,
                     RunContext& run)
    : mesh_(mesh), frame_(frame), run_(run), members_(std::move(members)) {
  isMember_.assign(mesh.triangles.size(), 0);
  for (const std::int32_t t : members_) isMember_[t] = 1;
  boxes_.resize(members_.size());
  parallelBlocks(members_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) boxes_[m] = boxOf(members_[m]);
  });
  std::size_t count = 0;
  for (const Box& box : boxes_) {
    const Eigen::Vector3i size = box.highCell - box.lowCell + Eigen::Vector3i::Ones();
    count += static_cast<std::size_t>(size.prod());
  }
  const int bucketBits = static_cast<int>(std::bit_width(2 * count + 2));
  bucketShift_ = 64 - bucketBits;
  bitShift_ = bucketShift_ - 3;
  bits_.assign((std::size_t{1} << (bucketBits + 3)) / 64 + 1, 0);
  start_.assign((std::size_t{1} << bucketBits) + 1, 0);
  entries_.resize(count);
  for (const Box& box : boxes_) {
    forCells(box.lowCell, box.highCell, [&](int i, int j, int k) {
      const std::uint64_t hash = hashOf(keyOf(i, j, k));
      ++start_[hash >> bucketShift_];
      bits_[hash >> bitShift_ >> 6] |= std::uint64_t{1} << (hash >> bitShift_ & 63);
    });
  }
  // Inclusive sums; the fill counts each bucket down to its start.
  std::uint32_t sum = 0;
  for (auto& value : start_) value = sum += value;
  for (std::size_t m = boxes_.size(); m-- > 0;) {
    forCells(boxes_[m].lowCell, boxes_[m].highCell, [&](int i, int j, int k) {
      const std::uint64_t key = keyOf(i, j, k);
      entries_[--start_[hashOf(key) >> bucketShift_]] = {key, static_cast<std::uint32_t>(m)};
    });
  }
}

void NearPairs::ask(std::int32_t triangle, Pairs& out) const {
  const Box box = boxOf(triangle);
  forCells(box.lowCell, box.highCell, [&](int i, int j, int k) {
    const std::uint64_t key = keyOf(i, j, k);
    if (!bit(key)) return;
    const std::uint64_t bucket = hashOf(key) >> bucketShift_;
    for (std::uint32_t e = start_[bucket]; e < start_[bucket + 1]; ++e) {
      if (entries_[e].key != key) continue;
      const std::int32_t member = members_[entries_[e].member];
      if (member == triangle || (isMember_[triangle] != 0 && member > triangle)) continue;
      const Box& other = boxes_[entries_[e].member];
      if ((box.low.array() > other.high.array()).any() ||
          (other.low.array() > box.high.array()).any()) {
        continue;
      }
      // Two boxes share many cells; the pair is asked in the lowest of them.
      const Eigen::Vector3i first = box.lowCell.cwiseMax(other.lowCell);
      if (first[0] != i || first[1] != j || first[2] != k) continue;
      if (certainlyApart(mesh_, member, triangle)) continue;
      if (!trianglesIntersect(mesh_, member, triangle)) continue;
      if (hasNoArea(mesh_, member) || hasNoArea(mesh_, triangle)) continue;
      out.emplace_back(std::min(member, triangle), std::max(member, triangle));
    }
  });
}

SelfIntersections NearPairs::find(const std::vector<std::int32_t>& others) const {
  SelfIntersections found;
  if (members_.empty()) return found;
  constexpr std::size_t kBlock = 1024;
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
