// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/cpu/work_items.h"

#include <algorithm>

namespace swept {
namespace {

/// Faces per item of a union. An item of this size takes some milliseconds, and several cores can
/// share the faces of a large body.
constexpr std::size_t kFaces = 8192;
/// Number of items of a union: enough to keep all cores busy. More items would take more memory,
/// because each has its own list of grid layers. If a map of the inside can hide faces, there are
/// fewer and longer items (kCulledItems), because blocks of many placements are decided at once.
constexpr std::size_t kUnionItems = 4096, kCulledItems = 512;

}  // namespace

std::size_t placementsOfItem(const SamplerInput& input) {
  const std::size_t placements = input.motion.placements.size();
  if (!input.motion.continuous && input.inside != nullptr) {
    return std::max<std::size_t>(1, placements / kCulledItems);
  }
  if (!input.motion.continuous) {
    const std::size_t faces = input.body.triangles.size();
    return std::max(
        {std::size_t{1}, std::min(kFaces / faces, placements / 64), placements / kUnionItems});
  }
  // Items should be long: where two items meet, both compute the directions of the faces for the
  // same step. With a cache, an item has one placement and is kept for the next run, unless the
  // motion has many placements.
  const bool kept = input.cache != nullptr && placements < 256;
  return std::max<std::size_t>(1, placements / (kept ? placements : kMotionItems));
}

std::vector<WorkItem> workItems(const SamplerInput& input) {
  const std::size_t placements = input.motion.placements.size();
  const std::size_t faces = input.body.triangles.size();
  const std::size_t group = placementsOfItem(input);
  const bool whole =
      input.motion.continuous || input.inside != nullptr || placements >= kUnionItems;
  const std::size_t facesOfItem =
      whole ? faces : std::max(kFaces, faces * placements / kUnionItems);
  std::vector<WorkItem> items;
  const std::size_t end = std::min(placements, input.only.end);
  for (std::size_t k = input.only.begin; k < end; k += group) {
    for (std::size_t f = 0; f < faces; f += facesOfItem) {
      items.push_back({k, std::min(k + group, end), f, std::min(f + facesOfItem, faces)});
    }
  }
  return items;
}

}  // namespace swept
