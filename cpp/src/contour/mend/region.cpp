// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/region.h"

#include <algorithm>
#include <atomic>

namespace swept {

TriangleBlocks::TriangleBlocks(const TriMesh& mesh, const GridPlan& plan) : plan_(plan) {
  for (int axis = 0; axis < 3; ++axis) size_[axis] = plan.points[axis] / kBlockCells + 1;
  of_.resize(mesh.triangles.size());
  parallelBlocks(of_.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) of_[t] = blockOf(mesh, t);
  });
}

void TriangleBlocks::update(const TriMesh& mesh, const std::vector<std::int32_t>& changed) {
  of_.resize(mesh.triangles.size());
  for (const std::int32_t t : changed) of_[t] = blockOf(mesh, static_cast<std::size_t>(t));
}

Eigen::Vector3i TriangleBlocks::cellOf(const Eigen::Vector3d& x) const {
  return ((x - plan_.origin) / plan_.cell).array().floor().matrix().cast<int>().cwiseMax(0);
}

std::uint32_t TriangleBlocks::blockOf(const TriMesh& mesh, std::size_t triangle) const {
  const Eigen::Vector3i block = (cellOf(mesh.vertices[mesh.triangles[triangle][0]]) / kBlockCells)
                                    .cwiseMin(size_ - Eigen::Vector3i::Ones());
  return static_cast<std::uint32_t>(number(block));
}

BlockSet::BlockSet(const TriangleBlocks& blocks)
    : blocks_(blocks), bits_(blocks.number(blocks.size_ - Eigen::Vector3i::Ones()) / 64 + 1) {}

void BlockSet::add(const TriMesh& mesh, std::int32_t triangle, int reach) {
  constexpr int kBlockCells = TriangleBlocks::kBlockCells;
  const Eigen::Vector3i most = blocks_.size_ - Eigen::Vector3i::Ones();
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Eigen::Vector3i p = blocks_.cellOf(mesh.vertices[a]), q = blocks_.cellOf(mesh.vertices[b]),
                        r = blocks_.cellOf(mesh.vertices[c]);
  const Eigen::Vector3i around = Eigen::Vector3i::Constant(reach);
  const Eigen::Vector3i low = (p.cwiseMin(q).cwiseMin(r) - around).cwiseMax(0) / kBlockCells;
  const Eigen::Vector3i high = ((p.cwiseMax(q).cwiseMax(r) + around) / kBlockCells).cwiseMin(most);
  for (int x = low[0]; x <= high[0]; ++x) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int z = low[2]; z <= high[2]; ++z) {
        const std::size_t block = blocks_.number({x, y, z});
        const std::uint64_t bit = std::uint64_t{1} << (block & 63);
        const std::atomic_ref<std::uint64_t> word(bits_[block >> 6]);
        if ((word.load(std::memory_order_relaxed) & bit) == 0) {
          word.fetch_or(bit, std::memory_order_relaxed);
        }
      }
    }
  }
}

std::vector<std::int32_t> BlockSet::triangles(const std::vector<std::int32_t>* among) const {
  const std::size_t count = among != nullptr ? among->size() : blocks_.of_.size();
  return gather<std::int32_t>(count, [&](std::size_t n, std::vector<std::int32_t>& part) {
    const std::int32_t t = among != nullptr ? (*among)[n] : static_cast<std::int32_t>(n);
    if (contains(static_cast<std::size_t>(t))) part.push_back(t);
  });
}

}  // namespace swept
