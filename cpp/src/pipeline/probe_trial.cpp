// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/probe_trial.h"

#include <algorithm>
#include <numeric>

#include "base/sort_unique.h"
#include "base/timer.h"
#include "contour/cell.h"
#include "contour/dual_surface.h"
#include "crossings/element_probe.h"
#include "geometry/triangle_distance.h"

namespace swept {
namespace {

/// Cells are looked at for so many CPU seconds, but so many at least, unless these take far more.
constexpr double kProbeSeconds = 0.15, kMostProbeSeconds = 0.6;
constexpr std::size_t kFewestCells = 48;

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

/// Numbers without a pattern.
std::uint64_t mixed(std::uint64_t key) {
  key = (key ^ key >> 31) * 0x9e3779b97f4a7c15u;
  return (key ^ key >> 29) * 0xbf58476d1ce4e5b9u;
}

/// The cells that crossings lie round, in an order without a pattern.
std::vector<CellKey> mixedCells(const HermiteGrid& grid) {
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
  std::sort(cells.begin(), cells.end(), [](CellKey a, CellKey b) { return mixed(a) < mixed(b); });
  return cells;
}

/// A crossing of a rough cell.
struct Seed {
  std::uint32_t crossing;
  int edge;      // of the cell
  bool fromLow;  // seen from there
};

std::vector<Seed> seedsOf(const HermiteGrid& grid, const Eigen::Vector3i& cell) {
  std::vector<Seed> seeds;
  for (int edge = 0; edge < kEdges; ++edge) {
    const int axis = edge / 4;
    Eigen::Vector3i low = cell;
    low[(axis + 1) % 3] += edge & 1;
    low[(axis + 2) % 3] += edge >> 1 & 1;
    const HermiteLayer& layer = grid.layers[static_cast<std::size_t>(low[0])];
    const HermiteEdge* found = findEdge(layer.edges[axis], layer.columnStart[axis], low[1], low[2]);
    if (found == nullptr) continue;
    std::uint32_t crossing = found->first;
    if ((found->sides & HermiteEdge::kLow) != 0) seeds.push_back({crossing++, edge, true});
    if ((found->sides & HermiteEdge::kHigh) != 0) seeds.push_back({crossing, edge, false});
  }
  return seeds;
}

/// Casts for one cell at any place of the grid, and counts what is asked.
class CellProbe : public SurfaceProbe {
 public:
  /// `starts`: numbers of the elements that every search starts at.
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
  static void move(std::vector<ProbeLine>& lines, const Eigen::Vector3d& way) {
    for (ProbeLine& line : lines) {
      line.from += way;
      line.to += way;
      line.point += way;
    }
  }

