// How sampling/cpu cuts a motion and a body into tasks, and which of these thin their crossings.
// In: sampler input. Out: work items, the same for any number of threads. Cost: O(items).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sampling/sampler.h"

namespace swept {

/// Work items of a continuous motion, about.
constexpr std::size_t kMotionItems = 48;
/// A work item with this many placements or crossings may contain many crossings that do not
/// matter; then they are reduced on the way.
constexpr std::size_t kMinThinPlacements = 16, kMinThinRecords = std::size_t{1} << 20;

/// Work item: the placements [begin, end) with the faces [faceBegin, faceEnd).
struct WorkItem {
  std::size_t begin, end, faceBegin, faceEnd;
};

/// Of one work item of the whole motion; the last one may have fewer.
std::size_t placementsOfItem(const SamplerInput& input);
std::vector<WorkItem> workItems(const SamplerInput& input);

}  // namespace swept
