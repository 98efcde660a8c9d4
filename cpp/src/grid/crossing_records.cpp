// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid/crossing_records.h"

#include <algorithm>
#include <bit>

#include "base/parallel.h"
#include "swept/types.h"

namespace swept {
namespace {

/// Collects the crossings of one column. For each lattice edge, keeps the crossing nearest to each
/// of its two ends. A bit set marks the crossed edges, so no sorting is needed.
class ColumnEnds {
 public:
  explicit ColumnEnds(std::size_t points) : ends_(points), crossed_(points / 64 + 1, 0) {}

  void add(const CrossingRecord& r) {
    Ends& ends = ends_[r.k()];
    std::uint64_t& word = crossed_[r.k() >> 6];
    const std::uint64_t bit = std::uint64_t{1} << (r.k() & 63);
    if ((word & bit) == 0) {
      word |= bit;
      ends = {r, r};
      return;
    }
    // Of several crossings at the same position, both ends keep the one whose element has the
    // smallest index.
    const auto precedes = [&](const CrossingRecord& other) {
      return r.key == other.key && r.element < other.element;
    };
    if (r.key < ends.low.key || precedes(ends.low)) ends.low = r;
    if (r.key > ends.high.key || precedes(ends.high)) ends.high = r;
  }
  /// Calls use(k, low, high) for the crossed edges in ascending order of k, and removes them from
  /// this object.
  template <class Use>
  void take(const Use& use) {
    for (std::size_t w = 0; w < crossed_.size(); ++w) {
      for (; crossed_[w] != 0; crossed_[w] &= crossed_[w] - 1) {
        const std::size_t k = w << 6 | static_cast<std::size_t>(std::countr_zero(crossed_[w]));
        use(k, ends_[k].low, ends_[k].high);
      }
    }
  }
  /// Appends the crossed edges to `edges`, and removes them from this object.
  void moveTo(std::vector<MarkedEdge>& edges) {
    take([&](std::size_t k, const CrossingRecord& low, const CrossingRecord& high) {
      MarkedEdge edge;
      edge.k = static_cast<std::uint16_t>(k);
      edge.lowElement = low.element;
      edge.lowFraction = low.fraction();
      edge.highElement = high.element;
      edge.highFraction = high.fraction();
      edges.push_back(edge);
    });
  }

 private:
  struct Ends {
    CrossingRecord low, high;
  };
  std::vector<Ends> ends_;
  std::vector<std::uint64_t> crossed_;
};

/// Sorts records stably by bucket into `out`, which grows if it is too small. forAll(use) must call
/// use(record) for every record, in the same order each time. Returns the start of every bucket and
/// the end of the last one.
template <class ForAll, class BucketOf>
std::vector<std::uint32_t> sortByBucket(std::size_t buckets, const ForAll& forAll,
                                        const BucketOf& bucketOf,
                                        std::vector<CrossingRecord>& out) {
  std::vector<std::uint32_t> start(buckets + 1, 0);
  forAll([&](const CrossingRecord& r) { ++start[bucketOf(r)]; });
  const std::uint32_t count = exclusiveScan(start);
  if (out.size() < count) out.resize(count);
  std::vector<std::uint32_t> next(start);
  forAll([&](const CrossingRecord& r) { out[next[bucketOf(r)]++] = r; });
  return start;
}

/// Sorts the records of one layer by axis and column. Keeps for every lattice edge the crossings
/// next to its ends.
void reduceLayer(const std::vector<RecordChunk>& chunks,
                 const std::vector<std::uint32_t>& elementBase, std::size_t i,
                 std::vector<CrossingRecord>& scratch, ColumnEnds& ends, std::uint32_t columns,
                 LayerEdges& layer) {
  const auto bucketOf = [&](const CrossingRecord& r) { return r.axis() * columns + r.column(); };
  const auto forRecords = [&](const auto& use) {
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      const RecordChunk& chunk = chunks[c];
      for (std::uint32_t n = chunk.layerStart[i]; n < chunk.layerStart[i + 1]; ++n) {
        const CrossingRecord& r = chunk.records[n];
        use({r.key, r.element + elementBase[c]});
      }
    }
  };
  const std::vector<std::uint32_t> start = sortByBucket(3 * columns, forRecords, bucketOf, scratch);
  for (int axis = 0; axis < 3; ++axis) {
    auto& edges = layer.edges[axis];
    auto& columnStart = layer.columnStart[axis];
    columnStart.resize(columns + 1);
    edges.reserve((start[(axis + 1) * columns] - start[axis * columns]) / 2 + 16);
    for (std::uint32_t j = 0; j < columns; ++j) {
      columnStart[j] = static_cast<std::uint32_t>(edges.size());
      const std::uint32_t bucket = axis * columns + j;
      for (std::uint32_t r = start[bucket]; r < start[bucket + 1]; ++r) ends.add(scratch[r]);
      ends.moveTo(edges);
    }
    columnStart[columns] = static_cast<std::uint32_t>(edges.size());
    edges.shrink_to_fit();
  }
}

}  // namespace

