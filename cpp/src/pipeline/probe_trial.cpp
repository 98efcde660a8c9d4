// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/probe_trial.h"

#include <algorithm>
#include <numeric>

#include "base/sort_unique.h"
#include "base/timer.h"
#include "contour/cell.h"
#include "contour/dual_surface.h"
#include "crossings/element_probe.h"

namespace swept {
namespace {

/// At least kMinCells cells are tried, unless they take more than kMinSeconds of CPU time.
constexpr std::size_t kMinCells = 48;
constexpr double kMinSeconds = 0.6;
/// Further cells are tried for the fraction kProbePart of the expected CPU time of all cells, but
/// at least for kProbeSeconds and at most for kMaxSeconds.
constexpr double kProbeSeconds = 0.15, kProbePart = 0.03, kMaxSeconds = 2;

using CellKey = std::uint64_t;
constexpr int kKeyBits = 20;

CellKey keyOf(const Eigen::Vector3i& at) {
  return static_cast<CellKey>(at[0]) << 2 * kKeyBits | static_cast<CellKey>(at[1]) << kKeyBits |
         static_cast<CellKey>(at[2]);
}

Eigen::Vector3i cellOf(CellKey key) {
  constexpr CellKey kMask = (CellKey{1} << kKeyBits) - 1;
  return {static_cast<int>(key >> 2 * kKeyBits), static_cast<int>(key >> kKeyBits & kMask),
          static_cast<int>(key & kMask)};
}

/// Scrambles a number, so that sorted results have no pattern.
std::uint64_t scrambled(std::uint64_t key) {
  key = (key ^ key >> 31) * 0x9e3779b97f4a7c15u;
  return (key ^ key >> 29) * 0xbf58476d1ce4e5b9u;
}

/// Returns the cells at edges with crossings, in an order without a pattern.
std::vector<CellKey> shuffledCells(const HermiteGrid& grid) {
  std::vector<CellKey> cells;
  for (std::size_t i = 0; i < grid.layers.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& start = grid.layers[i].columnStart[axis];
      for (std::size_t j = 0; j + 1 < start.size(); ++j) {
        for (std::uint32_t e = start[j]; e < start[j + 1]; ++e) {
          for (int n = 0; n < 4; ++n) {
            Eigen::Vector3i at(static_cast<int>(i), static_cast<int>(j),
                               grid.layers[i].edges[axis][e].k);
            at[(axis + 1) % 3] -= n & 1;
            at[(axis + 2) % 3] -= n >> 1;
            if (at.minCoeff() >= 0) cells.push_back(keyOf(at));
          }
        }
      }
    }
  }
  sortUnique(cells);
  std::sort(cells.begin(), cells.end(),
            [](CellKey a, CellKey b) { return scrambled(a) < scrambled(b); });
  return cells;
}

/// A cell with a copy of its crossings. Also has, for each crossing, its index in the grid and its
/// slot (twice the edge, plus 1 for the upper end).
struct CellCopy {
  Cell cell;
  std::vector<Crossing> crossings;
  std::vector<std::uint32_t> numbers;
  std::vector<int> slots;

  CellCopy(const HermiteGrid& grid, const Eigen::Vector3i& at) {
    for (int edge = 0; edge < kEdges; ++edge) {
      const int axis = edge / 4;
      Eigen::Vector3i low = at;
      low[(axis + 1) % 3] += edge & 1;
      low[(axis + 2) % 3] += edge >> 1 & 1;
      const HermiteLayer& layer = grid.layers[static_cast<std::size_t>(low[0])];
      const HermiteEdge* found =
          findEdge(layer.edges[axis], layer.columnStart[axis], low[1], low[2]);
      if (found == nullptr) continue;
      cell.mask |= static_cast<std::uint32_t>(found->sides) << 2 * edge;
      cell.first[edge] = static_cast<std::uint32_t>(numbers.size());
      std::uint32_t number = found->first;
      for (const int end : {0, 1}) {
        if (!cell.has(2 * edge + end)) continue;
        crossings.push_back(grid.crossings[number]);
        numbers.push_back(number++);
        slots.push_back(2 * edge + end);
      }
    }
  }

