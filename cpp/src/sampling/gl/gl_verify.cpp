// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_verify.h"

#include <algorithm>
#include <map>

#include "base/number_text.h"
#include "grid/crossing_records.h"
#include "sampling/culling/kept_elements.h"
#include "sampling/exact_element.h"
#include "signs/contributing_edges.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

/// Random numbers with the same sequence in every run, so that a failure can be repeated.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t below(std::uint64_t n) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (z ^ (z >> 31)) % n;
  }

 private:
  std::uint64_t state_;
};

std::string edgeName(int axis, std::int32_t i, std::int32_t j, std::int32_t k) {
  return textOf(6, "lattice edge (", i, ", ", j, ", ", k, ") along ") + "xyz"[axis];
}

/// A test case: an octahedron that turns and moves. Its sweep consists of faces and side patches.
/// Some vertices and edges lie exactly on lattice lines. The memory budget of the test cuts its
/// grid into two bricks (brick_plan.h).
struct KnownSweep {
  TriMesh body;
  Motion motion;
  GridPlan grid;

  KnownSweep() {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-4.0, 4.0}) {
        body.vertices.push_back(side * Eigen::Vector3d::Unit(axis));
      }
    }
    for (int octant = 0; octant < 8; ++octant) {
      const std::int32_t x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2);
      const bool even = (octant ^ octant >> 1 ^ octant >> 2) & 1;
      body.triangles.push_back(even ? std::array<std::int32_t, 3>{x, y, z}
                                    : std::array<std::int32_t, 3>{x, z, y});
    }
    motion.continuous = true;
    for (int step = 0; step < 4; ++step) motion.placements.push_back(at(step));
    for (int step = 0; step < 3; ++step) motion.midpoints.push_back(at(step + 0.5));
    grid.points = {24, 23, 40};
  }

 private:
  static Placement at(double step) {
    Placement p;
    p.rotation = Eigen::AngleAxisd(0.25 * step, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
    p.translation = Eigen::Vector3d(8 + 1.5 * step, 8 + step, 10 + 5 * step);
    p.timeSeconds = step;
    return p;
  }
};

}  // namespace

namespace {

/// A contributing edge with the crossings next to its outside ends, for comparison.
struct KnownEdge {
  int axis;
  std::int32_t i, j, k;
  float lowFraction, highFraction;
};
std::vector<KnownEdge> contributingEdges(const MarkedEdges& marked, const GridPlan& grid,
                                         const SignRuns& signs) {
  std::vector<KnownEdge> edges;
  for (std::int32_t i = 0; i < grid.points[0]; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      forContributing(marked, signs, grid, i, axis,
                      [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t sides) {
                        const bool low = (sides & HermiteEdge::kLow) != 0,
                                   high = (sides & HermiteEdge::kHigh) != 0;
                        edges.push_back({axis, i, j, edge.k, low ? edge.lowFraction : 0,
                                         high ? edge.highFraction : 0});
                      });
    }
  }
  return edges;
}

