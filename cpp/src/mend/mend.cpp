// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mend/mend.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "base/parallel.h"

namespace swept {
namespace {

constexpr int kBlockCells = 8;  ///< regions are made of blocks of so many cells
constexpr int kReachCells = 4;  ///< around a triangle that meets another one
constexpr int kRounds = 8;
constexpr double kCellMargin = 1e-4;

using Triangle = std::array<std::int32_t, 3>;

/// The part of the surface round the pairs, with numbers of its own.
class Region {
 public:
  Region(Surface& surface, const HermiteGrid& grid, const SelfIntersections& found)
      : surface_(surface), grid_(grid) {
    const auto blocks = badBlocks(found);
    const auto& all = surface.mesh.triangles;
    constexpr std::size_t kChunk = 1 << 16;
    std::vector<std::vector<std::uint32_t>> parts((all.size() + kChunk - 1) / kChunk);
    parallelFor(parts.size(), [&](std::size_t p) {
      for (std::size_t t = p * kChunk; t < std::min(all.size(), (p + 1) * kChunk); ++t) {
        const Eigen::Vector3i cell = cellOf(surface.mesh.vertices[all[t][0]]);
        if (blocks.contains(key(cell / kBlockCells)))
          parts[p].push_back(static_cast<std::uint32_t>(t));
      }
    });
    for (const auto& part : parts) global_.insert(global_.end(), part.begin(), part.end());
    std::unordered_map<std::int32_t, std::int32_t> local;
    for (const std::uint32_t t : global_) {
      Triangle triangle = all[t];
      for (auto& v : triangle) {
        const auto [at, fresh] =
            local.try_emplace(v, static_cast<std::int32_t>(vertexGlobal_.size()));
        if (fresh) {
          vertexGlobal_.push_back(v);
          mesh.vertices.push_back(surface.mesh.vertices[v]);
        }
        v = at->second;
      }
      mesh.triangles.push_back(triangle);
      crossingOf.push_back(surface.crossingOf[t]);
    }
  }

  /// Writes what changed back into the surface.
  void store() {
    const std::size_t oldVertices = vertexGlobal_.size(), oldTriangles = global_.size();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (v < oldVertices) {
        surface_.mesh.vertices[vertexGlobal_[v]] = mesh.vertices[v];
      } else {
        vertexGlobal_.push_back(static_cast<std::int32_t>(surface_.mesh.vertices.size()));
        surface_.mesh.vertices.push_back(mesh.vertices[v]);
        surface_.contactTime.push_back(newTimes[v - oldVertices]);
      }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Triangle triangle = mesh.triangles[t];
      for (auto& v : triangle) v = vertexGlobal_[v];
      if (t < oldTriangles) {
        surface_.mesh.triangles[global_[t]] = triangle;
      } else {
        global_.push_back(static_cast<std::uint32_t>(surface_.mesh.triangles.size()));
        surface_.mesh.triangles.push_back(triangle);
        surface_.crossingOf.push_back(crossingOf[t]);
      }
    }
  }

  /// Local pairs in the surface's own numbers.
  SelfIntersections global(const SelfIntersections& local) const {
    SelfIntersections out;
    out.count = local.count;
    for (const auto& [a, b] : local.pairs) {
      const auto x = static_cast<std::int32_t>(global_[a]),
                 y = static_cast<std::int32_t>(global_[b]);
      out.pairs.emplace_back(std::min(x, y), std::max(x, y));
    }
    std::sort(out.pairs.begin(), out.pairs.end());
    return out;
  }

