// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/leak_repair.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "base/timer.h"
#include "signs/contributing_edges.h"

namespace swept::dense {
namespace {

// Largest number of covered points that are followed. It limits time and memory: a table of this
// many points takes several hundred MB.
constexpr std::size_t kMaxFollowed = 6'000'000;
constexpr std::size_t kMaxTried = 8;  // placements tested exactly per point
constexpr std::size_t kTrialPoints = 4000;

using Lattice = std::array<std::int32_t, 3>;

/// Searches for placements whose copies cover lattice points.
class CoveringSearch {
 public:
  CoveringSearch(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                 double margin)
      : input_(input), tests_(tests), space_(space), margin_(margin) {}

  struct Covered {
    std::uint64_t point;
    std::uint32_t placement;
    float depth;
    bool operator<(const Covered& o) const {
      return point != o.point ? point < o.point : placement < o.placement;
    }
  };
  struct Scratch {
    std::vector<PlacementSpace::Best> found;
    std::vector<std::uint32_t> hit;
  };

  static std::uint64_t pack(const Lattice& g) {
    return static_cast<std::uint64_t>(g[0]) << 26 | static_cast<std::uint64_t>(g[1]) << 13 |
           static_cast<std::uint64_t>(g[2]);
  }
  Eigen::Vector3d inBody(const Lattice& g, std::uint32_t placement) const {
    const Placement& p = input_.motion.placements[placement];
    const Eigen::Vector3d world =
        input_.grid.origin + input_.grid.cell * Eigen::Vector3d(g[0], g[1], g[2]);
    return p.applyInverse(world);
  }
  bool isInside(const Eigen::Vector3d& x) const { return tests_.rays.winding(x) > 0; }

  /// Tests the lattice point g, which is near `face` at `placement` and outside of that copy of the
  /// body. Searches for another placement whose copy covers the point.
  bool findCover(const Lattice& g, std::uint32_t face, std::uint32_t placement, Scratch& s,
                 Covered& out) const {
    const Eigen::Vector3d x = inBody(g, placement);
    const Eigen::Vector3d n = input_.topology.normals[face].cast<double>();
    const double height = n.dot(x - input_.body.vertices[input_.body.triangles[face][0]]);
    const Point6 gradient = space_.gradient(x, n);
    const float needed = dot(gradient, space_.point(placement)) +
                         static_cast<float>(std::max(height, 0.0) + margin_);
    const PlacementSpace::Best best = space_.support(gradient, placement);
    if (best.advance <= needed) return false;
    const auto accept = [&](const PlacementSpace::Best& c) {
      if (!isInside(inBody(g, c.placement))) return false;
      out = {pack(g), c.placement, c.advance - needed + static_cast<float>(margin_)};
      return true;
    };
    if (accept(best)) return true;
    space_.above(gradient, needed, kMaxTried, s.found);
    for (const auto& c : s.found) {
      if (c.placement != best.placement && accept(c)) return true;
    }
    return false;
  }

 protected:
  const SamplerInput& input_;
  const BodyTests& tests_;
  const PlacementSpace& space_;
  double margin_;
};

class LeakFinder : CoveringSearch {
 public:
  LeakFinder(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
             const MarkedEdges& marked, const SignRuns& signs, double margin, ClearPoints& clear,
             RunContext& run)
      : CoveringSearch(input, tests, space, margin),
        marked_(marked),
        signs_(signs),
        clear_(clear),
        run_(run) {}

  LeakSearch find() {
    seed();
    while (!front_.empty() && out_.complete) follow();
    sortUnique(out_.missing);
    return std::move(out_);
  }

