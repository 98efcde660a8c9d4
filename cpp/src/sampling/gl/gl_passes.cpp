// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_passes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <glm/vec4.hpp>
#include <string>

#include "base/timer.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

/// Upper and lower limit (s) for the time of a dispatch. The batch is made smaller or larger to
/// keep dispatches between them. The promised limit is 0.050 s, so a dispatch may take four times
/// as long as the one before.
constexpr double kMaxSeconds = 0.012, kMinSeconds = 0.004;
// Limits of the batch, so that a single odd measurement cannot make it far too small or too large.
constexpr std::uint64_t kMinBatch = 64, kMaxBatch = std::uint64_t{1} << 26;
/// Elements per work group of the shader (kGroup there), and groups per row of a dispatch. OpenGL
/// guarantees that a row may have 65,535 groups.
constexpr std::uint32_t kGroup = 64, kGroupsInRow = 32768;

/// Locations of the uniforms in shaders/*.
enum Uniform {
  kBrickLow,
  kBrickSize,
  kPlacementBase,
  kPlacementCount,
  kFaceCount,
  kElementCount,
  kCulling,
  kFirstElement,
  kDispatchCount,
  kIdBase,
  kSecondRound
};

}  // namespace

GlPasses::GlPasses(const GlDevice& device, const SamplerInput& input, const ElementSource& source,
                   const GlSettings& settings)
    : device_(device),
      context_(*device.context),
      input_(input),
      source_(source),
      settings_(settings),
      batch_(settings.firstBatch) {
  requireLimits();
  const auto storage = static_cast<std::uint64_t>(context_.limits().storageBytes);
  const std::uint64_t budget = settings.budgetBytes;
  std::uint64_t chunkBytes = settings.chunkBytes != 0 ? settings.chunkBytes : budget / 4;
  chunkBytes = std::min(chunkBytes, storage);
  chunks_ = planChunks(source, chunkBytes);
  maxTargets_ = static_cast<std::size_t>(
      std::max<std::uint64_t>(1, std::min(budget / 2 / (sizeof(std::uint32_t) + sizeof(EdgeWinner)),
                                          storage / sizeof(EdgeWinner))));
  context_.gl().CreateBuffers(kBuffers, buffers_);
  upload(kVertices, input_.body.vertices.data(),
         input_.body.vertices.size() * sizeof(Eigen::Vector3d));
  upload(kTopology, source_.topology.data(), source_.topology.size() * sizeof(std::int32_t));
  upload(kBalls, source_.balls.data(), source_.balls.size() * sizeof(float));
  for (const Binding b : {kPlacements, kSteps, kExactSteps, kMarks, kWinners})
    upload(b, nullptr, 0);
}

GlPasses::~GlPasses() {
  const GlApi& gl = context_.gl();
  gl.UseProgram(0);
  gl.DeleteBuffers(kBuffers, buffers_);
}

void GlPasses::requireLimits() const {
  const Limits& limits = context_.limits();
  const auto need = [&](const char* what, std::int64_t has, std::int64_t minCount) {
    if (has >= minCount) return;
    throw Error(Status::DeviceUnavailable, "DeviceUnavailable",
                "no GPU can be used: " + context_.device() + " offers " + std::to_string(has) +
                    " " + what + ", but at least " + std::to_string(minCount) + " are needed" +
                    kDeviceAdvice);
  };
  need("storage blocks in a compute shader", limits.storageBlocks, kBuffers);
  const auto body = static_cast<std::int64_t>(std::max(
      {input_.body.vertices.size() * 3 * sizeof(double),
       source_.topology.size() * sizeof(std::int32_t), source_.balls.size() * sizeof(float)}));
  need("bytes in a storage block", limits.storageBytes, std::max<std::int64_t>(body, 4096));
}

void GlPasses::upload(Binding binding, const void* data, std::size_t bytes) {
  constexpr std::size_t kMin = 16;  // OpenGL cannot bind an empty buffer
  std::array<std::byte, kMin> padded{};
  if (data != nullptr && bytes < kMin) {
    if (bytes > 0) std::memcpy(padded.data(), data, bytes);
    data = padded.data();
  }
  const GlApi& gl = context_.gl();
  gl.NamedBufferData(buffers_[binding], static_cast<GLsizeiptr>(std::max(bytes, kMin)), data,
                     GL_DYNAMIC_DRAW);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffers_[binding]);
  bufferBytes_[binding] = std::max(bytes, kMin);
  std::uint64_t sum = 0;
  for (const std::size_t b : bufferBytes_) sum += b;
  bytes_ = std::max(bytes_, sum);
}

