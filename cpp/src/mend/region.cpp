// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mend/region.h"

#include <algorithm>

#include "base/parallel.h"

namespace swept {

BlockSet::BlockSet(const GridPlan& plan) : plan_(plan) {
  for (int axis = 0; axis < 3; ++axis) size_[axis] = plan.points[axis] / kBlockCells + 1;
  blocks_.resize(number({size_[0] - 1, size_[1] - 1, size_[2] - 1}) + 1);
}

Eigen::Vector3i BlockSet::cellOf(const Eigen::Vector3d& x) const {
  return ((x - plan_.origin) / plan_.cell).array().floor().matrix().cast<int>().cwiseMax(0);
}

void BlockSet::add(const TriMesh& mesh, std::int32_t triangle, int reach) {
  for (const std::int32_t v : mesh.triangles[triangle]) {
    const Eigen::Vector3i cell = cellOf(mesh.vertices[v]);
    const Eigen::Vector3i low = (cell - Eigen::Vector3i::Constant(reach)).cwiseMax(0) / kBlockCells;
    const Eigen::Vector3i high = ((cell + Eigen::Vector3i::Constant(reach)) / kBlockCells)
                                     .cwiseMin(size_ - Eigen::Vector3i::Ones());
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int z = low[2]; z <= high[2]; ++z) blocks_[number({x, y, z})] = true;
      }
    }
  }
}

bool BlockSet::holds(const TriMesh& mesh, std::int32_t triangle) const {
  const Eigen::Vector3i block = (cellOf(mesh.vertices[mesh.triangles[triangle][0]]) / kBlockCells)
                                    .cwiseMin(size_ - Eigen::Vector3i::Ones());
  return blocks_[number(block)];
}

std::vector<std::int32_t> trianglesIn(const BlockSet& blocks, const TriMesh& mesh,
                                      const std::vector<std::int32_t>* among) {
  const std::size_t count = among != nullptr ? among->size() : mesh.triangles.size();
  constexpr std::size_t kBlock = 1 << 15;
  std::vector<std::vector<std::int32_t>> parts((count + kBlock - 1) / kBlock);
  parallelBlocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::int32_t t = among != nullptr ? (*among)[n] : static_cast<std::int32_t>(n);
      if (blocks.holds(mesh, t)) parts[begin / kBlock].push_back(t);
    }
  });
  std::vector<std::int32_t> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

}  // namespace swept
