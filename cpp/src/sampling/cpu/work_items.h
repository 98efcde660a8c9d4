// Splits the sampling of a motion and a body into tasks, and decides which tasks thin their
// crossings.
// In: sampler input. Out: work items, the same for any number of threads. Cost: O(items).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sampling/sampler.h"

namespace swept {

/// Approximate number of work items of a continuous motion.
constexpr std::size_t kMotionItems = 48;
/// A work item with at least kMinThinPlacements placements may collect many crossings that cannot
/// matter. Once it has kMinThinRecords crossings, it removes such crossings from time to time
/// (thinning).
constexpr std::size_t kMinThinPlacements = 16, kMinThinRecords = std::size_t{1} << 20;

/// A work item: the faces [faceBegin, faceEnd) at the placements [begin, end).
struct WorkItem {
  std::size_t begin, end, faceBegin, faceEnd;
};

/// Returns the number of placements per work item; the last item may have fewer.
std::size_t placementsOfItem(const SamplerInput& input);
std::vector<WorkItem> workItems(const SamplerInput& input);

}  // namespace swept