void GlPasses::uploadChunk(std::size_t index) {
  if (uploadedChunk_ == index) return;
  uploadedChunk_ = index;
  const ElementChunk& chunk = chunks_[index];
  std::vector<glm::dvec4> rows;
  rows.reserve(3 * std::size_t{chunk.placementCount});
  for (std::uint32_t k = 0; k < chunk.placementCount; ++k) {
    const Placement p =
        input_.grid.toGrid(input_.motion.placements[std::size_t{chunk.placementBase} + k]);
    for (int row = 0; row < 3; ++row) {
      rows.emplace_back(p.rotation(row, 0), p.rotation(row, 1), p.rotation(row, 2),
                        p.translation[row]);
    }
  }
  upload(kPlacements, rows.data(), rows.size() * sizeof(glm::dvec4));
  if (source_.culling == ElementSource::kNone) return;
  const std::vector<double> exact = stepRows(input_, source_.farthest, chunk);
  const std::vector<float> steps(exact.begin(), exact.end());
  upload(kSteps, steps.data(), steps.size() * sizeof(float));
  upload(kExactSteps, exact.data(), exact.size() * sizeof(double));
}

void GlPasses::useBrick(const Brick& brick) {
  const GlApi& gl = context_.gl();
  gl.Uniform3i(kBrickLow, brick.low[0], brick.low[1], brick.low[2]);
  gl.Uniform3i(kBrickSize, brick.size[0], brick.size[1], brick.size[2]);
  gl.Uniform1ui(kPlacementCount, source_.placements);
  gl.Uniform1ui(kFaceCount, source_.faces);
  gl.Uniform1ui(kElementCount, source_.perPlacement);
  gl.Uniform1ui(kCulling, source_.culling);
}

/// Runs the current program on the elements [first, end) of the chunk. Number 0 is the first
/// element of the chunk.
void GlPasses::run(const ElementChunk& chunk, std::uint64_t first, std::uint64_t end,
                   std::uint64_t epochFirst, const std::function<void()>& afterDispatch) {
  const GlApi& gl = context_.gl();
  gl.Uniform1ui(kPlacementBase, chunk.placementBase);
  gl.Uniform1ui(kIdBase, static_cast<GLuint>(chunk.first - epochFirst));
  while (first < end) {
    const auto count = static_cast<std::uint32_t>(std::min(batch_, end - first));
    const std::uint32_t groups = (count + kGroup - 1) / kGroup;
    const Timer timer;  // some drivers do the work within the call
    gl.Uniform1ui(kFirstElement, static_cast<GLuint>(first));
    gl.Uniform1ui(kDispatchCount, count);
    gl.DispatchCompute(std::min(groups, kGroupsInRow), (groups + kGroupsInRow - 1) / kGroupsInRow,
                       1);
    context_.finish(settings_.fenceTimeoutSeconds);
    const double seconds = timer.seconds();
    first += count;
    ++dispatches_;
    longestDispatch_ = std::max(longestDispatch_, seconds);
    if (settings_.adaptBatch) {
      if (seconds > kMaxSeconds) {
        const double fraction = std::min(0.5, 0.5 * (kMaxSeconds + kMinSeconds) / seconds);
        const auto fewer = static_cast<std::uint64_t>(fraction * count);
        batch_ = std::max(kMinBatch, std::min(batch_, fewer));
      }
      if (seconds < kMinSeconds && count == batch_) batch_ = std::min(kMaxBatch, batch_ * 2);
    }
    afterDispatch();
  }
}

