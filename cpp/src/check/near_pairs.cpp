// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/near_pairs.h"

#include <algorithm>
#include <span>

#include "base/parallel.h"
#include "geometry/box_tree.h"
#include "geometry/triangle_pairs.h"

namespace swept {

SelfIntersections findNearPairs(const TriMesh& mesh, const std::vector<std::int32_t>& members,
                                const std::vector<std::int32_t>& others, RunContext& run) {
  // Successive triangles of a list mostly lie side by side, so one search serves kTogether of them.
  constexpr std::size_t kTogether = 8, kBlock = 1024;
  SelfIntersections found;
  if (members.empty()) return found;
  const auto boxOf = [&](std::int32_t triangle) {
    BoxTree::Bounds box;
    for (const std::int32_t v : mesh.triangles[triangle]) box.extend(mesh.vertices[v]);
    return box;
  };
  const BoxTree tree(members.size(), [&](std::size_t m) { return boxOf(members[m]); });
  std::vector<std::uint8_t> isMember(mesh.triangles.size(), 0);
  for (const std::int32_t m : members) isMember[m] = 1;
  std::vector<decltype(found.pairs)> parts((others.size() + kBlock - 1) / kBlock);
  parallelBlocks(others.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Check);
    std::vector<std::pair<std::int32_t, BoxTree::Bounds>> near;
    for (std::size_t first = begin; first < end; first += kTogether) {
      const std::span together(others.data() + first, std::min(kTogether, end - first));
      BoxTree::Bounds around;
      for (const std::int32_t other : together) around.extend(boxOf(other));
      near.clear();
      tree.forBox(around.low, around.high, [&](std::uint32_t index) {
        const std::int32_t member = members[tree.item(index)];
        near.emplace_back(member, boxOf(member));
      });
      if (near.empty()) continue;
      for (const std::int32_t other : together) {
        const BoxTree::Bounds box = boxOf(other);
        for (const auto& [member, ofMember] : near) {
          if (member == other || (isMember[other] != 0 && member > other)) continue;
          if (!box.intersects(ofMember) || !trianglesIntersectFast(mesh, member, other)) continue;
          parts[begin / kBlock].emplace_back(std::minmax(member, other));
        }
      }
    }
  });
  for (const auto& part : parts) {
    found.pairs.insert(found.pairs.end(), part.begin(), part.end());
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  found.count = static_cast<std::int64_t>(found.pairs.size());
  return found;
}

}  // namespace swept