  const ElementProbe& whole_;
  Eigen::Vector3d corner_;
  const std::vector<std::uint32_t>& starts_;
  mutable ProbeCost cost_;
};

struct CrossedCell {
  Cell cell;
  std::vector<Crossing> crossings;
};

/// Looks for the crossings on all edges of a cell; the outside is what its edges reach from
/// `outside`, a corner, without meeting the surface.
CrossedCell crossedCell(const SurfaceProbe& probe, int outside) {
  std::vector<ProbeLine> lines(kSlots);
  for (int slot = 0; slot < kSlots; ++slot) {
    lines[slot].from = localPosition(slot / 2, slot % 2 == 0 ? 0 : 1);
    lines[slot].to = localPosition(slot / 2, slot % 2 == 0 ? 1 : 0);
  }
  probe.cast({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, {}, lines);
  const auto meets = [&](int edge) { return lines[2 * edge].hit && lines[2 * edge + 1].hit; };
  std::uint32_t reached = 1u << outside;
  for (std::uint32_t before = 0; before != reached;) {
    before = reached;
    for (int edge = 0; edge < kEdges; ++edge) {
      const std::uint32_t ends = 1u << cornerOf(edge, 0) | 1u << cornerOf(edge, 1);
      if (!meets(edge) && (reached & ends) != 0) reached |= ends;
    }
  }
  CrossedCell found;
  for (int slot = 0; slot < kSlots; ++slot) {
    if (!meets(slot / 2) || (reached >> cornerOf(slot / 2, slot % 2) & 1u) == 0) continue;
    const auto number = static_cast<std::uint32_t>(found.crossings.size());
    if (slot % 2 == 0 || !found.cell.has(slot - 1)) found.cell.first[slot / 2] = number;
    found.cell.mask |= 1u << slot;
    const ProbeLine& line = lines[slot];
    found.crossings.push_back({static_cast<float>(line.point[slot / 8]), line.normal.cast<float>(),
                               static_cast<float>(line.timeSeconds)});
  }
  return found;
}

/// The element of the whole motion at the time of a crossing of the rough one.
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

/// The way from p to an element (grid coordinates).
Eigen::Vector3d wayTo(const SweptElement& element, const Eigen::Vector3d& p,
                      const SamplerInput& input) {
  const auto& x = input.body.vertices;
  const Placement at = input.grid.toGrid(input.motion.placements[element.placement]);
  if (!element.isSidePatch()) {
    const auto& t = input.body.triangles[element.index()];
    return -footOnTriangle(p, at.apply(x[t[0]]), at.apply(x[t[1]]), at.apply(x[t[2]])).offset;
  }
  const Placement next = input.grid.toGrid(input.motion.placements[element.placement + 1]);
  const BodyEdge& e = input.topology.edges[element.index()];
  const Eigen::Vector3d a = at.apply(x[e.a]), c = next.apply(x[e.b]);
  const Foot one = footOnTriangle(p, a, at.apply(x[e.b]), c);
  const Foot two = footOnTriangle(p, a, c, next.apply(x[e.a]));
  return -(one.offset.squaredNorm() < two.offset.squaredNorm() ? one : two).offset;
}

/// Corner of the run's cell at a crossing within a cell of the rough grid.
Eigen::Vector3d cornerAt(const Eigen::Vector3i& cell, const Seed& seed, double fraction,
                         std::int32_t coarser) {
  const int axis = seed.edge / 4;
  Eigen::Vector3i corner = cell * coarser;
  corner[axis] +=
      std::min(static_cast<std::int32_t>(fraction * static_cast<double>(coarser)), coarser - 1);
  for (const int n : {0, 1}) {
    if ((seed.edge >> n & 1) != 0) corner[(axis + 1 + n) % 3] += coarser - 1;
  }
  return corner.cast<double>();
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
  std::vector<std::uint32_t> own(elements.size());
  std::iota(own.begin(), own.end(), 0u);
  const ElementProbe probe(whole, elements, own);
  const std::vector<CellKey> cells = mixedCells(grid);
  const double start = threadSeconds();
  ProbeCost cost;
  std::size_t done = 0;
  const auto goesOn = [&] {
    return threadSeconds() - start < (done < kFewestCells ? kMostProbeSeconds : kProbeSeconds);
  };
  for (; done < cells.size() && goesOn(); ++done) {
    const Eigen::Vector3i cell = cellOf(cells[done]);
    const std::vector<Seed> seeds = seedsOf(grid, cell);
    const Seed& seed = seeds[(mixed(cells[done]) >> 32) % seeds.size()];
    std::vector<std::uint32_t> starts;
    for (const Seed& s : seeds) starts.push_back(s.crossing);
    const double fraction = grid.crossings[seed.crossing].fraction;
    const Eigen::Vector3d at =
        (cell.cast<double>() + localPosition(seed.edge, static_cast<float>(fraction))) *
        rough.coarser;
    const Eigen::Vector3d corner =
        cornerAt(cell, seed, fraction, rough.coarser) + wayTo(elements[seed.crossing], at, whole);
    const CrossedCell crossed =
        crossedCell(CellProbe(probe, corner, starts), cornerOf(seed.edge, seed.fromLow ? 0 : 1));
    const CellProbe asked(probe, corner, starts);
    probeCell(crossed.cell, crossed.crossings, components, asked);
    cost.casts += asked.cost().casts;
    cost.seconds += asked.cost().seconds;
  }
  if (done == 0) return cost;
  // Most probes are cast at creases, which pass through as many times more of the run's cells as
  // these are smaller; in larger cells, pieces that no crossing names look like some.
  const double times =
      static_cast<double>(cells.size()) / static_cast<double>(done) * rough.coarser;
  return {cost.casts * times, cost.seconds * times};
}

}  // namespace swept