  bool isDual(std::int32_t v) const {
    return static_cast<std::size_t>(v) < vertexGlobal_.size() &&
           static_cast<std::size_t>(vertexGlobal_[v]) < surface_.dualVertices;
  }
  Eigen::Vector3d toCells(const Eigen::Vector3d& x) const {
    return (x - grid_.plan.origin) / grid_.plan.cell;
  }
  Eigen::Vector3d toWorld(const Eigen::Vector3d& g) const {
    return grid_.plan.origin + grid_.plan.cell * g;
  }
  Eigen::Vector3d crossingPoint(std::uint32_t crossing) const {
    const CrossingPlace place = findCrossing(grid_, crossing);
    Eigen::Vector3d g(place.i, place.j, place.k);
    g[place.axis] += grid_.crossings[crossing].fraction;
    return g;
  }
  double crossingTime(std::uint32_t crossing) const {
    return grid_.crossings[crossing].timeSeconds;
  }

  TriMesh mesh;
  std::vector<std::uint32_t> crossingOf;
  std::vector<double> newTimes;

 private:
  static std::uint64_t key(const Eigen::Vector3i& block) {
    return static_cast<std::uint64_t>(block[0]) << 42 | static_cast<std::uint64_t>(block[1]) << 21 |
           static_cast<std::uint64_t>(block[2]);
  }
  Eigen::Vector3i cellOf(const Eigen::Vector3d& x) const {
    return toCells(x).array().floor().matrix().cast<int>().cwiseMax(0);
  }
  std::unordered_set<std::uint64_t> badBlocks(const SelfIntersections& found) const {
    std::unordered_set<std::uint64_t> blocks;
    const auto add = [&](std::int32_t t) {
      for (const std::int32_t v : surface_.mesh.triangles[t]) {
        const Eigen::Vector3i cell = cellOf(surface_.mesh.vertices[v]);
        const Eigen::Vector3i low =
            (cell - Eigen::Vector3i::Constant(kReachCells)).cwiseMax(0) / kBlockCells;
        const Eigen::Vector3i high = (cell + Eigen::Vector3i::Constant(kReachCells)) / kBlockCells;
        for (int x = low[0]; x <= high[0]; ++x) {
          for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) blocks.insert(key({x, y, z}));
          }
        }
      }
    };
    for (const auto& [a, b] : found.pairs) {
      add(a);
      add(b);
    }
    return blocks;
  }

  Surface& surface_;
  const HermiteGrid& grid_;
  std::vector<std::uint32_t> global_;
  std::vector<std::int32_t> vertexGlobal_;
};

class Mender {
 public:
  explicit Mender(Region& region) : region_(region) { index(); }

  void fan(const std::unordered_set<std::uint32_t>& crossings) {
    std::vector<std::uint32_t> order(crossings.begin(), crossings.end());
    std::sort(order.begin(), order.end());
    for (const std::uint32_t crossing : order) fanPolygon(crossing);
    index();
  }

  /// Moves component vertices towards their mass points.
  void relax(const std::unordered_set<std::int32_t>& vertices, double weight) {
    std::vector<std::int32_t> order(vertices.begin(), vertices.end());
    std::sort(order.begin(), order.end());
    for (const std::int32_t v : order) {
      if (!region_.isDual(v)) continue;
      std::vector<std::uint32_t> crossings = around(v);
      Eigen::Vector3d mass = Eigen::Vector3d::Zero();
      if (crossings.empty()) continue;
      for (const std::uint32_t c : crossings) mass += region_.crossingPoint(c);
      mass /= static_cast<double>(crossings.size());
      const Eigen::Vector3d now = region_.toCells(region_.mesh.vertices[v]);
      // A vertex may have escaped from its cell; its mass point never does.
      Eigen::Vector3d cell = now.array().floor();
      if ((mass.array() < cell.array()).any() || (mass.array() > cell.array() + 1).any()) {
        cell = mass.array().floor();
      }
      mass = mass.cwiseMax((cell.array() + kCellMargin).matrix())
                 .cwiseMin((cell.array() + 1 - kCellMargin).matrix());
      region_.mesh.vertices[v] = region_.toWorld(now + weight * (mass - now));
    }
  }

