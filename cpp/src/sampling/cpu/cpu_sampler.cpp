// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "base/memory.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "grid/crossing_records.h"
#include "grid/rasterise.h"
#include "grid/snap.h"
#include "sampling/cpu/sample_cache.h"
#include "sampling/cpu/work_items.h"
#include "sampling/culling/inside_map.h"
#include "sampling/culling/step_blocks.h"
#include "sampling/culling/swept_elements.h"
#include "sampling/sampler.h"

namespace swept {
namespace {

/// Counts the crossings of all work items together, and stops a run that would exceed its memory
/// limit. If large faces turn, thousands of side patches overlap, so their number of crossings
/// cannot be estimated in advance.
class CrossingBudget {
 public:
  CrossingBudget(const RunContext& run, double cell) : limit_(memoryLimit(run)), cell_(cell) {}

  /// Adds a number of crossings. After crossings were thinned, the caller passes a negative number,
  /// converted to unsigned; the sum then wraps around to the correct value.
  void add(std::size_t crossings) {
    const std::uint64_t bytes = kBytes * (taken_ += crossings);
    if (limit_ == 0 || bytes <= limit_) return;
    throw Error(Status::ResourceLimit, "ResourceLimit",
                textOf(4, "the moving faces cross the grid more than ", limit_ / kBytes,
                       " times, which needs more memory than the limit of ", limit_ / 1'000'000,
                       " MB; use a cell larger than ", cell_,
                       " mm, a larger chord tolerance or a shorter motion"));
  }

 private:
  // Each crossing counts twice: sorting needs a second array of the same size.
  static constexpr std::uint64_t kBytes = 2 * sizeof(CrossingRecord);
  std::uint64_t limit_;
  double cell_;
  std::atomic<std::uint64_t> taken_{0};
};

/// The vertices of the body at one placement. Each is computed at its first use.
class PosedVertices {
 public:
  explicit PosedVertices(const SamplerInput& input)
      : input_(&input),
        points_(input.body.vertices.size()),
        knownAt_(input.body.vertices.size(), kNowhere) {}

  void goTo(std::size_t placement) {
    if (placement == placement_) return;
    placement_ = static_cast<std::uint32_t>(placement);
    pose_ = input_->grid.toGrid(input_->motion.placements[placement]);
  }
  std::size_t placement() const { return placement_; }
  const SnappedPoint& operator[](std::int32_t v) {
    const auto at = static_cast<std::size_t>(v);
    if (knownAt_[at] != placement_) {
      points_[at] = snap(pose_, input_->body.vertices[at]);
      knownAt_[at] = placement_;
    }
    return points_[at];
  }

 private:
  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  const SamplerInput* input_;
  std::uint32_t placement_ = kNowhere;
  Placement pose_;
  std::vector<SnappedPoint> points_;
  std::vector<std::uint32_t> knownAt_;  // placement at which the point was computed
};

/// Rasterises the elements of one work item along all three axes.
class ItemSampler {
 public:
  ItemSampler(const SamplerInput& input, RecordChunk& out) : input_(input), out_(out) {}

  void face(std::size_t f, std::size_t placement, PosedVertices& posed) {
    const auto& t = input_.body.triangles[f];
    const SnappedPoint &a = posed[t[0]], &b = posed[t[1]], &c = posed[t[2]];
    if (isHidden(SnappedBox(a, b, c))) return;
    out_.add({static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(placement)},
             [&](const auto& emit) { rasteriseAllAxes(a, b, c, unlessHidden(emit)); });
  }
  void sidePatch(std::size_t edge, const FaceClusters::EdgeEnds& e, std::size_t step,
                 PosedVertices& now, PosedVertices& next) {
    const SnappedPoint &a = now[e.a], &b = now[e.b], &c = next[e.b], &d = next[e.a];
    if (isHidden(SnappedBox(a, b, c, d))) return;
    const auto code = static_cast<std::uint32_t>(edge) | SweptElement::kSidePatchBit;
    out_.add({code, static_cast<std::uint32_t>(step)}, [&](const auto& emit) {
      rasteriseAllAxes(a, b, c, unlessHidden(emit));
      rasteriseAllAxes(a, c, d, unlessHidden(emit));
    });
  }
  /// Once there are many crossings, removes those that are neither first nor last on their lattice
  /// edge. Faces that slide within their own surface cause many such crossings, because they cross
  /// the same edges at every placement. `last`: true for the last call of the item.
  void thin(bool last) {
    if (out_.records.size() < limit_ && !(last && thinned_)) return;
    keepEnds(out_.records, input_.grid);
    limit_ = std::max(limit_, 2 * out_.records.size());
    thinned_ = true;
  }

