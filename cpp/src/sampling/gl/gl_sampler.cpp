// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_sampler.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "base/parallel.h"
#include "grid/crossing_records.h"
#include "signs/contributing_edges.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

// How many times the device is opened again after a loss. If it is lost once more, the sampler
// fails.
constexpr int kReopenings = 1;
constexpr float kFractionUnits = (1 << CrossingRecord::kFractionBits) - 1;

/// Appends the marked edges of one brick to the grid layers that it covers, after the edges of
/// earlier bricks. `columns` receives the j of each edge.
void collect(const Brick& brick, const std::vector<std::uint32_t>& marks,
             std::vector<LayerEdges>& layers, std::vector<std::vector<std::uint32_t>>& columns) {
  const auto words = static_cast<std::size_t>(brick.words());
  parallelFor(static_cast<std::size_t>(brick.size[0]), [&](std::size_t layer) {
    const std::size_t i = static_cast<std::size_t>(brick.low[0]) + layer;
    for (int axis = 0; axis < 3; ++axis) {
      auto& edges = layers[i].edges[axis];
      auto& column = columns[3 * i + static_cast<std::size_t>(axis)];
      const std::uint32_t* row =
          marks.data() + (static_cast<std::size_t>(axis * brick.size[0]) + layer) *
                             static_cast<std::size_t>(brick.size[1]) * words;
      for (std::int32_t j = 0; j < brick.size[1]; ++j, row += words) {
        for (std::size_t w = 0; w < words; ++w) {
          for (std::uint32_t bits = row[w]; bits != 0; bits &= bits - 1) {
            MarkedEdge edge;
            edge.k = static_cast<std::uint16_t>(brick.low[2] + static_cast<std::int32_t>(32 * w) +
                                                std::countr_zero(bits));
            edges.push_back(edge);
            column.push_back(static_cast<std::uint32_t>(brick.low[1] + j));
          }
        }
      }
    }
  });
}

/// Computes where the columns start. Sorts the edges by column first if bricks were cut along z.
void finishLayer(LayerEdges& layer, int axis, std::vector<std::uint32_t>& column,
                 std::int32_t columns) {
  auto& edges = layer.edges[axis];
  if (!std::is_sorted(column.begin(), column.end())) {
    std::vector<std::uint64_t> keys(edges.size());
    for (std::size_t n = 0; n < keys.size(); ++n) {
      keys[n] = std::uint64_t{column[n]} << 16 | edges[n].k;
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t n = 0; n < keys.size(); ++n) {
      column[n] = static_cast<std::uint32_t>(keys[n] >> 16);
      edges[n].k = static_cast<std::uint16_t>(keys[n]);
    }
  }
  auto& start = layer.columnStart[axis];
  start.assign(static_cast<std::size_t>(columns) + 1, 0);
  for (const std::uint32_t c : column) ++start[c];
  exclusiveScan(start);
  edges.shrink_to_fit();
}

/// Returns whether all edges of layer i end inside the grid. Later steps rely on this.
bool staysInGrid(const LayerEdges& layer, std::int32_t i, const GridPlan& grid) {
  const auto& n = grid.points;
  if (i + 1 >= n[0] && !layer.edges[0].empty()) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t maxCount = axis == 2 ? n[2] - 2 : n[2] - 1;
    for (const MarkedEdge& edge : layer.edges[axis]) {
      if (edge.k > maxCount) return false;
    }
  }
  const auto& start = layer.columnStart[1];
  return start[static_cast<std::size_t>(n[1]) - 1] == start[static_cast<std::size_t>(n[1])];
}

/// Returns the first element number of each epoch, and the end. Element numbers on the device have
/// 32 bits, so an epoch consists of successive whole chunks with at most `maxElements` elements.
std::vector<std::uint64_t> epochsOf(const std::vector<ElementChunk>& chunks, std::uint64_t count,
                                    std::uint64_t maxElements) {
  std::vector<std::uint64_t> epochs{0};
  for (const ElementChunk& chunk : chunks) {
    const bool tooMany = chunk.first + chunk.count - epochs.back() > maxElements;
    if (tooMany && chunk.first > epochs.back()) epochs.push_back(chunk.first);
  }
  epochs.push_back(count);
  return epochs;
}

/// The first and last crossing of an edge in all epochs so far.
struct BestCrossings {
  std::uint32_t low = 0xffffffffu, high = 0;
  std::uint64_t lowElement = ~std::uint64_t{0}, highElement = ~std::uint64_t{0};

