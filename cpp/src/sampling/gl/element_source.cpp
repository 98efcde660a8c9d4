// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/element_source.h"

#include <algorithm>

#include "base/parallel.h"
#include "sampling/culling/kept_elements.h"

namespace swept::gl {
namespace {

constexpr std::uint64_t kPlacementBytes = 12 * sizeof(double);

std::vector<SweptElement> listKept(const SamplerInput& input, RunContext& run) {
  const FaceClusters clusters = buildClusters(input.body, input.topology);
  const ShownClusters all = allClusters(clusters);
  const std::size_t placements = input.motion.placements.size();
  const std::size_t group = std::max<std::size_t>(1, placements / 128);
  const std::size_t items = (placements + group - 1) / group;
  return gather<SweptElement>(items, 1, [&](std::size_t item, std::vector<SweptElement>& part) {
    const std::size_t begin = item * group, end = std::min(begin + group, placements);
    KeptElements kept(input, clusters);
    for (std::size_t k = begin; k < end; ++k) {
      run.checkpoint(Phase::Sampling);
      kept.goTo(k);
      const auto placement = static_cast<std::uint32_t>(k);
      kept.forFaces(all, [&](std::uint32_t f) { part.push_back({f, placement}); });
      if (k == input.motion.steps()) break;
      kept.forPatches(all, [&](std::uint32_t e, const FaceClusters::EdgeEnds&) {
        part.push_back({e | SweptElement::kSidePatchBit, placement});
      });
    }
  });
}

}  // namespace

ElementSource planElements(const SamplerInput& input, RunContext& run) {
  ElementSource source;
  source.faces = static_cast<std::uint32_t>(input.body.triangles.size());
  source.perPlacement = source.faces;
  source.placements = static_cast<std::uint32_t>(input.motion.placements.size());
  if (input.motion.continuous) {
    source.perPlacement += static_cast<std::uint32_t>(input.topology.edges.size());
    source.listed = input.cull;
    if (source.listed) source.list = listKept(input, run);
  }
  return source;
}

std::vector<ElementChunk> planChunks(const ElementSource& source, std::uint64_t bytes) {
  std::vector<ElementChunk> chunks;
  // Element numbers within a chunk have 32 bits. A side patch also needs the placement after its
  // own.
  const std::uint64_t window = std::max<std::uint64_t>(2, bytes / kPlacementBytes);
  if (source.listed) {
    const std::uint64_t maxCount = std::max<std::uint64_t>(1, bytes / sizeof(SweptElement));
    for (std::uint64_t first = 0; first < source.list.size();) {
      const std::uint32_t base = source.list[first].placement;
      std::uint64_t end = first;
      while (end < source.list.size() && end - first < maxCount &&
             source.list[end].placement + 2 <= base + window) {
        ++end;
      }
      const std::uint32_t last =
          std::min(source.list[end - 1].placement + 1, source.placements - 1);
      chunks.push_back({first, end - first, base, last - base + 1});
      first = end;
    }
    return chunks;
  }
  const std::uint64_t maxCount = std::max<std::uint64_t>(
      1, std::min<std::uint64_t>(window - 1, 0xfffffff0u / std::max(1u, source.perPlacement)));
  for (std::uint64_t base = 0; base < source.placements; base += maxCount) {
    const std::uint64_t count = std::min<std::uint64_t>(maxCount, source.placements - base);
    const std::uint64_t held = std::min<std::uint64_t>(count + 1, source.placements - base);
    chunks.push_back({base * source.perPlacement, count * source.perPlacement,
                      static_cast<std::uint32_t>(base), static_cast<std::uint32_t>(held)});
  }
  return chunks;
}

}  // namespace swept::gl
