// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/pair_sampler.h"

#include <Eigen/Geometry>
#include <numeric>

#include "base/parallel.h"
#include "geometry/mesh_parts.h"
#include "grid/rasterise.h"
#include "grid/snap.h"

namespace swept::dense {
namespace {

// Crossings per task: a batch has 160 tasks, enough to balance all cores.
constexpr double kTaskCrossings = 150e3;

/// Returns the expected number of crossings of a face with this area (cells^2): the sum of its
/// three projections, at most 1.74 times the area, plus one half.
double expectedCrossings(double area) { return 1.74 * area + 0.5; }

}  // namespace

PairSampler::PairSampler(const SamplerInput& input, RunContext& run)
    : input_(input), run_(run), identity_(input.motion.placements.size()) {
  placements_.reserve(input.motion.placements.size());
  for (const Placement& p : input.motion.placements) placements_.push_back(input.grid.toGrid(p));
  std::iota(identity_.begin(), identity_.end(), 0u);
  marked_.layers.resize(static_cast<std::size_t>(input.grid.points[0]));
}

void PairSampler::add(std::uint32_t face, const std::uint32_t* begin, const std::uint32_t* end) {
  if (begin != end) items_.push_back({face, begin, end});
}

void PairSampler::addWhole(std::uint32_t placement) {
  const std::uint32_t* at = identity_.data() + placement;
  for (std::uint32_t f = 0; f < input_.body.triangles.size(); ++f)
    items_.push_back({f, at, at + 1});
}

double PairSampler::workOf(std::uint32_t face) const {
  const double area = areaVector(input_.body, input_.body.triangles[face]).norm() / 2;
  return expectedCrossings(area / (input_.grid.cell * input_.grid.cell));
}

void PairSampler::sampleItem(const Item& item, RecordChunk& chunk) const {
  const auto& t = input_.body.triangles[item.face];
  const auto &a = input_.body.vertices[t[0]], &b = input_.body.vertices[t[1]],
             &c = input_.body.vertices[t[2]];
  for (const std::uint32_t* k = item.begin; k != item.end; ++k) {
    const Placement& p = placements_[*k];
    chunk.add({item.face, *k}, [&](const auto& emit) {
      rasteriseAllAxes(snap(p, a), snap(p, b), snap(p, c), emit);
    });
  }
}

/// Turns the edges marked so far into records again: two per edge, or one if its first and last
/// crossing are the same.
void PairSampler::carryOver(std::vector<RecordChunk>& chunks) {
  const std::size_t layers = marked_.layers.size();
  // Layers per task; each task writes one chunk.
  constexpr std::size_t kLayers = 16;
  const std::size_t first = chunks.size();
  chunks.resize(first + (layers + kLayers - 1) / kLayers);
  parallelBlocks(layers, kLayers, [&](std::size_t begin, std::size_t end) {
    RecordChunk& chunk = chunks[first + begin / kLayers];
    // One element often marks many adjacent edges. An element that was written a short time ago is
    // not written again.
    struct Carried {
      std::uint32_t from = 0xffffffffu, to = 0;
    };
    std::vector<Carried> recent(1024);
    const auto elementOf = [&](std::uint32_t element) {
      Carried& slot = recent[element % recent.size()];
      if (slot.from != element) {
        slot = {element, static_cast<std::uint32_t>(chunk.elements.size())};
        chunk.elements.push_back(marked_.elements[element]);
      }
      return slot.to;
    };
    // Returns the middle of the interval of numbers that a fixed-point fraction represents.
    // Rounding this middle down gives the same fraction again.
    constexpr double kHalf = 0.5 / ((1 << CrossingRecord::kFractionBits) - 1);
    const auto fractionOf = [](float f) { return std::min(static_cast<double>(f) + kHalf, 1.0); };
    for (std::size_t i = begin; i < end; ++i) {
      LayerEdges& layer = marked_.layers[i];
      for (int axis = 0; axis < 3 && !layer.columnStart[axis].empty(); ++axis) {
        const auto& start = layer.columnStart[axis];
        for (std::size_t j = 0; j + 1 < start.size(); ++j) {
          for (std::uint32_t e = start[j]; e < start[j + 1]; ++e) {
            const MarkedEdge& edge = layer.edges[axis][e];
            const auto x = static_cast<std::int32_t>(i), y = static_cast<std::int32_t>(j);
            chunk.records.push_back(CrossingRecord::make(
                axis, x, y, edge.k, fractionOf(edge.lowFraction), elementOf(edge.lowElement)));
            if (edge.highElement == edge.lowElement && edge.highFraction == edge.lowFraction) {
              continue;
            }
            chunk.records.push_back(CrossingRecord::make(
                axis, x, y, edge.k, fractionOf(edge.highFraction), elementOf(edge.highElement)));
          }
        }
      }
      layer = LayerEdges{};
    }
  });
}

void PairSampler::flush() {
  const std::size_t total = items_.size();
  std::size_t next = 0;
  while (next < total) {
    std::vector<std::pair<std::size_t, std::size_t>> tasks;
    double inBatch = 0;
    while (next < total && inBatch < kBatchWork) {
      const std::size_t begin = next;
      double inTask = 0;
      while (next < total && inTask < kTaskCrossings) {
        const auto count = static_cast<double>(items_[next].end - items_[next].begin);
        inTask += workOf(items_[next].face) * count;
        pairs_ += items_[next].end - items_[next].begin;
        ++next;
      }
      tasks.emplace_back(begin, next);
      inBatch += inTask;
    }
    std::vector<RecordChunk> chunks(tasks.size());
    parallelFor(tasks.size(), [&](std::size_t t) {
      run_.checkpoint(Phase::Sampling, next, total + 1);
      for (std::size_t i = tasks[t].first; i < tasks[t].second; ++i) {
        sampleItem(items_[i], chunks[t]);
      }
    });
    for (const RecordChunk& chunk : chunks)
      crossings_ += static_cast<std::int64_t>(chunk.records.size());
    carryOver(chunks);
    marked_ = sortRecords(chunks, input_.grid, run_);
  }
  items_.clear();
}

}  // namespace swept::dense
