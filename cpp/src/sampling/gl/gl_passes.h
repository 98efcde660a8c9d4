// Runs the two passes on the device, brick by brick. Pass 1 marks the crossed lattice edges. Pass 2
// finds for each contributing edge (with at least one end outside) the first and the last crossing
// and their elements. Owns all buffers in the device's memory.
//
// Cost: O(elements) per pass and brick, plus crossings. A dispatch takes less than 50 ms, so that a
// request to cancel is noticed soon and no watchdog of the driver ends the dispatch. Positions are
// doubles in cells of the grid. The device snaps them to 2^-17 cell by the same operations as the
// CPU.
// Source: J. Brummer, bachelor's thesis, Mainz 2017, chapter 3 (there by rasterisation);
// docs/gpu.md.
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
  std::uint64_t budgetBytes = std::uint64_t{192} << 20;  ///< memory for marks, targets and chunks
  /// Bytes of placements and steps per chunk; 0: derived from the limits.
  std::uint64_t chunkBytes = 0;
  double fenceTimeoutSeconds = 10;
  /// Number of elements in the first dispatch; later dispatches have more or fewer.
  std::uint32_t firstBatch = 1024;
  bool adaptBatch = true;
  std::uint64_t epochElements = 0xfffffff0u;  ///< limit for 32-bit element numbers
};

/// A contributing edge for pass 2: its row in the marks of the brick, and its k in the brick.
struct Target {
  std::uint32_t row = 0, k = 0;
};

/// Result of pass 2 for a target: its "winners", the elements with the first and the last crossing
/// of the edge. Fractions say where these crossings lie on the edge. Element numbers are relative
/// to the first element of the epoch (successive chunks with few enough elements for 32-bit
/// numbers).
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

  /// Pass 1: returns the marks of the brick, (3 * size[0]) x size[1] rows of words() words.
  std::vector<std::uint32_t> mark(const Brick& brick, const std::function<void()>& afterDispatch);
  /// Pass 2 over the elements [first, end). `targets` must be sorted by row, then k. Element
  /// numbers in the result count from `first`.
  std::vector<EdgeWinner> findWinners(const Brick& brick, const std::vector<Target>& targets,
                                      std::uint64_t first, std::uint64_t end,
                                      const std::function<void()>& afterDispatch);
  /// Returns the seconds that pass 1 is expected to take on the brick, from a sample of the
  /// elements.
  double expectedSeconds(const Brick& brick, const std::function<void()>& afterDispatch);
  /// Returns the chunks. Epochs end between chunks.
  const std::vector<ElementChunk>& chunks() const { return chunks_; }
  /// Returns the largest number of targets for one call of findWinners().
  std::size_t maxTargets() const { return maxTargets_; }
  double longestDispatchSeconds() const { return longestDispatch_; }
  std::uint64_t dispatches() const { return dispatches_; }
  /// Returns the peak of the device memory allocated so far, in bytes.
  std::uint64_t bytes() const { return bytes_; }

 private:
  /// Bindings of the buffers in shaders/*. Marks and targets share one.
  enum Binding { kVertices, kTopology, kPlacements, kSteps, kExactSteps, kBalls, kMarks, kWinners };
  static constexpr int kBuffers = kWinners + 1;

  void requireLimits() const;
  void upload(Binding binding, const void* data, std::size_t bytes);
  void uploadChunk(std::size_t chunk);
  void useBrick(const Brick& brick);
  void startMarks(const Brick& brick);
  void run(const ElementChunk& chunk, std::uint64_t first, std::uint64_t end,
           std::uint64_t epochFirst, const std::function<void()>& afterDispatch);

  const GlDevice& device_;
  const GlContext& context_;
  const SamplerInput& input_;
  const ElementSource& source_;
  GlSettings settings_;
  std::vector<ElementChunk> chunks_;
  std::size_t maxTargets_ = 0;
  unsigned buffers_[kBuffers] = {};
  std::size_t bufferBytes_[kBuffers] = {};
  std::size_t uploadedChunk_ = ~std::size_t{0};
  std::uint64_t batch_, dispatches_ = 0, bytes_ = 0;
  double longestDispatch_ = 0;
};

}  // namespace swept::gl