/// Compares with the CPU. Without culling, all marks must be equal. With culling, the device may
/// keep more elements than the CPU, but the contributing edges must be equal.
void testKnownSweep(const std::shared_ptr<GlDevice>& device, bool cull, double fenceTimeoutSeconds,
                    RunContext& run) {
  const KnownSweep sweep;
  const BodyTopology topology = buildTopology(sweep.body);
  const SamplerInput input{sweep.body, topology, sweep.motion, sweep.grid, cull, true};
  GlSettings settings;
  // Half of the layers fit into one brick.
  settings.budgetBytes = 2 * 12 * 23 * 3 * 2 * sizeof(std::uint32_t);
  settings.chunkBytes = 4096;
  settings.fenceTimeoutSeconds = fenceTimeoutSeconds;
  GlSampler sampler(
      input, [&] { return device; }, settings);
  MarkedEdges seen = sampler.mark(run);
  const MarkedEdges known = sampleCpu(input, run);
  const std::string name = sampler.device();
  for (std::size_t i = 0; i < known.layers.size() && !cull; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const LayerEdges &expected = known.layers[i], &got = seen.layers[i];
      const bool same =
          expected.columnStart[axis] == got.columnStart[axis] &&
          std::equal(expected.edges[axis].begin(), expected.edges[axis].end(),
                     got.edges[axis].begin(), got.edges[axis].end(),
                     [](const MarkedEdge& a, const MarkedEdge& b) { return a.k == b.k; });
      if (!same) reportGarbage(name, "in the self-test, it marked wrong edges of the grid");
    }
  }
  const SignRuns signs = findOutside(seen, sweep.grid, run);
  sampler.resolve(seen, signs, run);
  const auto expected = contributingEdges(known, sweep.grid, findOutside(known, sweep.grid, run));
  const auto got = contributingEdges(seen, sweep.grid, signs);
  constexpr float kStep = 2.0f / (1 << CrossingRecord::kFractionBits);
  if (expected.size() != got.size()) {
    reportGarbage(name, "in the self-test, it found a wrong number of edges at the surface");
  }
  for (std::size_t n = 0; n < got.size(); ++n) {
    const KnownEdge &a = expected[n], &b = got[n];
    const bool same = a.axis == b.axis && a.i == b.i && a.j == b.j && a.k == b.k &&
                      std::abs(a.lowFraction - b.lowFraction) <= kStep &&
                      std::abs(a.highFraction - b.highFraction) <= kStep;
    if (!same)
      reportGarbage(name, "in the self-test, it found a wrong crossing on " +
                              edgeName(b.axis, b.i, b.j, b.k));
  }
  verifyWinners(input, seen, signs, name, 1 << 20);
}

}  // namespace

void selfTest(const std::shared_ptr<GlDevice>& device, double fenceTimeoutSeconds,
              RunContext& run) {
  for (const bool cull : {false, true}) testKnownSweep(device, cull, fenceTimeoutSeconds, run);
}

void verifyMarks(const SamplerInput& input, const MarkedEdges& marked, const std::string& device,
                 int samples) {
  Random random(1);
  const std::size_t placements = input.motion.placements.size();
  constexpr int kPlacements = 16;
  FaceClusters own;
  const FaceClusters& clusters = clustersOf(input, own);
  const ShownClusters all = allClusters(clusters);
  KeptElements kept(input, clusters);
  std::vector<SweptElement> elements;
  for (int n = 0; n < kPlacements; ++n) {
    const auto k = static_cast<std::uint32_t>(random.below(placements));
    elements.clear();
    if (input.motion.continuous) {
      // The device must keep everything that the CPU keeps.
      kept.goTo(k);
      kept.forFaces(all, [&](std::uint32_t f) { elements.push_back({f, k}); });
      if (k < input.motion.steps()) {
        kept.forPatches(all, [&](std::uint32_t e, const FaceClusters::EdgeEnds&) {
          elements.push_back({e | SweptElement::kSidePatchBit, k});
        });
      }
    } else {
      for (std::uint32_t f = 0; f < input.body.triangles.size(); ++f) elements.push_back({f, k});
    }
    if (elements.empty()) continue;
    for (int sample = 0; sample < samples / kPlacements; ++sample) {
      elementCrossings(input, elements[random.below(elements.size())],
                       [&](int axis, std::int32_t i, std::int32_t j, std::int32_t edge, double) {
                         if (marked.isMarked(axis, i, j, edge)) return;
                         reportGarbage(device, "no mark on " + edgeName(axis, i, j, edge));
                       });
    }
  }
}

