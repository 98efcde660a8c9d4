// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "base/parallel.h"
#include "sampling/cpu/rasterise.h"
#include "sampling/crossing_records.h"
#include "sampling/sampler.h"
#include "sampling/swept_elements.h"

namespace swept {
namespace {

/// Work item: the placements [begin, end) with faces [faceBegin, faceEnd).
struct WorkItem {
  std::size_t begin, end, faceBegin, faceEnd;
};

std::vector<WorkItem> workItems(const SamplerInput& input) {
  const std::size_t placements = input.motion.placements.size();
  const std::size_t faces = input.body.triangles.size();
  std::vector<WorkItem> items;
  if (input.motion.continuous) {
    const std::size_t group = std::max<std::size_t>(1, placements / 128);
    for (std::size_t k = 0; k < placements; k += group) {
      items.push_back({k, std::min(k + group, placements), 0, faces});
    }
  } else {
    constexpr std::size_t kFaces = 8192;
    const std::size_t group = std::max<std::size_t>(1, std::min(kFaces / faces, placements / 64));
    for (std::size_t k = 0; k < placements; k += group) {
      for (std::size_t f = 0; f < faces; f += kFaces) {
        items.push_back({k, std::min(k + group, placements), f, std::min(f + kFaces, faces)});
      }
    }
  }
  return items;
}

/// Rasterises the elements of one work item along all three axes.
class ItemSampler {
 public:
  ItemSampler(const SamplerInput& input, RecordChunk& out) : input_(input), out_(out) {}

  void add(std::uint32_t code, std::uint32_t placement) {
    element_ = static_cast<std::uint32_t>(out_.elements.size());
    out_.elements.push_back({code, placement});
  }
  void triangle(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
    rasteriseTriangle<0>(a, b, c, [&](std::int32_t j, std::int32_t k, std::int32_t i, double f) {
      push(0, i, j, k, f);
    });
    rasteriseTriangle<1>(a, b, c, [&](std::int32_t i, std::int32_t k, std::int32_t j, double f) {
      push(1, i, j, k, f);
    });
    rasteriseTriangle<2>(a, b, c, [&](std::int32_t i, std::int32_t j, std::int32_t k, double f) {
      push(2, i, j, k, f);
    });
  }
  /// Forgets the last element if nothing hit the lattice.
  void finish() {
    if (out_.records.empty() || out_.records.back().element != element_) out_.elements.pop_back();
  }

  void pose(std::size_t placement, std::vector<SnappedPoint>& points) const {
    const Placement p = input_.grid.toGrid(input_.motion.placements[placement]);
    points.resize(input_.body.vertices.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      const Eigen::Vector3d g = p.apply(input_.body.vertices[v]);
      points[v] = {snapCoordinate(g[0]), snapCoordinate(g[1]), snapCoordinate(g[2])};
    }
  }

  void faces(const WorkItem& item, std::size_t placement, const std::vector<SnappedPoint>& points) {
    for (std::size_t f = item.faceBegin; f < item.faceEnd; ++f) face(f, placement, points);
  }
  void face(std::size_t f, std::size_t placement, const std::vector<SnappedPoint>& points) {
    const auto& t = input_.body.triangles[f];
    add(static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(placement));
    triangle(points[t[0]], points[t[1]], points[t[2]]);
    finish();
  }
  void patch(std::size_t edge, std::size_t step, const std::vector<SnappedPoint>& now,
             const std::vector<SnappedPoint>& next) {
    const BodyEdge& e = input_.topology.edges[edge];
    add(static_cast<std::uint32_t>(edge) | SweptElement::kPatchBit,
        static_cast<std::uint32_t>(step));
    triangle(now[e.a], now[e.b], next[e.b]);
    triangle(now[e.a], next[e.b], next[e.a]);
    finish();
  }

 private:
  void push(int axis, std::int32_t i, std::int32_t j, std::int32_t k, double fraction) {
    out_.records.push_back(CrossingRecord::make(axis, i, j, k, fraction, element_));
  }

