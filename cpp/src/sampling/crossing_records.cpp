// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/crossing_records.h"

#include <algorithm>

#include "base/parallel.h"
#include "swept/types.h"

namespace swept {
namespace {

bool before(const CrossingRecord& x, const CrossingRecord& y) {
  return x.key != y.key ? x.key < y.key : x.element < y.element;
}

/// Sorts the records of one layer (by axis and column, then within each) and keeps of every lattice
/// edge the crossing next to either end.
void reduceLayer(std::vector<CrossingRecord>& records, std::vector<CrossingRecord>& scratch,
                 std::uint32_t columns, LayerEdges& layer) {
  const auto bucketOf = [&](const CrossingRecord& r) { return r.axis() * columns + r.column(); };
  std::vector<std::uint32_t> start(3 * columns + 1, 0);
  for (const auto& r : records) ++start[bucketOf(r)];
  exclusiveScan(start);
  scratch.resize(records.size());
  {
    std::vector<std::uint32_t> next(start);
    for (const auto& r : records) scratch[next[bucketOf(r)]++] = r;
  }
  for (int axis = 0; axis < 3; ++axis) {
    auto& edges = layer.edges[axis];
    auto& columnStart = layer.columnStart[axis];
    columnStart.resize(columns + 1);
    edges.reserve((start[(axis + 1) * columns] - start[axis * columns]) / 2 + 16);
    for (std::uint32_t j = 0; j < columns; ++j) {
      columnStart[j] = static_cast<std::uint32_t>(edges.size());
      const auto begin = scratch.begin() + start[axis * columns + j];
      const auto end = scratch.begin() + start[axis * columns + j + 1];
      std::sort(begin, end, before);
      for (auto r = begin; r != end;) {
        auto last = r;
        while (last + 1 != end && (last + 1)->key >> 23 == r->key >> 23) ++last;
        MarkedEdge edge;
        edge.k = static_cast<std::uint16_t>(r->k());
        edge.lowElement = r->element;
        edge.lowFraction = r->fraction();
        // Of equal highest positions take the first element, as at the low end.
        auto high = last;
        while (high != r && (high - 1)->key == last->key) --high;
        edge.highElement = high->element;
        edge.highFraction = high->fraction();
        edges.push_back(edge);
        r = last + 1;
      }
    }
    columnStart[columns] = static_cast<std::uint32_t>(edges.size());
    edges.shrink_to_fit();
  }
}

}  // namespace

MarkedEdges sortRecords(std::vector<RecordChunk>& chunks, const GridPlan& grid, RunContext& run) {
  const auto layers = static_cast<std::size_t>(grid.points[0]);
  MarkedEdges out;
  out.layers.resize(layers);

  // How many records each chunk sends to each layer, and where they go.
  std::vector<std::vector<std::uint32_t>> place(chunks.size());
  std::vector<std::uint32_t> elementBase(chunks.size());
  parallelFor(chunks.size(), [&](std::size_t c) {
    place[c].assign(layers, 0);
    for (const auto& r : chunks[c].records) ++place[c][r.layer()];
  });
  std::size_t elementCount = 0;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    elementBase[c] = static_cast<std::uint32_t>(elementCount);
    elementCount += chunks[c].elements.size();
  }
  if (elementCount > 0xffffffffu) {
    throw Error(Status::ResourceLimit, "ResourceLimit",
                "the sweep has " + std::to_string(elementCount) +
                    " surface elements, the limit is 4294967295; use fewer placements");
  }
  std::vector<std::vector<CrossingRecord>> byLayer(layers);
  parallelFor(layers, [&](std::size_t layer) {
    std::uint32_t sum = 0;
    for (auto& counts : place) {
      const std::uint32_t count = counts[layer];
      counts[layer] = sum;
      sum += count;
    }
    byLayer[layer].resize(sum);
  });
  out.elements.resize(elementCount);
  parallelFor(chunks.size(), [&](std::size_t c) {
    RecordChunk& chunk = chunks[c];
    for (CrossingRecord r : chunk.records) {
      r.element += elementBase[c];
      byLayer[r.layer()][place[c][r.layer()]++] = r;
    }
    std::copy(chunk.elements.begin(), chunk.elements.end(), out.elements.begin() + elementBase[c]);
    chunk = RecordChunk{};
    std::vector<std::uint32_t>().swap(place[c]);
  });
  run.checkpoint(Phase::Sampling, 9, 10);
  const auto columns = static_cast<std::uint32_t>(grid.points[1]);
  parallelBlocks(layers, 4, [&](std::size_t begin, std::size_t end) {
    std::vector<CrossingRecord> scratch;
    for (std::size_t layer = begin; layer < end; ++layer) {
      reduceLayer(byLayer[layer], scratch, columns, out.layers[layer]);
      std::vector<CrossingRecord>().swap(byLayer[layer]);
    }
  });
  return out;
}

}  // namespace swept
