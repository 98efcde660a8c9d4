// The two passes on the device, brick by brick. Owns all buffers in the device's memory.
//
// Cost: O(elements) vertices per pass and brick, plus fragments. A draw takes less than 50 ms, so
// that a cancel is noticed and no watchdog of the driver ends it. Positions are doubles in cells of
// the grid. The device snaps them to 2^-17 cell by the same operations as the CPU.
// Source: J. Brummer, bachelor's thesis, Mainz 2017, chapter 3; docs/gpu.md.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sampling/gl/brick_plan.h"
#include "sampling/gl/element_source.h"
#include "sampling/gl/gl_program.h"

namespace swept::gl {

struct GlSettings {
  std::uint64_t budgetBytes = std::uint64_t{192} << 20;  ///< memory for marks, lists and chunks
  std::uint64_t chunkBytes = 0;  ///< placements or elements per chunk; 0: from the limits
  double fenceTimeoutSeconds = 10;
  std::uint32_t firstBatch = 1024;  ///< elements in the first draw; later draws adapt
  bool adaptBatch = true;
  std::uint64_t epochElements = 0xfffffff0u;  ///< limit for 32-bit element numbers
};

/// Result of pass 2 for a contributing edge. Element numbers count from the first element of the
/// epoch (a run of chunks with few enough elements for 32-bit numbers).
struct EdgeWinner {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t lowFraction = kNone, highFraction = 0;  ///< in units of 1 / (2^23 - 1)
  std::uint32_t lowElement = kNone, highElement = kNone;
};

class GlPasses {
 public:
  /// Throws Error(DeviceUnavailable) if the body does not fit.
  GlPasses(const GlDevice& device, const SamplerInput& input, const ElementSource& source,
           const GlSettings& settings);
  ~GlPasses();
  GlPasses(const GlPasses&) = delete;
  GlPasses& operator=(const GlPasses&) = delete;

  /// Pass 1: returns the marks of the brick, (3 * size[0]) x size[1] x words() texels.
  std::vector<std::uint32_t> mark(const Brick& brick, const std::function<void()>& afterDraw);
  /// Pass 2 over the elements [first, end). `codes`: sorted codes of edges, i.e. indices of their
  /// bits in the marks of the brick. Element numbers in the result count from `first`.
  std::vector<EdgeWinner> findWinners(const Brick& brick, const std::vector<std::uint32_t>& codes,
                                      std::uint64_t first, std::uint64_t end,
                                      const std::function<void()>& afterDraw);
  /// Returns the chunks. An epoch may end between two of them.
  const std::vector<ElementChunk>& chunks() const { return chunks_; }
  /// Returns the largest number of codes for one call of findWinners().
  std::size_t maxCodes() const { return maxCodes_; }
  double longestDrawSeconds() const { return longestDraw_; }
  std::uint64_t draws() const { return draws_; }
  /// Returns the peak of the device memory allocated so far, in bytes.
  std::uint64_t bytes() const { return bytes_; }

 private:
  enum Binding { kVertices, kFaces, kEdges, kPlacements, kElements, kCodes, kExtremes, kWinners };
  static constexpr int kBuffers = kWinners + 1;

  void requireLimits() const;
  void upload(Binding binding, const void* data, std::size_t bytes);
  void uploadBody();
  void uploadChunk(std::size_t chunk);
  void useBrick(const Brick& brick);
  void drawChunk(const ElementChunk& chunk, std::uint64_t epochFirst,
                 const std::function<void()>& afterDraw);
  void drawAndWait(std::uint32_t elements, std::uint32_t instances,
                   const std::function<void()>& afterDraw);
  void makeImage(const Brick& brick);

  const GlDevice& device_;
  const GlContext& context_;
  const SamplerInput& input_;
  const ElementSource& source_;
  GlSettings settings_;
  std::vector<ElementChunk> chunks_;
  std::size_t maxCodes_ = 0;
  unsigned buffers_[kBuffers] = {}, texture_ = 0, framebuffer_ = 0, vertexArray_ = 0;
  std::size_t bufferBytes_[kBuffers] = {};
  Brick imageBrick_;
  std::size_t uploadedChunk_ = ~std::size_t{0};
  std::uint64_t batch_, draws_ = 0, bytes_ = 0;
  double longestDraw_ = 0;
};

}  // namespace swept::gl
