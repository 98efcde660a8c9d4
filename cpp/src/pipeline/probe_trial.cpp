// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/probe_trial.h"

#include <algorithm>

#include "base/sort_unique.h"
#include "base/timer.h"
#include "contour/dual_surface.h"
#include "crossings/element_probe.h"

namespace swept {
namespace {

/// Cells are looked at for so many CPU seconds, but so many at least, unless these take far more.
constexpr double kProbeSeconds = 0.1, kMostProbeSeconds = 0.4;
constexpr std::size_t kFewestCells = 48;

using CellKey = std::uint64_t;

CellKey keyOf(std::int64_t i, std::int64_t j, std::int64_t k) {
  return static_cast<CellKey>(i) << 40 | static_cast<CellKey>(j) << 20 | static_cast<CellKey>(k);
}

Eigen::Vector3i cellOf(CellKey key) {
  constexpr CellKey kMask = (1u << 20) - 1;
  return {static_cast<int>(key >> 40), static_cast<int>(key >> 20 & kMask),
          static_cast<int>(key & kMask)};
}

/// The cells that crossings lie round, in an order without any pattern.
std::vector<CellKey> mixedCells(const HermiteGrid& grid) {
  std::vector<CellKey> cells;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(grid.layers.size()); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const HermiteLayer& layer = grid.layers[static_cast<std::size_t>(i)];
      const auto& start = layer.columnStart[axis];
      for (std::size_t j = 0; j + 1 < start.size(); ++j) {
        for (std::uint32_t e = start[j]; e < start[j + 1]; ++e) {
          for (int n = 0; n < 4; ++n) {
            Eigen::Vector3i at(static_cast<int>(i), static_cast<int>(j), layer.edges[axis][e].k);
            at[(axis + 1) % 3] -= n & 1;
            at[(axis + 2) % 3] -= n >> 1;
            if (at.minCoeff() >= 0) cells.push_back(keyOf(at[0], at[1], at[2]));
          }
        }
      }
    }
  }
  sortUnique(cells);
  const auto mixed = [](CellKey key) {
    key = (key ^ key >> 31) * 0x9e3779b97f4a7c15u;
    return (key ^ key >> 29) * 0xbf58476d1ce4e5b9u;
  };
  std::sort(cells.begin(), cells.end(), [&](CellKey a, CellKey b) { return mixed(a) < mixed(b); });
  return cells;
}

/// A probe along each edge of a cell that has crossings, from the ends that have them.
struct EdgeLines {
  std::vector<ProbeLine> lines;
  std::vector<std::uint32_t> crossings;  // of each line
  std::vector<int> axes;

  EdgeLines(const HermiteGrid& grid, const Eigen::Vector3i& cell) {
    for (int edge = 0; edge < 12; ++edge) {
      const int axis = edge / 4;
      Eigen::Vector3i low = cell;
      low[(axis + 1) % 3] += edge & 1;
      low[(axis + 2) % 3] += edge >> 1 & 1;
      const HermiteLayer& layer = grid.layers[static_cast<std::size_t>(low[0])];
      const HermiteEdge* found =
          findEdge(layer.edges[axis], layer.columnStart[axis], low[1], low[2]);
      if (found == nullptr) continue;
      const Eigen::Vector3d from = low.cast<double>();
      const Eigen::Vector3d to = from + Eigen::Vector3d::Unit(axis);
      std::uint32_t crossing = found->first;
      if ((found->sides & HermiteEdge::kLow) != 0) add(from, to, crossing++, axis);
      if ((found->sides & HermiteEdge::kHigh) != 0) add(to, from, crossing, axis);
    }
  }

 private:
  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to, std::uint32_t crossing,
           int axis) {
    lines.emplace_back();
    lines.back().from = from;
    lines.back().to = to;
    crossings.push_back(crossing);
    axes.push_back(axis);
  }
};

