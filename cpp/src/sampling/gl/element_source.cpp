// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/element_source.h"

#include <algorithm>

#include "sampling/culling/swept_elements.h"

namespace swept::gl {
namespace {

constexpr std::size_t kStepNumbers = 6 * 4;
/// Placements and steps are uploaded in double precision, steps also in single precision.
constexpr std::uint64_t kPlacementBytes =
    (12 + kStepNumbers) * sizeof(double) + kStepNumbers * sizeof(float);

/// Appends an edge to the buffer of the topology. `right`: as in shaders/element.glsl.
void addEdge(const BodyEdge& edge, std::uint32_t left, std::int32_t right,
             std::vector<std::int32_t>& topology) {
  topology.insert(topology.end(), {edge.a, edge.b, static_cast<std::int32_t>(left), right});
}

/// Orders faces and edges by the clusters of the body, as KeptElements visits them.
void addClusters(const SamplerInput& input, const FaceClusters& clusters, ElementSource& source) {
  const auto& edges = input.topology.edges;
  source.faceOrder = clusters.faces;
  source.edgeOrder = clusters.innerEdges;
  source.edgeOrder.insert(source.edgeOrder.end(), clusters.borderEdges.begin(),
                          clusters.borderEdges.end());
  for (const std::uint32_t f : source.faceOrder) {
    const auto& t = input.body.triangles[f];
    source.topology.insert(source.topology.end(), t.begin(), t.end());
  }
  for (std::size_t n = 0; n < clusters.innerEdges.size(); ++n) {
    const FaceClusters::EdgeEnds& ends = clusters.innerEnds[n];
    addEdge(edges[clusters.innerEdges[n]], ends.left, static_cast<std::int32_t>(2 * ends.right),
            source.topology);
  }
  for (const FaceClusters::Border& border : clusters.borders) {
    for (std::uint32_t n = border.firstEdge; n < border.firstEdge + border.edgeCount; ++n) {
      const FaceClusters::EdgeEnds& ends = clusters.borderEnds[n];
      const auto right = static_cast<std::int32_t>(2 * ends.right + (border.opposed ? 1 : 0));
      addEdge(edges[clusters.borderEdges[n]], ends.left, border.right >= 0 ? right : -1,
              source.topology);
    }
  }
}

}  // namespace

ElementSource planElements(const SamplerInput& input) {
  ElementSource source;
  source.faces = static_cast<std::uint32_t>(input.body.triangles.size());
  source.perPlacement = source.faces;
  source.placements = static_cast<std::uint32_t>(input.motion.placements.size());
  if (!input.motion.continuous) {
    for (const auto& t : input.body.triangles) {
      source.topology.insert(source.topology.end(), t.begin(), t.end());
    }
    return source;
  }
  source.perPlacement += static_cast<std::uint32_t>(input.topology.edges.size());
  FaceClusters own;
  const FaceClusters& clusters = clustersOf(input, own);
  addClusters(input, clusters, source);
  if (!input.cull) return source;
  source.culling = input.orientable ? ElementSource::kClosedBody : ElementSource::kOpenBody;
  for (const auto& v : input.body.vertices) source.farthest = std::max(source.farthest, v.norm());
  source.balls.reserve(8 * clusters.balls.size());
  for (const FaceClusters::FaceBall& ball : clusters.balls) {
    const Eigen::Vector3f &c = ball.centre, &n = ball.normal;
    const auto snap = static_cast<float>(snapAngle(ball.height, input.grid.cell));
    source.balls.insert(source.balls.end(),
                        {c[0], c[1], c[2], ball.radius, n[0], n[1], n[2], snap});
  }
  return source;
}

std::vector<double> stepRows(const SamplerInput& input, double farthest,
                             const ElementChunk& chunk) {
  std::vector<double> rows;
  rows.reserve(kStepNumbers * (std::size_t{chunk.placementCount} + 1));
  const std::size_t steps = input.motion.steps();
  for (std::size_t n = 0; n <= chunk.placementCount; ++n) {
    const std::size_t end = chunk.placementBase + n;  // the step ends at this placement
    if (end == 0 || end > steps) {
      rows.resize(rows.size() + kStepNumbers);
      continue;
    }
    const MotionStep step(input, end - 1);
    const double rounding = displacementRounding(step, farthest);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        rows.push_back(step.bend(row, column));
      }
      rows.push_back(step.shift[row]);
    }
    const double last[3] = {step.angle, step.snap, rounding};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        rows.push_back(step.turnBack(row, column));
      }
      rows.push_back(last[row]);
    }
  }
  return rows;
}

std::vector<ElementChunk> planChunks(const ElementSource& source, std::uint64_t bytes) {
  std::vector<ElementChunk> chunks;
  // A side patch also needs the placement after its own. The numbers of elements within a chunk
  // must fit in 32 bits.
  const std::uint64_t window = std::max<std::uint64_t>(2, bytes / kPlacementBytes);
  const std::uint64_t maxCount = std::max<std::uint64_t>(
      1, std::min<std::uint64_t>(window - 1, 0xfffffff0u / std::max(1u, source.perPlacement)));
  for (std::uint64_t base = 0; base < source.placements; base += maxCount) {
    const std::uint64_t count = std::min<std::uint64_t>(maxCount, source.placements - base);
    const std::uint64_t needed = std::min<std::uint64_t>(count + 1, source.placements - base);
    chunks.push_back({base * source.perPlacement, count * source.perPlacement,
                      static_cast<std::uint32_t>(base), static_cast<std::uint32_t>(needed)});
  }
  return chunks;
}

}  // namespace swept::gl