  /// Merges the winners of an epoch into the best crossings. `epoch`: number of its first element.
  void add(const EdgeWinner& w, std::uint64_t epoch) {
    if (w.lowElement != EdgeWinner::kNone && w.lowFraction < low) {
      low = w.lowFraction;
      lowElement = epoch + w.lowElement;
    }
    const bool first = highElement == ~std::uint64_t{0};
    if (w.highElement != EdgeWinner::kNone && (first || w.highFraction > high)) {
      high = w.highFraction;
      highElement = epoch + w.highElement;
    }
  }
};

}  // namespace

GlSampler::GlSampler(const SamplerInput& input, OpenDevice openDevice, const GlSettings& settings)
    : input_(input),
      openDevice_(std::move(openDevice)),
      settings_(settings),
      source_(planElements(input)) {
  open();
  bricks_ = planBricks(input.grid, device_->context->limits(), settings_.budgetBytes / 2);
}

GlSampler::~GlSampler() = default;

void GlSampler::open() {
  passes_.reset();
  device_.reset();
  device_ = openDevice_();
  deviceName_ = device_->context->device();
  passes_ = std::make_unique<GlPasses>(*device_, input_, source_, settings_);
}

/// Runs work(). If the device is lost, runs it once more on a new context.
template <class Work>
auto GlSampler::withDevice(const Work& work) {
  for (;;) {
    try {
      return work();
    } catch (const Error& error) {
      if (error.status() != Status::DeviceLost || reopened_ >= kReopenings) throw;
      ++reopened_;
    }
    open();
  }
}

double GlSampler::expectedSeconds(RunContext& run) {
  // Pass 2 goes over all elements twice, so both passes together make three rounds.
  constexpr double kRounds = 3;
  // Seconds per byte of marks, for transfers and for the work of the CPU. Measured: 0.68 s for 190
  // MB with an H200 and 16 cores (bunny_keys16 at 1024 cells).
  constexpr double kSecondsPerByte = 3.6e-9;
  const auto afterDispatch = [&] { run.checkpoint(Phase::Sampling); };
  const double pass = passes_->expectedSeconds(bricks_[bricks_.size() / 2], afterDispatch);
  double bytes = 0;
  for (const Brick& brick : bricks_) bytes += 4 * static_cast<double>(brick.markWords());
  return kRounds * static_cast<double>(bricks_.size()) * pass + kSecondsPerByte * bytes;
}

MarkedEdges GlSampler::mark(RunContext& run) {
  const auto layers = static_cast<std::size_t>(input_.grid.points[0]);
  MarkedEdges out;
  out.layers.resize(layers);
  std::vector<std::vector<std::uint32_t>> columns(3 * layers);
  std::uint64_t done = 0;
  const auto afterDispatch = [&] { run.checkpoint(Phase::Sampling, done, 2 * bricks_.size()); };
  for (const Brick& brick : bricks_) {
    const auto marks = withDevice([&] { return passes_->mark(brick, afterDispatch); });
    collect(brick, marks, out.layers, columns);
    ++done;
  }
  parallelFor(3 * layers, [&](std::size_t n) {
    finishLayer(out.layers[n / 3], static_cast<int>(n % 3), columns[n], input_.grid.points[1]);
    std::vector<std::uint32_t>().swap(columns[n]);
  });
  for (std::size_t i = 0; i < layers; ++i) {
    if (!staysInGrid(out.layers[i], static_cast<std::int32_t>(i), input_.grid)) {
      reportGarbage(deviceName_, "pass 1 marked an edge beyond the grid");
    }
  }
  return out;
}

