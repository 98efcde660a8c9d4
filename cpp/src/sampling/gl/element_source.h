// Decides which elements of the swept surface are drawn, and numbers them.
//
// A continuous motion with culling has a list: the elements that culling keeps, one by one, in the
// order of the CPU sampler. Dense motions, and motions without culling, have no list. Then every
// face is drawn at every placement and, if the motion is continuous, every edge in every step. The
// shader derives these elements from their numbers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/sampler.h"

namespace swept::gl {

struct ElementSource {
  bool listed = false;
  std::vector<SweptElement> list;
  std::uint32_t faces = 0;         ///< number of faces of the body
  std::uint32_t perPlacement = 0;  ///< faces, or faces and edges
  std::uint32_t placements = 0;

  std::uint64_t count() const {
    return listed ? list.size() : std::uint64_t{perPlacement} * placements;
  }
  SweptElement at(std::uint64_t number) const {
    if (listed) return list[number];
    const auto local = static_cast<std::uint32_t>(number % perPlacement);
    const auto placement = static_cast<std::uint32_t>(number / perPlacement);
    return {local < faces ? local : (local - faces) | SweptElement::kSidePatchBit, placement};
  }
  /// Returns false for side patches at the last placement, where no step starts.
  bool exists(const SweptElement& element) const {
    return !element.isSidePatch() || element.placement + 1 < placements;
  }
};

/// Consecutive elements whose data are on the device at the same time.
struct ElementChunk {
  std::uint64_t first = 0, count = 0;
  std::uint32_t placementBase = 0, placementCount = 0;  ///< the placements that the chunk needs
};

ElementSource planElements(const SamplerInput& input, RunContext& run);

/// Returns chunks with at most `bytes` of placements, and at most `bytes` of listed elements.
std::vector<ElementChunk> planChunks(const ElementSource& source, std::uint64_t bytes);

}  // namespace swept::gl