/// Prepares pass 1 for the brick: no edge is marked.
void GlPasses::startMarks(const Brick& brick) {
  const GlApi& gl = context_.gl();
  gl.UseProgram(device_.mark.id());
  useBrick(brick);
  const auto bytes = static_cast<std::size_t>(brick.markWords()) * sizeof(std::uint32_t);
  upload(kMarks, nullptr, bytes);
  const std::uint32_t zero = 0;
  gl.ClearNamedBufferData(buffers_[kMarks], GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  context_.finish(settings_.fenceTimeoutSeconds);  // detects a lack of memory
}

double GlPasses::expectedSeconds(const Brick& brick, const std::function<void()>& afterDispatch) {
  // A window must be long enough to keep the device busy. All windows together are 1/64 of the
  // elements.
  constexpr std::uint64_t kWindows = 16, kFraction = 64, kMinWindow = std::uint64_t{1} << 17;
  startMarks(brick);
  const std::uint64_t total = source_.count();
  const std::uint64_t window =
      std::min(total, std::max(kMinWindow, total / (kWindows * kFraction)));
  std::uint64_t sampled = 0;
  double seconds = 0;
  std::size_t c = 0;
  for (std::uint64_t n = 0; n < kWindows; ++n) {
    const std::uint64_t begin = total / kWindows * n;
    while (begin >= chunks_[c].first + chunks_[c].count) ++c;
    const std::uint64_t first = begin - chunks_[c].first;
    const std::uint64_t end = std::min(first + window, chunks_[c].count);
    uploadChunk(c);
    // Drivers finish compiling at the first use, and the batch adapts, so a first run is not timed.
    if (n == 0) run(chunks_[c], first, end, chunks_[c].first, afterDispatch);
    const Timer timer;
    run(chunks_[c], first, end, chunks_[c].first, afterDispatch);
    seconds += timer.seconds();
    sampled += end - first;
  }
  return seconds * static_cast<double>(total) /
         static_cast<double>(std::max<std::uint64_t>(1, sampled));
}

std::vector<std::uint32_t> GlPasses::mark(const Brick& brick,
                                          const std::function<void()>& afterDispatch) {
  const GlApi& gl = context_.gl();
  startMarks(brick);
  const auto bytes = static_cast<std::size_t>(brick.markWords()) * sizeof(std::uint32_t);
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    uploadChunk(c);
    run(chunks_[c], 0, chunks_[c].count, chunks_[c].first, afterDispatch);
  }
  gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
  std::vector<std::uint32_t> marks(static_cast<std::size_t>(brick.markWords()));
  gl.GetNamedBufferSubData(buffers_[kMarks], 0, static_cast<GLsizeiptr>(bytes), marks.data());
  context_.finish(settings_.fenceTimeoutSeconds);
  return marks;
}

std::vector<EdgeWinner> GlPasses::findWinners(const Brick& brick,
                                              const std::vector<Target>& targets,
                                              std::uint64_t first, std::uint64_t end,
                                              const std::function<void()>& afterDispatch) {
  const GlApi& gl = context_.gl();
  gl.UseProgram(device_.winner.id());
  useBrick(brick);
  const std::size_t n = targets.size();
  const std::size_t rows =
      3 * static_cast<std::size_t>(brick.size[0]) * static_cast<std::size_t>(brick.size[1]);
  std::vector<std::uint32_t> listed(rows + 1 + n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    ++listed[targets[i].row + 1];
    listed[rows + 1 + i] = targets[i].k;
  }
  for (std::size_t row = 0; row < rows; ++row) listed[row + 1] += listed[row];
  upload(kMarks, listed.data(), listed.size() * sizeof(std::uint32_t));
  std::vector<EdgeWinner> winners(n);
  static_assert(sizeof(EdgeWinner) == 4 * sizeof(std::uint32_t));
  upload(kWinners, winners.data(), n * sizeof(EdgeWinner));
  for (unsigned round = 0; round < 2; ++round) {
    gl.Uniform1ui(kSecondRound, round);
    for (std::size_t c = 0; c < chunks_.size(); ++c) {
      if (chunks_[c].first < first || chunks_[c].first >= end) continue;
      uploadChunk(c);
      run(chunks_[c], 0, chunks_[c].count, first, afterDispatch);
    }
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
  }
  gl.GetNamedBufferSubData(buffers_[kWinners], 0, static_cast<GLsizeiptr>(n * sizeof(EdgeWinner)),
                           winners.data());
  context_.finish(settings_.fenceTimeoutSeconds);
  return winners;
}

}  // namespace swept::gl