 private:
  /// Returns a key that increases in the order in which the edges of a layer are visited.
  static std::uint64_t orderOf(int axis, std::int32_t j, std::int32_t k, std::uint64_t side) {
    return static_cast<std::uint64_t>(axis) << 32 | static_cast<std::uint64_t>(j) << 17 |
           static_cast<std::uint64_t>(k) << 1 | side;
  }
  static Lattice unpack(std::uint64_t key) {
    return {static_cast<std::int32_t>(key >> 26), static_cast<std::int32_t>(key >> 13 & 0x1fff),
            static_cast<std::int32_t>(key & 0x1fff)};
  }
  /// Returns whether the segment passes through the triangle, including its border.
  bool meets(std::uint32_t triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const auto& t = input_.body.triangles[triangle];
    const Eigen::Vector3d &a = input_.body.vertices[t[0]], &b = input_.body.vertices[t[1]],
                          &c = input_.body.vertices[t[2]];
    const Eigen::Vector3d n = (b - a).cross(c - a);
    const double above = n.dot(from - a), below = n.dot(to - a);
    if ((above > 0) == (below > 0) || above == below) return false;
    const Eigen::Vector3d x = from + (to - from) * (above / (above - below));
    const double least = -1e-9 * n.squaredNorm();
    return n.dot((b - a).cross(x - a)) >= least && n.dot((c - b).cross(x - b)) >= least &&
           n.dot((a - c).cross(x - c)) >= least;
  }
  /// Finds the triangles of the body that the segment meets, sorted.
  void findHits(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                std::vector<std::uint32_t>& out) const {
    out.clear();
    tests_.tree.forBox(from.cwiseMin(to), from.cwiseMax(to), [&](std::uint32_t index) {
      const auto t = static_cast<std::uint32_t>(tests_.tree.item(index));
      if (meets(t, from, to)) out.push_back(t);
    });
    std::sort(out.begin(), out.end());
  }

  void seed() {
    const auto layers = static_cast<std::size_t>(input_.grid.points[0]);
    std::vector<std::vector<Covered>> found(layers);
    std::vector<std::int64_t> tested(layers, 0);
    clear_.layers.resize(layers);
    parallelFor(layers, [&](std::size_t layer) {
      run_.checkpoint(Phase::Signs, layer, layers);
      Scratch scratch;
      // Both lists are in the same ascending order, so one pass over the old list finds all known
      // points.
      std::vector<ClearPoints::Point> known = std::move(clear_.layers[layer]);
      std::vector<ClearPoints::Point>& clear = clear_.layers[layer];
      clear.clear();
      auto at = known.begin();
      const auto i = static_cast<std::int32_t>(layer);
      for (int axis = 0; axis < 3; ++axis) {
        forContributing(
            marked_, signs_, input_.grid, i, axis,
            [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t sides) {
              Lattice g{i, j, edge.k};
              Covered cover{};
              const auto test = [&](std::uint32_t element, std::uint64_t side) {
                const SweptElement& e = marked_.elements[element];
                const ClearPoints::Point point{orderOf(axis, j, edge.k, side), e.index(),
                                               e.placement};
                ++tested[layer];
                while (at != known.end() && at->key < point.key) ++at;
                const bool isKnown = at != known.end() && *at == point;
                if (!isKnown && findCover(g, point.face, point.placement, scratch, cover)) {
                  found[layer].push_back(cover);
                } else {
                  clear.push_back(point);
                }
              };
              if (sides & HermiteEdge::kLow) test(edge.lowElement, 0);
              ++g[axis];
              if (sides & HermiteEdge::kHigh) test(edge.highElement, 1);
            });
      }
    });
    std::vector<Covered> all;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      out_.tested += tested[layer];
      all.insert(all.end(), found[layer].begin(), found[layer].end());
    }
    out_.covered = static_cast<std::int64_t>(all.size());
    for (const Covered& c : all) out_.deepest = std::max(out_.deepest, double(c.depth));
    accept(all);
  }

  void accept(std::vector<Covered>& found) {
    std::sort(found.begin(), found.end());
    front_.clear();
    for (const Covered& c : found) {
      if (cover_.emplace(c.point, c.placement).second) front_.push_back(c);
    }
    if (cover_.size() > kMaxFollowed) out_.complete = false;
  }

  /// Goes from a covered point to its six neighbours. Adds the neighbours that are also covered,
  /// and the missing pairs.
  void step(const Covered& from, Scratch& s, std::vector<Covered>& covered,
            std::vector<std::pair<std::uint32_t, std::uint32_t>>& missing) const {
    const Lattice g = unpack(from.point);
    for (int axis = 0; axis < 3; ++axis) {
      for (int direction = -1; direction <= 1; direction += 2) {
        Lattice to = g;
        to[axis] += direction;
        if (to[axis] < 0 || to[axis] >= input_.grid.points[axis]) continue;
        const Lattice& low = direction < 0 ? to : g;
        if (marked_.isMarked(axis, low[0], low[1], low[2]) || cover_.contains(pack(to))) continue;
        const Eigen::Vector3d y = inBody(to, from.placement);
        if (isInside(y)) {
          covered.push_back({pack(to), from.placement, 0});
          continue;
        }
        findHits(inBody(g, from.placement), y, s.hit);
        Covered other{};
        bool coveredElsewhere = false;
        for (const std::uint32_t f : s.hit) {
          if ((coveredElsewhere = findCover(to, f, from.placement, s, other))) break;
        }
        if (coveredElsewhere) {
          covered.push_back(other);
        } else {
          for (const std::uint32_t f : s.hit) missing.emplace_back(f, from.placement);
        }
      }
    }
  }

