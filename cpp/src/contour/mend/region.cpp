// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/region.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"

namespace swept {
namespace {

constexpr int kBlockCells = 4;

}  // namespace

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

std::vector<std::int32_t> TriangleBlocks::near(const TriMesh& mesh,
                                               const std::vector<std::int32_t>& members,
                                               int reachCells,
                                               const std::vector<std::int32_t>* among) const {
  const Eigen::Vector3i last = size_ - Eigen::Vector3i::Ones();
  const Eigen::Vector3i reach = Eigen::Vector3i::Constant(reachCells);
  // One bit per block: 1 if the block is near a member.
  std::vector<std::uint64_t> marks(number(last) / 64 + 1, 0);
  parallelBlocks(members.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto& [a, b, c] = mesh.triangles[members[n]];
      const Eigen::Vector3i p = cellOf(mesh.vertices[a]), q = cellOf(mesh.vertices[b]),
                            r = cellOf(mesh.vertices[c]);
      const Eigen::Vector3i low = (p.cwiseMin(q).cwiseMin(r) - reach).cwiseMax(0) / kBlockCells;
      const Eigen::Vector3i high =
          ((p.cwiseMax(q).cwiseMax(r) + reach) / kBlockCells).cwiseMin(last);
      for (int x = low[0]; x <= high[0]; ++x) {
        for (int y = low[1]; y <= high[1]; ++y) {
          for (int z = low[2]; z <= high[2]; ++z) {
            const std::size_t block = number({x, y, z});
            std::atomic_ref<std::uint64_t>(marks[block / 64])
                .fetch_or(std::uint64_t{1} << block % 64, std::memory_order_relaxed);
          }
        }
      }
    }
  });
  const std::size_t count = among != nullptr ? among->size() : of_.size();
  return gather<std::int32_t>(
      count, kTrianglesPerTask, [&](std::size_t n, std::vector<std::int32_t>& part) {
        const std::int32_t t = among != nullptr ? (*among)[n] : static_cast<std::int32_t>(n);
        if ((marks[of_[t] / 64] >> of_[t] % 64 & 1u) != 0) part.push_back(t);
      });
}

}  // namespace swept