  /// Moves each crossing to the point at which a probe along its edge finds the surface.
  void move(const SurfaceProbe& probe) {
    std::vector<ProbeLine> lines(slots.size());
    for (std::size_t n = 0; n < slots.size(); ++n) {
      const bool fromHigh = slots[n] % 2 != 0;
      lines[n].from = localPosition(slots[n] / 2, fromHigh ? 1 : 0);
      lines[n].to = localPosition(slots[n] / 2, fromHigh ? 0 : 1);
    }
    probe.cast({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, {}, lines);
    for (std::size_t n = 0; n < slots.size(); ++n) {
      if (!lines[n].hit) continue;
      crossings[n] = {static_cast<float>(lines[n].point[slots[n] / 8]),
                      lines[n].normal.cast<float>(), static_cast<float>(lines[n].timeSeconds)};
    }
  }
};

/// Casts the probes of one cell, in coordinates whose origin is the corner of the cell. Counts the
/// casts and measures their time.
class CellProbe : public SurfaceProbe {
 public:
  /// `starts`: every search begins with the elements of these crossings.
  CellProbe(const ElementProbe& whole, const Eigen::Vector3d& corner,
            const std::vector<std::uint32_t>& starts)
      : whole_(whole), corner_(corner), starts_(starts) {}

  void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>&,
            std::vector<ProbeLine>& lines) const override {
    const double start = threadSeconds();
    move(lines, corner_);
    whole_.cast({region.min() + corner_, region.max() + corner_}, starts_, lines);
    move(lines, -corner_);
    cost_.seconds += threadSeconds() - start;
    cost_.casts += 1;
  }
  const ProbeCost& cost() const { return cost_; }

 private:
  static void move(std::vector<ProbeLine>& lines, const Eigen::Vector3d& by) {
    for (ProbeLine& line : lines) {
      line.from += by;
      line.to += by;
      line.point += by;
    }
  }

  const ElementProbe& whole_;
  Eigen::Vector3d corner_;
  const std::vector<std::uint32_t>& starts_;
  mutable ProbeCost cost_;
};

/// Returns the element of the whole motion that corresponds to an element of the rough motion.
/// `seconds`: time of the crossing on this element.
SweptElement elementOfWhole(SweptElement element, const Motion& whole, const Motion& rough,
                            double seconds) {
  const auto& all = whole.placements;
  if (!element.isSidePatch()) seconds = rough.placements[element.placement].timeSeconds;
  const auto after = std::upper_bound(
      all.begin(), all.end(), seconds,
      [](double t, const Placement& placement) { return t < placement.timeSeconds; });
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - all.begin(), 1)) - 1;
  const std::size_t last = element.isSidePatch() ? whole.steps() - 1 : all.size() - 1;
  element.placement = static_cast<std::uint32_t>(std::min(at, last));
  return element;
}

}  // namespace

ProbeCost tryProbes(const SamplerInput& whole, const RoughSweep& rough,
                    ComponentMethod components) {
  const HermiteGrid& grid = rough.hermite;
  std::vector<SweptElement> elements;
  for (std::size_t n = 0; n < grid.crossings.size(); ++n) {
    elements.push_back(elementOfWhole(rough.marked.elements[grid.winner[n]], whole.motion,
                                      rough.motion, grid.crossings[n].timeSeconds));
  }
  std::vector<std::uint32_t> elementOf(elements.size());
  std::iota(elementOf.begin(), elementOf.end(), 0u);
  const ElementProbe probe(whole, elements, elementOf, grid);
  const std::vector<CellKey> cells = shuffledCells(grid);
  const double start = threadSeconds();
  ProbeCost cost;
  std::size_t done = 0;
  const auto times = [&] { return static_cast<double>(cells.size()) / static_cast<double>(done); };
  const auto continues = [&] {
    const double seconds = threadSeconds() - start;
    if (done < kMinCells) return seconds < kMinSeconds;
    return seconds < std::clamp(kProbePart * cost.seconds * times(), kProbeSeconds, kMaxSeconds);
  };
  for (; done < cells.size() && continues(); ++done) {
    const Eigen::Vector3i at = cellOf(cells[done]);
    CellCopy copy(grid, at);
    copy.move(CellProbe(probe, at.cast<double>(), copy.numbers));
    const CellProbe counter(probe, at.cast<double>(), copy.numbers);
    probeCell(copy.cell, copy.crossings, components, counter);
    cost.casts += counter.cost().casts;
    cost.seconds += counter.cost().seconds;
  }
  if (done == 0) return cost;
  return {cost.casts * times(), cost.seconds * times()};
}

}  // namespace swept