 private:
  template <class Emit>
  auto unlessHidden(const Emit& emit) const {
    return [&emit, inside = input_.inside](int axis, std::int32_t i, std::int32_t j, std::int32_t k,
                                           double fraction) {
      if (inside == nullptr || !inside->hides(axis, i, j, k, fraction)) {
        emit(axis, i, j, k, fraction);
      }
    };
  }
  /// Returns whether an element with this bounding box has no crossing that can matter. Most
  /// elements with small triangles meet no lattice line.
  bool isHidden(const SnappedBox& box) const {
    if (!box.meetsLines()) return true;
    if (input_.inside == nullptr) return false;
    Eigen::Array3d from, to;
    for (int axis = 0; axis < 3; ++axis) {
      from[axis] = static_cast<double>(box.low[axis]) / kSubUnits;
      to[axis] = static_cast<double>(box.high[axis]) / kSubUnits;
    }
    return input_.inside->hides(from, to);
  }

  const SamplerInput& input_;
  RecordChunk& out_;
  bool thinned_ = false;
  std::size_t limit_ =
      std::max(kMinThinRecords, 3 * static_cast<std::size_t>(input_.grid.points[0]) *
                                    static_cast<std::size_t>(input_.grid.points[1]));
};

/// Samples one work item of a union of copies.
class UnionSampler {
 public:
  /// `posed` is shared by all items of one thread, since these often have the same placement.
  UnionSampler(const SamplerInput& input, PosedVertices& posed, RecordChunk& out,
               CrossingBudget& budget)
      : input_(input), sampler_(input, out), out_(out), budget_(budget), posed_(posed) {}

  void sampleAll(const WorkItem& item, RunContext& run) {
    for (std::size_t k = item.begin; k < item.end; ++k) {
      run.checkpoint(Phase::Sampling);
      posed_.goTo(k);
      for (std::size_t f = item.faceBegin; f < item.faceEnd; ++f) sampler_.face(f, k, posed_);
      count(item, k + 1 == item.end);
    }
  }
  /// Samples only the faces that can matter (step_blocks.h).
  void sampleShown(const WorkItem& item, const FaceClusters& clusters,
                   const PlacementGroups& groups, RunContext& run) {
    StepBlocks blocks(input_, clusters, groups, item.begin, item.end);
    blocks.forPlacements([&](std::size_t) { run.checkpoint(Phase::Sampling); },
                         [&](std::size_t k, const ShownClusters& shown) {
                           run.checkpoint(Phase::Sampling);
                           posed_.goTo(k);
                           for (const ShownCluster& s : shown) {
                             const FaceCluster& cluster = clusters.clusters[s.cluster];
                             for (std::uint32_t n = 0; n < cluster.faceCount; ++n) {
                               if (s.shows(n))
                                 sampler_.face(clusters.faces[cluster.firstFace + n], k, posed_);
                             }
                           }
                           count(item, false);
                         });
    count(item, true);
  }

 private:
  void count(const WorkItem& item, bool last) {
    if (item.end - item.begin >= kMinThinPlacements) sampler_.thin(last);
    budget_.add(out_.records.size() - before_);
    before_ = out_.records.size();
  }

  const SamplerInput& input_;
  ItemSampler sampler_;
  const RecordChunk& out_;
  CrossingBudget& budget_;
  PosedVertices& posed_;
  std::size_t before_ = 0;
};

/// Samples one work item of a continuous motion.
class SweepSampler {
 public:
  SweepSampler(const SamplerInput& input, const FaceClusters& clusters,
               const PlacementGroups& groups, RecordChunk& out, CrossingBudget& budget)
      : input_(input),
        clusters_(clusters),
        groups_(groups),
        steps_(input.motion.steps()),
        kept_(input, clusters),
        sampler_(input, out),
        out_(out),
        budget_(budget),
        now_(input),
        next_(input) {}