  const SamplerInput& input_;
  RecordChunk& out_;
  std::uint32_t element_ = 0;
};

void sampleUnion(const SamplerInput& input, const WorkItem& item, RecordChunk& out,
                 RunContext& run) {
  ItemSampler sampler(input, out);
  std::vector<SnappedPoint> points;
  for (std::size_t k = item.begin; k < item.end; ++k) {
    run.checkpoint(Phase::Sampling);
    sampler.pose(k, points);
    sampler.faces(item, k, points);
  }
}

/// One work item of a continuous motion.
class SweepSampler {
 public:
  SweepSampler(const SamplerInput& input, const FaceClusters& clusters, RecordChunk& out)
      : input_(input),
        clusters_(clusters),
        sampler_(input, out),
        before_(input, clusters),
        after_(input, clusters) {}

  void sample(const WorkItem& item, RunContext& run) {
    const std::size_t steps = input_.motion.steps();
    if (item.begin > 0) before_.compute(item.begin - 1);
    sampler_.pose(item.begin, now_);
    for (std::size_t k = item.begin; k < item.end; ++k) {
      run.checkpoint(Phase::Sampling, k, steps);
      hasBefore_ = k > 0;
      hasAfter_ = k < steps;
      if (hasAfter_) after_.compute(k);
      sampleFaces(k);
      if (!hasAfter_) break;
      sampler_.pose(k + 1, next_);
      samplePatches(k);
      std::swap(before_, after_);
      std::swap(now_, next_);
    }
  }

 private:
  bool enclosed(int before, int after) const {
    return input_.cull && faceIsEnclosed(before, after, hasBefore_, hasAfter_, input_.orientable);
  }
  void sampleFaces(std::size_t k) {
    for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
      const FaceCluster& cluster = clusters_.clusters[c];
      if (enclosed(hasBefore_ ? before_.ofCluster(c) : 0, hasAfter_ ? after_.ofCluster(c) : 0)) {
        continue;
      }
      for (std::uint32_t n = 0; n < cluster.faceCount; ++n) {
        const std::uint32_t f = clusters_.faces[cluster.firstFace + n];
        if (!enclosed(hasBefore_ ? before_.ofFace(f) : 0, hasAfter_ ? after_.ofFace(f) : 0)) {
          sampler_.face(f, k, now_);
        }
      }
    }
  }
  void samplePatches(std::size_t k) {
    const auto patch = [&](std::uint32_t e) {
      if (input_.cull && patchIsEnclosed(input_.topology.edges[e], after_)) return;
      sampler_.patch(e, k, now_, next_);
    };
    for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
      if (input_.cull && after_.ofCluster(c) != 0) continue;
      const FaceCluster& cluster = clusters_.clusters[c];
      for (std::uint32_t n = 0; n < cluster.edgeCount; ++n) {
        patch(clusters_.innerEdges[cluster.firstEdge + n]);
      }
    }
    for (const FaceClusters::Border& border : clusters_.borders) {
      if (input_.cull && border.right >= 0) {
        const int left = after_.ofCluster(static_cast<std::size_t>(border.left));
        const int right = after_.ofCluster(static_cast<std::size_t>(border.right));
        if (left != 0 && left == (border.opposed ? -right : right)) continue;
      }
      for (std::uint32_t n = 0; n < border.edgeCount; ++n) {
        patch(clusters_.borderEdges[border.firstEdge + n]);
      }
    }
  }

  const SamplerInput& input_;
  const FaceClusters& clusters_;
  ItemSampler sampler_;
  FaceDirections before_, after_;
  std::vector<SnappedPoint> now_, next_;
  bool hasBefore_ = false, hasAfter_ = false;
};

}  // namespace

MarkedEdges sampleCpu(const SamplerInput& input, RunContext& run) {
  const std::vector<WorkItem> items = workItems(input);
  std::vector<RecordChunk> chunks(items.size());
  FaceClusters clusters;
  if (input.motion.continuous) clusters = buildClusters(input.body, input.topology);
  parallelFor(items.size(), [&](std::size_t i) {
    if (input.motion.continuous) {
      SweepSampler(input, clusters, chunks[i]).sample(items[i], run);
    } else {
      sampleUnion(input, items[i], chunks[i], run);
    }
  });
  run.checkpoint(Phase::Sampling, 8, 10);
  return sortRecords(chunks, input.grid, run);
}

}  // namespace swept