/// Moves the crossings of the first cells to where the whole motion has them. How many.
std::size_t moveCrossings(const std::vector<CellKey>& cells, const ElementProbe& probe,
                          HermiteGrid& grid) {
  const double start = threadSeconds();
  std::size_t done = 0;
  const auto goesOn = [&] {
    const double taken = threadSeconds() - start;
    return taken < (done < kFewestCells ? kMostProbeSeconds : kProbeSeconds);
  };
  for (; done < cells.size() && goesOn(); ++done) {
    const Eigen::Vector3i cell = cellOf(cells[done]);
    EdgeLines edges(grid, cell);
    const Eigen::Vector3d corner = cell.cast<double>();
    probe.cast({corner, corner + Eigen::Vector3d::Ones()}, edges.crossings, edges.lines);
    for (std::size_t n = 0; n < edges.lines.size(); ++n) {
      const ProbeLine& line = edges.lines[n];
      if (!line.hit) continue;
      const int axis = edges.axes[n];
      Crossing& crossing = grid.crossings[edges.crossings[n]];
      crossing.fraction =
          static_cast<float>(line.point[axis] - std::min(line.from[axis], line.to[axis]));
      crossing.normal = line.normal.cast<float>();
      crossing.timeSeconds = static_cast<float>(line.timeSeconds);
    }
  }
  return done;
}

/// Answers what is asked in some cells, and says how long that takes. For one thread.
class TimedProbe : public SurfaceProbe {
 public:
  TimedProbe(const ElementProbe& whole, std::vector<CellKey> cells)
      : whole_(whole), cells_(std::move(cells)) {
    std::sort(cells_.begin(), cells_.end());
  }
  void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
            std::vector<ProbeLine>& lines) const override {
    const Eigen::Vector3d at = region.center().array().floor().max(0);
    const CellKey cell = keyOf(static_cast<std::int64_t>(at[0]), static_cast<std::int64_t>(at[1]),
                               static_cast<std::int64_t>(at[2]));
    if (!std::binary_search(cells_.begin(), cells_.end(), cell)) return;
    const double start = threadSeconds();
    whole_.cast(region, crossings, lines);
    seconds_ += threadSeconds() - start;
  }
  double seconds() const { return seconds_; }

 private:
  const ElementProbe& whole_;
  std::vector<CellKey> cells_;
  mutable double seconds_ = 0;
};

/// The element of the whole motion at the time of a crossing of the thinned one.
SweptElement elementOfWhole(SweptElement element, const Motion& whole, const Motion& part,
                            double seconds) {
  const auto& all = whole.placements;
  if (!element.isSidePatch()) seconds = part.placements[element.placement].timeSeconds;
  const auto after = std::upper_bound(
      all.begin(), all.end(), seconds,
      [](double t, const Placement& placement) { return t < placement.timeSeconds; });
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - all.begin(), 1)) - 1;
  const std::size_t last = element.isSidePatch() ? whole.steps() - 1 : all.size() - 1;
  element.placement = static_cast<std::uint32_t>(std::min(at, last));
  return element;
}

}  // namespace

double tryProbes(const SamplerInput& whole, const Motion& part, const MarkedEdges& marked,
                 HermiteGrid& hermite, ComponentMethod components, RunContext& run) {
  std::vector<SweptElement> elements;
  std::vector<std::uint32_t> own;
  for (std::size_t n = 0; n < hermite.crossings.size(); ++n) {
    elements.push_back(elementOfWhole(marked.elements[hermite.winner[n]], whole.motion, part,
                                      hermite.crossings[n].timeSeconds));
    own.push_back(static_cast<std::uint32_t>(n));
  }
  const ElementProbe probe(whole, elements, own);
  std::vector<CellKey> cells = mixedCells(hermite);
  if (cells.empty()) return 0;
  const double all = static_cast<double>(cells.size());
  cells.resize(moveCrossings(cells, probe, hermite));
  const double some = static_cast<double>(cells.size());
  const TimedProbe timed(probe, std::move(cells));
  buildDualSurface(hermite, components, &timed, run);
  return timed.seconds() * all / some;
}

}  // namespace swept
