// Numbers the elements of the swept surface for the device, and prepares the data for culling.
// Elements are numbered placement by placement: at each placement all faces and then, for a
// continuous motion, the side patches of all edges in the step that starts there. Faces and edges
// have the order in which the CPU sampler visits them. So if several elements cross an edge at the
// same point, both samplers choose the same element. The shader derives the elements from their
// numbers and decides which of them are enclosed (docs/gpu.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sampling/culling/face_clusters.h"
#include "sampling/sampler.h"

namespace swept::gl {

struct ElementSource {
  /// Values of the uniform `culling` in shaders/element.glsl.
  enum Culling : std::uint32_t { kNone, kOpenBody, kClosedBody };

  Culling culling = kNone;
  std::uint32_t faces = 0;         ///< number of faces of the body
  std::uint32_t perPlacement = 0;  ///< number of elements: faces, or faces and edges
  std::uint32_t placements = 0;
  std::vector<std::uint32_t> faceOrder, edgeOrder;  ///< empty: the order of the body
  std::vector<std::int32_t> topology;               ///< buffer of shaders/element.glsl
  std::vector<float> balls;  ///< another buffer of that shader; empty without culling

  double farthest = 0;  ///< mm, distance of the farthest vertex from the origin of the body

  std::uint64_t count() const { return std::uint64_t{perPlacement} * placements; }
  SweptElement at(std::uint64_t number) const {
    const auto local = static_cast<std::uint32_t>(number % perPlacement);
    const auto placement = static_cast<std::uint32_t>(number / perPlacement);
    if (local < faces) return {faceOrder.empty() ? local : faceOrder[local], placement};
    const std::uint32_t edge = local - faces;
    return {(edgeOrder.empty() ? edge : edgeOrder[edge]) | SweptElement::kSidePatchBit, placement};
  }
};

/// Consecutive placements whose data are on the device at the same time.
struct ElementChunk {
  std::uint64_t first = 0, count = 0;                   ///< range of element numbers
  std::uint32_t placementBase = 0, placementCount = 0;  ///< the placements that the chunk needs
};

ElementSource planElements(const SamplerInput& input);

/// Returns the steps that a chunk needs for culling, as rows of shaders/element.glsl. The first
/// step ends at the first placement of the chunk.
std::vector<double> stepRows(const SamplerInput& input, double farthest, const ElementChunk& chunk);

/// Returns chunks with at most `bytes` of placements and steps.
std::vector<ElementChunk> planChunks(const ElementSource& source, std::uint64_t bytes);

}  // namespace swept::gl