  std::vector<std::uint32_t> around(std::int32_t v) const {
    std::vector<std::uint32_t> crossings;
    for (std::uint32_t n = start_[v]; n < start_[v + 1]; ++n) {
      const std::uint32_t crossing = region_.crossingOf[triangles_[n]];
      if (crossing != Surface::kNoCrossing) crossings.push_back(crossing);
    }
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
    return crossings;
  }

 private:
  void index() {
    const auto& mesh = region_.mesh;
    start_.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles) {
      for (const std::int32_t v : t) ++start_[v];
    }
    exclusiveScan(start_);
    triangles_.resize(3 * mesh.triangles.size());
    std::vector<std::uint32_t> next(start_);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::int32_t v : mesh.triangles[t]) triangles_[next[v]++] = t;
    }
    polygon_.clear();
    for (std::uint32_t t = 0; t < region_.crossingOf.size(); ++t) {
      polygon_[region_.crossingOf[t]].push_back(t);
    }
  }

  /// Replaces the triangles of a polygon by a fan about its crossing, unless it is one already.
  void fanPolygon(std::uint32_t crossing) {
    const std::vector<std::uint32_t>& members = polygon_[crossing];
    if (members.size() != 2) return;  // quads only: two triangles
    auto& triangles = region_.mesh.triangles;
    // The ring: directed edges that no other member runs back along.
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    for (const std::uint32_t t : members) {
      for (int c = 0; c < 3; ++c) edges.emplace_back(triangles[t][c], triangles[t][(c + 1) % 3]);
    }
    const auto inner = [&](const std::pair<std::int32_t, std::int32_t>& e) {
      return std::find(edges.begin(), edges.end(), std::pair(e.second, e.first)) != edges.end();
    };
    std::vector<std::pair<std::int32_t, std::int32_t>> rim;
    for (const auto& e : edges) {
      if (!inner(e)) rim.push_back(e);
    }
    if (rim.size() != 4) return;
    const auto centre = static_cast<std::int32_t>(region_.mesh.vertices.size());
    region_.mesh.vertices.push_back(region_.toWorld(region_.crossingPoint(crossing)));
    region_.newTimes.push_back(region_.crossingTime(crossing));
    for (std::size_t e = 0; e < rim.size(); ++e) {
      const Triangle triangle{rim[e].first, rim[e].second, centre};
      if (e < members.size()) {
        triangles[members[e]] = triangle;
      } else {
        triangles.push_back(triangle);
        region_.crossingOf.push_back(crossing);
      }
    }
  }

  Region& region_;
  std::vector<std::uint32_t> start_, triangles_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> polygon_;
};

}  // namespace

SelfIntersections mendSelfIntersections(Surface& surface, const HermiteGrid& grid,
                                        const SelfIntersections& found, RunContext& run) {
  if (found.count == 0) return found;
  Region region(surface, grid, found);
  Mender mender(region);
  SelfIntersections left = findSelfIntersections(region.mesh, {}, run);
  for (int round = 0; round < kRounds && left.count > 0; ++round) {
    run.checkpoint(Phase::Check, static_cast<std::uint64_t>(round), kRounds);
    std::unordered_set<std::uint32_t> polygons;
    std::unordered_set<std::int32_t> vertices;
    for (const auto& [a, b] : left.pairs) {
      for (const std::int32_t t : {a, b}) {
        const std::uint32_t crossing = region.crossingOf[t];
        if (crossing != Surface::kNoCrossing) polygons.insert(crossing);
        for (const std::int32_t v : region.mesh.triangles[t]) vertices.insert(v);
      }
    }
    if (round >= 4) {  // the neighbours follow
      const std::vector<std::int32_t> seeds(vertices.begin(), vertices.end());
      for (const std::int32_t v : seeds) {
        for (const std::uint32_t c : mender.around(v)) polygons.insert(c);
      }
    }
    if (round > 0) mender.relax(vertices, round < 3 ? 0.5 : 1.0);
    if (round != 1) mender.fan(polygons);
    left = findSelfIntersections(region.mesh, {}, run);
  }
  region.store();
  return region.global(left);
}

}  // namespace swept