void verifySigns(const SamplerInput& input, const MarkedEdges& marked, const SignRuns& signs,
                 const std::string& device) {
  if (!input.orientable) return;
  Random random(2);
  const Placement placement =
      input.grid.toGrid(input.motion.placements[random.below(input.motion.placements.size())]);
  std::vector<SnappedPoint> points;
  points.reserve(input.body.vertices.size());
  std::array<std::int32_t, 2> low{1 << 20, 1 << 20}, high{0, 0};
  for (const auto& v : input.body.vertices) {
    points.push_back(snap(placement, v));
    for (int axis = 0; axis < 2; ++axis) {
      const std::int32_t g = points.back()[axis] >> kSubBits;
      low[axis] = std::min(low[axis], g);
      high[axis] = std::max(high[axis], g);
    }
  }
  // For 64 random lattice lines along z: the changes of the winding number at their lattice points,
  // ordered by k.
  using Line = std::pair<std::int32_t, std::int32_t>;
  std::map<Line, std::map<std::int32_t, int>> lines;
  for (int n = 0; n < 64; ++n) {
    const auto within = [&](int axis) {
      return low[axis] + static_cast<std::int32_t>(
                             random.below(static_cast<std::uint64_t>(high[axis] - low[axis]) + 1));
    };
    const std::int32_t i = within(0);
    lines[{i, within(1)}];
  }
  for (const auto& t : input.body.triangles) {
    const SnappedPoint &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const std::int64_t turn = static_cast<std::int64_t>(b[0] - a[0]) * (c[1] - a[1]) -
                              static_cast<std::int64_t>(b[1] - a[1]) * (c[0] - a[0]);
    rasteriseTriangle<2>(a, b, c, [&](std::int32_t i, std::int32_t j, std::int32_t k, double) {
      const auto line = lines.find({i, j});
      if (line != lines.end()) line->second[k + 1] += turn > 0 ? -1 : 1;
    });
  }
  for (const auto& [line, changes] : lines) {
    LineReader reader(marked, signs, line.first, line.second);
    int winding = 0;
    for (auto change = changes.begin(); change != changes.end(); ++change) {
      winding += change->second;
      const auto next = std::next(change);
      if (winding <= 0 || next == changes.end()) continue;
      for (std::int32_t k = change->first; k < next->first; ++k) {
        if (!reader.outside(k)) continue;
        reportGarbage(device, "the outside reaches the lattice point (" +
                                  std::to_string(line.first) + ", " + std::to_string(line.second) +
                                  ", " + std::to_string(k) + ") inside the part");
      }
    }
  }
}

void verifyWinners(const SamplerInput& input, const MarkedEdges& marked, const SignRuns& signs,
                   const std::string& device, int samples) {
  Random random(3);
  constexpr std::uint64_t kLayers = 16;
  const auto all = static_cast<std::uint64_t>(input.grid.points[0]);
  std::vector<std::int32_t> layers;
  std::uint64_t total = 0;
  for (std::uint64_t n = 0; n < std::min(kLayers, all); ++n) {
    // The layers are cut into equal ranges, and one layer is chosen from each.
    const std::uint64_t begin = n * all / std::min(kLayers, all),
                        end = (n + 1) * all / std::min(kLayers, all);
    layers.push_back(static_cast<std::int32_t>(begin + random.below(end - begin)));
    for (const auto& edges : marked.layers[static_cast<std::size_t>(layers.back())].edges) {
      total += edges.size();
    }
  }
  const std::uint64_t stride = std::max<std::uint64_t>(1, total / static_cast<unsigned>(samples));
  std::uint64_t toSkip = random.below(stride);
  constexpr double kStep = 2.0 / (1 << CrossingRecord::kFractionBits);
  const auto verify = [&](int axis, std::int32_t i, std::int32_t j, const MarkedEdge& edge) {
    for (const bool low : {true, false}) {
      const std::uint32_t winner = low ? edge.lowElement : edge.highElement;
      const double fraction = low ? edge.lowFraction : edge.highFraction;
      bool found = false;
      elementCrossings(input, marked.elements[winner],
                       [&](int x, std::int32_t p, std::int32_t q, std::int32_t r, double f) {
                         found |= x == axis && p == i && q == j && r == edge.k &&
                                  std::abs(f - fraction) <= kStep;
                       });
      if (found) continue;
      reportGarbage(device, "it named a part of the surface for " + edgeName(axis, i, j, edge.k) +
                                " that does not cross it");
    }
  };
  for (const std::int32_t i : layers) {
    for (int axis = 0; axis < 3; ++axis) {
      forContributing(marked, signs, input.grid, i, axis,
                      [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t) {
                        if (toSkip-- != 0) return;
                        toSkip = random.below(2 * stride - 1);
                        verify(axis, i, j, edge);
                      });
    }
  }
}

}  // namespace swept::gl