void keepEnds(std::vector<CrossingRecord>& records, const GridPlan& grid) {
  const auto columns = static_cast<std::size_t>(grid.points[1]);
  const auto bucketOf = [&](const CrossingRecord& r) {
    return (r.layer() * std::size_t{3} + r.axis()) * columns + r.column();
  };
  std::vector<CrossingRecord> sorted;
  const std::vector<std::uint32_t> start = sortByBucket(
      static_cast<std::size_t>(grid.points[0]) * 3 * columns,
      [&](const auto& use) {
        for (const auto& r : records) use(r);
      },
      bucketOf, sorted);
  records.clear();
  ColumnEnds ends(static_cast<std::size_t>(grid.points[2]));
  for (std::size_t bucket = 0; bucket + 1 < start.size(); ++bucket) {
    if (start[bucket] == start[bucket + 1]) continue;
    for (std::uint32_t r = start[bucket]; r < start[bucket + 1]; ++r) ends.add(sorted[r]);
    ends.take([&](std::size_t, const CrossingRecord& low, const CrossingRecord& high) {
      records.push_back(low);
      if (high.key != low.key) records.push_back(high);
    });
  }
}

void orderByLayer(RecordChunk& chunk, const GridPlan& grid, std::vector<CrossingRecord>& spare) {
  spare.swap(chunk.records);
  chunk.records = {};
  chunk.layerStart = sortByBucket(
      static_cast<std::size_t>(grid.points[0]),
      [&](const auto& use) {
        for (const auto& r : spare) use(r);
      },
      [](const CrossingRecord& r) { return r.layer(); }, chunk.records);
  spare.clear();
}

MarkedEdges sortRecords(std::vector<RecordChunk>& chunks, const GridPlan& grid, RunContext& run) {
  const auto layers = static_cast<std::size_t>(grid.points[0]);
  MarkedEdges out;
  out.layers.resize(layers);

  std::vector<std::uint32_t> elementBase(chunks.size());
  std::size_t elementCount = 0;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    elementBase[c] = static_cast<std::uint32_t>(elementCount);
    elementCount += chunks[c].elements.size();
  }
  if (elementCount > 0xffffffffu) {
    throw Error(
        Status::ResourceLimit, "ResourceLimit",
        "the sweep has " + std::to_string(elementCount) +
            " surface elements, but the limit is 4294967295; use fewer poses (for example with "
            "a position filter), a larger chord tolerance or a coarser part");
  }
  out.elements.resize(elementCount);
  parallelFor(chunks.size(), [&](std::size_t c) {
    RecordChunk& chunk = chunks[c];
    std::vector<CrossingRecord> spare;
    if (chunk.layerStart.empty()) orderByLayer(chunk, grid, spare);
    std::copy(chunk.elements.begin(), chunk.elements.end(), out.elements.begin() + elementBase[c]);
    std::vector<SweptElement>().swap(chunk.elements);
  });
  run.checkpoint(Phase::Sampling, 9, 10);
  const auto columns = static_cast<std::uint32_t>(grid.points[1]);
  parallelBlocks(layers, 4, [&](std::size_t begin, std::size_t end) {
    std::vector<CrossingRecord> scratch;
    ColumnEnds ends(static_cast<std::size_t>(grid.points[2]));
    for (std::size_t layer = begin; layer < end; ++layer) {
      reduceLayer(chunks, elementBase, layer, scratch, ends, columns, out.layers[layer]);
    }
  });
  return out;
}

}  // namespace swept