  void follow() {
    // Points per task: some milliseconds of exact tests.
    constexpr std::size_t kPoints = 512;
    const std::size_t blocks = (front_.size() + kPoints - 1) / kPoints;
    std::vector<std::vector<Covered>> covered(blocks);
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> missing(blocks);
    parallelBlocks(front_.size(), kPoints, [&](std::size_t begin, std::size_t end) {
      run_.checkpoint(Phase::Signs);
      Scratch scratch;
      const std::size_t b = begin / kPoints;
      for (std::size_t i = begin; i < end; ++i) step(front_[i], scratch, covered[b], missing[b]);
    });
    std::vector<Covered> all;
    for (std::size_t b = 0; b < blocks; ++b) {
      all.insert(all.end(), covered[b].begin(), covered[b].end());
      out_.missing.insert(out_.missing.end(), missing[b].begin(), missing[b].end());
    }
    accept(all);
  }

  const MarkedEdges& marked_;
  const SignRuns& signs_;
  ClearPoints& clear_;
  RunContext& run_;
  std::unordered_map<std::uint64_t, std::uint32_t> cover_;
  std::vector<Covered> front_;
  LeakSearch out_;
};

}  // namespace

LeakTrial tryLeaks(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                   const ChosenFaces& chosen, double margin) {
  const CoveringSearch search(input, tests, space, margin);
  CoveringSearch::Scratch scratch;
  const MarkedEdges& marked = chosen.marked;
  std::size_t ends = 0, tried = 0, open = 0, closed = 0;
  const std::size_t step = 1 + chosen.crossings / kTrialPoints;
  const double start = threadSeconds();
  const auto test = [&](std::uint32_t number, int axis, bool high, const Lattice& g) {
    const SweptElement& e = marked.elements[number];
    const std::uint32_t face = chosen.faces[e.index()];
    const Eigen::Vector3d normal =
        input.motion.placements[e.placement].rotation * input.topology.normals[face].cast<double>();
    if ((normal[axis] > 0) != high || ends++ % step != 0) return;
    ++tried;
    CoveringSearch::Covered cover{};
    if (!search.findCover(g, face, e.placement, scratch, cover)) {
      ++closed;
      return;
    }
    const auto& all = chosen.placements;
    const auto first = all.placement.begin();
    open += !std::binary_search(first + static_cast<std::ptrdiff_t>(all.start[e.index()]),
                                first + static_cast<std::ptrdiff_t>(all.start[e.index() + 1]),
                                cover.placement);
  };
  for (std::int32_t i = 0; i < input.grid.points[0]; ++i) {
    const LayerEdges& layer = marked.layers[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t j = 0; j + 1 < layer.columnStart[axis].size(); ++j) {
        for (std::uint32_t n = layer.columnStart[axis][j]; n < layer.columnStart[axis][j + 1];
             ++n) {
          const MarkedEdge& edge = layer.edges[axis][n];
          Lattice g{i, static_cast<std::int32_t>(j), edge.k};
          test(edge.lowElement, axis, false, g);
          ++g[axis];
          test(edge.highElement, axis, true, g);
        }
      }
    }
  }
  const double seconds = threadSeconds() - start;
  return {static_cast<double>(open) / static_cast<double>(std::max<std::size_t>(1, open + closed)),
          seconds / static_cast<double>(std::max<std::size_t>(1, tried))};
}

LeakSearch findLeaks(const SamplerInput& input, const BodyTests& tests, const PlacementSpace& space,
                     const MarkedEdges& marked, const SignRuns& signs, double margin,
                     ClearPoints& clear, RunContext& run) {
  return LeakFinder(input, tests, space, marked, signs, margin, clear, run).find();
}

}  // namespace swept::dense