  void sample(const WorkItem& item, RunContext& run) {
    StepBlocks blocks(input_, clusters_, groups_, item.begin, item.end);
    std::size_t before = 0;
    const auto count = [&] {
      budget_.add(out_.records.size() - before);
      before = out_.records.size();
    };
    const bool thins = item.end - item.begin >= kMinThinPlacements;
    blocks.forPlacements(
        [&](std::size_t k) { run.checkpoint(Phase::Sampling, k, steps_); },
        [&](std::size_t k, const ShownClusters& shown) {
          run.checkpoint(Phase::Sampling, k, steps_);
          if (next_.placement() == k) std::swap(now_, next_);
          now_.goTo(k);
          kept_.goTo(k);
          kept_.forFaces(shown, [&](std::uint32_t f) { sampler_.face(f, k, now_); });
          if (k < steps_) {
            next_.goTo(k + 1);
            kept_.forPatches(shown, [&](std::uint32_t e, const FaceClusters::EdgeEnds& ends) {
              sampler_.sidePatch(e, ends, k, now_, next_);
            });
          }
          if (thins) sampler_.thin(false);
          count();
        });
    if (thins) sampler_.thin(true);
    count();
  }

 private:
  const SamplerInput& input_;
  const FaceClusters& clusters_;
  const PlacementGroups& groups_;
  std::size_t steps_;
  KeptElements kept_;
  ItemSampler sampler_;
  const RecordChunk& out_;
  CrossingBudget& budget_;
  PosedVertices now_, next_;
};

}  // namespace

MarkedEdges sampleCpu(const SamplerInput& input, RunContext& run) {
  const std::vector<WorkItem> items = workItems(input);
  std::vector<RecordChunk> chunks(items.size());
  FaceClusters own;
  const bool byClusters = input.motion.continuous || input.inside != nullptr;
  const FaceClusters& clusters =
      byClusters || input.clusters != nullptr ? clustersOf(input, own) : own;
  // Finds the steps that the previous run has sampled already. The cache only keeps items of one
  // placement.
  std::vector<SampleCache::Key> keys;
  std::vector<std::uint8_t> cached(items.size(), 0);
  if (input.cache != nullptr && input.motion.continuous && items.front().end == 1) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      keys.push_back(SampleCache::keyOf(input, items[i].begin));
      cached[i] = input.cache->find(keys[i], items[i].begin, chunks[i]);
      if (cached[i] != 0) input.cache->countHit();
    }
  }
  std::optional<PlacementGroups> ownGroups;
  if (input.groups == nullptr) ownGroups.emplace(input, clusters, run);
  const PlacementGroups& groups = input.groups != nullptr ? *input.groups : *ownGroups;
  CrossingBudget budget(run, input.grid.cell);
  // Each thread has its own buffers, which keep their capacity, and its own posed vertices for a
  // union.
  tbb::enumerable_thread_specific<std::vector<CrossingRecord>> buffers;
  tbb::enumerable_thread_specific<PosedVertices> posed([&] { return PosedVertices(input); });
  parallelFor(items.size(), [&](std::size_t i) {
    if (cached[i] != 0) return;
    std::vector<CrossingRecord>& buffer = buffers.local();
    chunks[i].records.swap(buffer);
    if (input.motion.continuous) {
      SweepSampler(input, clusters, groups, chunks[i], budget).sample(items[i], run);
    } else {
      UnionSampler sampler(input, posed.local(), chunks[i], budget);
      if (byClusters)
        sampler.sampleShown(items[i], clusters, groups, run);
      else
        sampler.sampleAll(items[i], run);
    }
    orderByLayer(chunks[i], input.grid, buffer);
  });
  buffers.clear();
  posed.clear();
  if (!keys.empty()) input.cache->replace(keys, chunks);
  if (input.crossings != nullptr) {
    *input.crossings = 0;
    for (const RecordChunk& chunk : chunks) *input.crossings += chunk.records.size();
  }
  run.checkpoint(Phase::Sampling, 8, 10);
  return sortRecords(chunks, input.grid, run);
}

}  // namespace swept
