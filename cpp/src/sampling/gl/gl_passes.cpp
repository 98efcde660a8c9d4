// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_passes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "swept/types.h"

namespace swept::gl {
namespace {

/// Longest and shortest time of a draw, in seconds. The batch grows or shrinks to keep draws
/// between them. The promised limit is 0.050 s, so a draw may take four times as long as the one
/// before.
constexpr double kMaxDraw = 0.012, kMinDraw = 0.004;
// Limits of the batch, so that a single odd measurement cannot make it far too small or too large.
constexpr std::uint64_t kMinBatch = 64, kMaxBatch = std::uint64_t{1} << 22;

/// Locations of the uniforms in shaders/*.
enum Uniform {
  kBrickLow,
  kBrickSize,
  kListed,
  kFirstElement,
  kFirstPlacement,
  kPlacementBase,
  kPlacementCount,
  kFaceCount,
  kElementCount,
  kIdBase,
  kCodeCount,
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
  maxCodes_ = static_cast<std::size_t>(
      std::max<std::uint64_t>(1, std::min(budget / 2 / 20, storage / sizeof(glm::uvec2))));
  const GlApi& gl = context_.gl();
  gl.CreateBuffers(kBuffers, buffers_);
  gl.CreateFramebuffers(1, &framebuffer_);
  gl.CreateVertexArrays(1, &vertexArray_);
  gl.BindVertexArray(vertexArray_);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  uploadBody();
}

GlPasses::~GlPasses() {
  const GlApi& gl = context_.gl();
  gl.UseProgram(0);
  gl.DeleteTextures(1, &texture_);
  gl.DeleteFramebuffers(1, &framebuffer_);
  gl.DeleteVertexArrays(1, &vertexArray_);
  gl.DeleteBuffers(kBuffers, buffers_);
}

void GlPasses::requireLimits() const {
  const Limits& limits = context_.limits();
  const auto need = [&](const char* what, std::int64_t has, std::int64_t minCount) {
    if (has >= minCount) return;
    throw Error(Status::DeviceUnavailable, "DeviceUnavailable",
                "no GPU can be used: " + context_.device() + " offers " + std::to_string(has) +
                    " " + what + ", but at least " + std::to_string(minCount) +
                    "; use --backend cpu or auto");
  };
  need("storage blocks in the vertex stage", limits.vertexStorageBlocks, 5);
  need("storage blocks in the fragment stage", limits.fragmentStorageBlocks, 3);
  need("images in the fragment stage", limits.fragmentImages, 1);
  need("geometry invocations", limits.geometryInvocations, 3);
  need("viewports", limits.viewports, 3);
  const auto body = static_cast<std::int64_t>(
      std::max({input_.body.vertices.size() * 3 * sizeof(double),
                input_.body.triangles.size() * 3 * sizeof(std::int32_t),
                input_.topology.edges.size() * 2 * sizeof(std::int32_t)}));
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
  std::uint64_t sum = imageBrick_.texels() * 4;
  for (const std::size_t b : bufferBytes_) sum += b;
  bytes_ = std::max(bytes_, sum);
}

void GlPasses::uploadBody() {
  upload(kVertices, input_.body.vertices.data(),
         input_.body.vertices.size() * sizeof(Eigen::Vector3d));
  upload(kFaces, input_.body.triangles.data(),
         input_.body.triangles.size() * 3 * sizeof(std::int32_t));
  std::vector<std::int32_t> edges;
  if (input_.motion.continuous) {
    edges.reserve(2 * input_.topology.edges.size());
    for (const BodyEdge& e : input_.topology.edges) edges.insert(edges.end(), {e.a, e.b});
  }
  upload(kEdges, edges.data(), edges.size() * sizeof(std::int32_t));
  for (const Binding b : {kPlacements, kElements, kCodes, kExtremes, kWinners}) {
    upload(b, nullptr, 0);
  }
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
  if (source_.listed) {
    static_assert(sizeof(SweptElement) == sizeof(glm::uvec2));
    upload(kElements, source_.list.data() + chunk.first,
           static_cast<std::size_t>(chunk.count) * sizeof(SweptElement));
  }
}

void GlPasses::useBrick(const Brick& brick) {
  const GlApi& gl = context_.gl();
  const auto& s = brick.size;
  const std::int32_t view[3][2] = {{s[1], s[2]}, {s[0], s[2]}, {s[0], s[1]}};
  std::int32_t width = 1, height = 1;
  for (unsigned axis = 0; axis < 3; ++axis) {
    width = std::max(width, view[axis][0]);
    height = std::max(height, view[axis][1]);
    gl.ViewportIndexedf(axis, 0, 0, static_cast<float>(view[axis][0]),
                        static_cast<float>(view[axis][1]));
  }
  gl.NamedFramebufferParameteri(framebuffer_, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
  gl.NamedFramebufferParameteri(framebuffer_, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    context_.lost("a frame of " + std::to_string(width) + " x " + std::to_string(height) +
                  " lines is refused");
  }
  gl.Uniform3i(kBrickLow, brick.low[0], brick.low[1], brick.low[2]);
  gl.Uniform3i(kBrickSize, s[0], s[1], s[2]);
  gl.Uniform1ui(kListed, source_.listed ? 1 : 0);
  gl.Uniform1ui(kPlacementCount, source_.placements);
  gl.Uniform1ui(kFaceCount, source_.faces);
  gl.Uniform1ui(kElementCount, source_.perPlacement);
}

void GlPasses::drawAndWait(std::uint32_t elements, std::uint32_t instances,
                           const std::function<void()>& afterDraw) {
  const GlApi& gl = context_.gl();
  gl.DrawArraysInstanced(GL_LINES_ADJACENCY, 0, static_cast<GLsizei>(4 * elements),
                         static_cast<GLsizei>(instances));
  const double seconds = context_.finish(settings_.fenceTimeoutSeconds);
  ++draws_;
  longestDraw_ = std::max(longestDraw_, seconds);
  if (settings_.adaptBatch) {
    const std::uint64_t drawn = std::uint64_t{elements} * instances;
    if (seconds > kMaxDraw) {
      const double share = std::min(0.5, 0.5 * (kMaxDraw + kMinDraw) / seconds);
      const auto fewer = static_cast<std::uint64_t>(share * static_cast<double>(drawn));
      batch_ = std::max(kMinBatch, std::min(batch_, fewer));
    }
    if (seconds < kMinDraw && drawn * 2 > batch_) batch_ = std::min(kMaxBatch, batch_ * 2);
  }
  afterDraw();
}

void GlPasses::drawChunk(const ElementChunk& chunk, std::uint64_t epochFirst,
                         const std::function<void()>& afterDraw) {
  const GlApi& gl = context_.gl();
  gl.Uniform1ui(kPlacementBase, chunk.placementBase);
  if (source_.listed) {
    gl.Uniform1ui(kFirstPlacement, 0);
    gl.Uniform1ui(kIdBase, static_cast<GLuint>(chunk.first - epochFirst));
    for (std::uint64_t first = 0; first < chunk.count;) {
      const auto n = static_cast<std::uint32_t>(std::min(batch_, chunk.count - first));
      gl.Uniform1ui(kFirstElement, static_cast<GLuint>(first));
      drawAndWait(n, 1, afterDraw);
      first += n;
    }
    return;
  }
  const std::uint64_t each = source_.perPlacement;
  gl.Uniform1ui(kIdBase, static_cast<GLuint>(epochFirst / each));
  const std::uint64_t begin = chunk.first / each, end = begin + chunk.count / each;
  for (std::uint64_t placement = begin; placement < end;) {
    const std::uint64_t together = std::clamp<std::uint64_t>(batch_ / each, 1, end - placement);
    gl.Uniform1ui(kFirstPlacement, static_cast<GLuint>(placement));
    for (std::uint64_t first = 0; first < each;) {
      const auto n =
          static_cast<std::uint32_t>(together > 1 ? each : std::min(batch_, each - first));
      gl.Uniform1ui(kFirstElement, static_cast<GLuint>(first));
      drawAndWait(n, static_cast<std::uint32_t>(together), afterDraw);
      first += n;
    }
    placement += together;
  }
}

void GlPasses::makeImage(const Brick& brick) {
  const GlApi& gl = context_.gl();
  if (imageBrick_.size != brick.size) {
    gl.DeleteTextures(1, &texture_);
    gl.CreateTextures(GL_TEXTURE_3D, 1, &texture_);
    gl.TextureStorage3D(texture_, 1, GL_R32UI, brick.words(), brick.size[1], 3 * brick.size[0]);
    if (gl.GetError() != GL_NO_ERROR) {
      context_.lost("no memory for an image of " + std::to_string(brick.texels() * 4) + " bytes");
    }
    imageBrick_ = brick;
  }
  const std::uint32_t zero = 0;
  gl.ClearTexImage(texture_, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  gl.BindImageTexture(0, texture_, 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
}

std::vector<std::uint32_t> GlPasses::mark(const Brick& brick,
                                          const std::function<void()>& afterDraw) {
  const GlApi& gl = context_.gl();
  makeImage(brick);
  gl.UseProgram(device_.mark.id());
  useBrick(brick);
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    uploadChunk(c);
    drawChunk(chunks_[c], chunks_[c].first, afterDraw);
  }
  gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
  std::vector<std::uint32_t> marks(brick.texels());
  gl.GetTextureImage(texture_, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                     static_cast<GLsizei>(marks.size() * 4), marks.data());
  context_.finish(settings_.fenceTimeoutSeconds);
  return marks;
}

std::vector<EdgeWinner> GlPasses::findWinners(const Brick& brick,
                                              const std::vector<std::uint32_t>& codes,
                                              std::uint64_t first, std::uint64_t end,
                                              const std::function<void()>& afterDraw) {
  const GlApi& gl = context_.gl();
  gl.UseProgram(device_.winner.id());
  useBrick(brick);
  const std::size_t n = codes.size(), bytes = n * sizeof(glm::uvec2);
  upload(kCodes, codes.data(), n * sizeof(std::uint32_t));
  upload(kExtremes, nullptr, bytes);
  upload(kWinners, nullptr, bytes);
  const glm::uvec2 noExtreme(0xffffffffu, 0), noWinner(EdgeWinner::kNone, EdgeWinner::kNone);
  gl.ClearNamedBufferData(buffers_[kExtremes], GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT,
                          &noExtreme);
  gl.ClearNamedBufferData(buffers_[kWinners], GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, &noWinner);
  gl.Uniform1ui(kCodeCount, static_cast<GLuint>(n));
  for (unsigned round = 0; round < 2; ++round) {
    gl.Uniform1ui(kSecondRound, round);
    for (std::size_t c = 0; c < chunks_.size(); ++c) {
      if (chunks_[c].first < first || chunks_[c].first >= end) continue;
      uploadChunk(c);
      drawChunk(chunks_[c], first, afterDraw);
    }
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
  }
  std::vector<glm::uvec2> extremes(n), winners(n);
  gl.GetNamedBufferSubData(buffers_[kExtremes], 0, static_cast<GLsizeiptr>(bytes), extremes.data());
  gl.GetNamedBufferSubData(buffers_[kWinners], 0, static_cast<GLsizeiptr>(bytes), winners.data());
  context_.finish(settings_.fenceTimeoutSeconds);
  std::vector<EdgeWinner> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = {extremes[i].x, extremes[i].y, winners[i].x, winners[i].y};
  }
  return out;
}

}  // namespace swept::gl