void GlSampler::resolveBrick(const Brick& brick, MarkedEdges& marked, const SignRuns& signs,
                             const std::function<void()>& afterDispatch) {
  struct Contributing {
    Target target;
    MarkedEdge* edge;
  };
  const auto layers = static_cast<std::size_t>(brick.size[0]);
  const std::vector<Contributing> all =
      gather<Contributing>(3 * layers, 1, [&](std::size_t n, std::vector<Contributing>& part) {
        const auto axis = static_cast<int>(n / layers);
        const auto i = brick.low[0] + static_cast<std::int32_t>(n % layers);
        forContributing(
            marked, signs, input_.grid, i, axis,
            [&](std::int32_t j, MarkedEdge& edge, std::uint8_t) {
              const std::int32_t row = j - brick.low[1], k = edge.k - brick.low[2];
              if (row < 0 || row >= brick.size[1] || k < 0 || k >= brick.size[2]) return;
              const std::size_t rows = n * static_cast<std::size_t>(brick.size[1]);
              part.push_back({{static_cast<std::uint32_t>(rows) + static_cast<std::uint32_t>(row),
                               static_cast<std::uint32_t>(k)},
                              &edge});
            });
      });
  const std::vector<std::uint64_t> epochs =
      epochsOf(passes_->chunks(), source_.count(), settings_.epochElements);
  constexpr std::size_t kBlock = 65536;
  std::vector<Target> targets;
  for (std::size_t begin = 0; begin < all.size(); begin += targets.size()) {
    targets.resize(std::min(passes_->maxTargets(), all.size() - begin));
    parallelBlocks(targets.size(), kBlock, [&](std::size_t from, std::size_t to) {
      for (std::size_t n = from; n < to; ++n) targets[n] = all[begin + n].target;
    });
    std::vector<BestCrossings> best(targets.size());
    for (std::size_t e = 0; e + 1 < epochs.size(); ++e) {
      const auto found =
          passes_->findWinners(brick, targets, epochs[e], epochs[e + 1], afterDispatch);
      parallelBlocks(found.size(), kBlock, [&](std::size_t from, std::size_t to) {
        for (std::size_t n = from; n < to; ++n) best[n].add(found[n], epochs[e]);
      });
    }
    const std::size_t before = winners_.size();
    winners_.resize(before + 2 * best.size());
    parallelBlocks(best.size(), kBlock, [&](std::size_t from, std::size_t to) {
      for (std::size_t n = from; n < to; ++n) {
        const BestCrossings& b = best[n];
        if (b.lowElement >= source_.count() || b.highElement >= source_.count()) {
          reportGarbage(deviceName_, "pass 2 found no surface on an edge that pass 1 marked");
        }
        MarkedEdge& edge = *all[begin + n].edge;
        const std::size_t at = before + 2 * n;
        edge.lowFraction = static_cast<float>(b.low) / kFractionUnits;
        edge.highFraction = static_cast<float>(b.high) / kFractionUnits;
        winners_[at] = b.lowElement;
        winners_[at + 1] = b.highElement;
        edge.lowElement = static_cast<std::uint32_t>(at);
        edge.highElement = static_cast<std::uint32_t>(at + 1);
      }
    });
  }
}

void GlSampler::resolve(MarkedEdges& marked, const SignRuns& signs, RunContext& run) {
  std::uint64_t done = bricks_.size();
  const auto afterDispatch = [&] { run.checkpoint(Phase::Signs, done, 2 * bricks_.size()); };
  winners_.clear();
  for (const Brick& brick : bricks_) {
    const std::size_t before = winners_.size();
    withDevice([&] {
      winners_.resize(before);
      resolveBrick(brick, marked, signs, afterDispatch);
    });
    ++done;
  }
  if (winners_.size() > 0xfffffff0u) {
    throw Error(Status::ResourceLimit, "ResourceLimit",
                "the envelope has " + std::to_string(winners_.size()) +
                    " grid crossings, but the limit is 4294967280; use a larger cell");
  }
  // So far the edges refer to winners_, in order of discovery. Now each element is stored once, in
  // the order of the element numbers, and the edges get the indices of their elements.
  std::vector<std::uint64_t> used(winners_);
  tbb::parallel_sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  marked.elements.clear();
  marked.elements.reserve(used.size());
  for (const std::uint64_t number : used) marked.elements.push_back(source_.at(number));
  std::vector<std::uint32_t> renumbered(winners_.size());
  parallelBlocks(winners_.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      renumbered[n] = static_cast<std::uint32_t>(
          std::lower_bound(used.begin(), used.end(), winners_[n]) - used.begin());
    }
  });
  parallelFor(3 * static_cast<std::size_t>(input_.grid.points[0]), [&](std::size_t n) {
    forContributing(marked, signs, input_.grid, static_cast<std::int32_t>(n / 3),
                    static_cast<int>(n % 3), [&](std::int32_t, MarkedEdge& edge, std::uint8_t) {
                      edge.lowElement = renumbered[edge.lowElement];
                      edge.highElement = renumbered[edge.highElement];
                    });
  });
  winners_ = {};
}

}  // namespace swept::gl
