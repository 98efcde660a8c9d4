// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unit/contour/synthetic_grid.h"

#include <algorithm>
#include <cmath>

namespace swept::test {

std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  double unit() { return static_cast<double>(mix(state_++) >> 11) * 0x1p-53; }
  Eigen::Vector3f normal() {
    const double z = 2 * unit() - 1, angle = 6.283185307179586 * unit(), r = std::sqrt(1 - z * z);
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>();
  }

 private:
  std::uint64_t state_;
};

}  // namespace

SyntheticGrid::SyntheticGrid(std::int32_t nx, std::int32_t ny, std::int32_t nz)
    : points_{nx, ny, nz},
      inside_(static_cast<std::size_t>(nx) * ny * nz),
      walls_(3 * inside_.size()) {}

HermiteGrid SyntheticGrid::build(Geometry geometry, std::uint64_t seed) const {
  HermiteGrid grid;
  grid.plan.points = points_;
  grid.layers.resize(points_[0]);
  const auto crossing = [&](Draw& draw, int axis, bool fromLow, double low, double high) {
    Crossing c;
    if (geometry == Geometry::Random) {
      c.fraction = static_cast<float>(low + (high - low) * draw.unit());
      c.normal = draw.normal();
    } else {
      c.fraction = static_cast<float>((low + high) / 2);
      c.normal[axis] = fromLow ? -1.0f : 1.0f;
    }
    grid.crossings.push_back(c);
  };
  for (std::int32_t i = 0; i < points_[0]; ++i) {
    HermiteLayer& layer = grid.layers[i];
    layer.firstCrossing = static_cast<std::uint32_t>(grid.crossings.size());
    for (int axis = 0; axis < 3; ++axis) {
      for (std::int32_t j = 0; j < points_[1]; ++j) {
        layer.columnStart[axis].push_back(static_cast<std::uint32_t>(layer.edges[axis].size()));
        for (std::int32_t k = 0; k < points_[2]; ++k) {
          const std::int32_t i2 = i + (axis == 0), j2 = j + (axis == 1), k2 = k + (axis == 2);
          if (i2 >= points_[0] || j2 >= points_[1] || k2 >= points_[2]) continue;
          const bool in = inside(i, j, k), in2 = inside(i2, j2, k2);
          const bool wall =
              walls_[3 * index(i, j, k) + static_cast<std::size_t>(axis)] && !in && !in2;
          if (in == in2 && !wall) continue;
          HermiteEdge edge;
          edge.first = static_cast<std::uint32_t>(grid.crossings.size());
          edge.k = static_cast<std::uint16_t>(k);
          edge.sides = wall ? 3 : in ? HermiteEdge::kHigh : HermiteEdge::kLow;
          layer.edges[axis].push_back(edge);
          Draw draw(mix(seed) ^ (3 * index(i, j, k) + static_cast<std::size_t>(axis)) << 8);
          if (wall) {
            const double middle = geometry == Geometry::Random ? 0.1 + 0.8 * draw.unit() : 0.5;
            crossing(draw, axis, true, 0.02, middle);
            crossing(draw, axis, false, middle, 0.98);
          } else {
            crossing(draw, axis, !in, 0.02, 0.98);
          }
        }
      }
      layer.columnStart[axis].push_back(static_cast<std::uint32_t>(layer.edges[axis].size()));
    }
  }
  return grid;
}

namespace {
struct HalfEdge {
  std::uint64_t key;  // smaller vertex in the upper half, larger one in the lower half
  std::uint32_t id;
  bool ascending;
  bool operator<(const HalfEdge& o) const { return key != o.key ? key < o.key : id < o.id; }
};
}  // namespace

Faults findFaults(const TriMesh& mesh) {
  Faults faults;
  const auto report = [&](std::int64_t& counter, std::int32_t vertex) {
    if (!faults.any()) faults.first = mesh.vertices[vertex];
    ++counter;
  };
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& tri = mesh.triangles[t];
    if (tri[0] == tri[1] || tri[1] == tri[2] || tri[2] == tri[0]) {
      report(faults.degenerate, tri[0]);
    }
    for (int c = 0; c < 3; ++c) {
      const auto a = static_cast<std::uint64_t>(tri[c]),
                 b = static_cast<std::uint64_t>(tri[(c + 1) % 3]);
      edges.push_back(
          {std::min(a, b) << 32 | std::max(a, b), static_cast<std::uint32_t>(3 * t + c), a < b});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> twin(edges.size());
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last].key == edges[first].key) ++last;
    const auto vertex = static_cast<std::int32_t>(edges[first].key >> 32);
    if (last - first > 2) report(faults.nonManifoldEdges, vertex);
    if (last - first != 2 || edges[first].ascending == edges[first + 1].ascending) {
      report(faults.openEdges, vertex);
    } else {
      twin[edges[first].id] = edges[first + 1].id;
      twin[edges[first + 1].id] = edges[first].id;
    }
    first = last;
  }
  if (faults.any()) return faults;
  // Going around a vertex from any of its corners must visit all of them.
  std::vector<std::uint32_t> corners(mesh.vertices.size(), 0), start(mesh.vertices.size(), 0);
  for (std::uint32_t h = 0; h < twin.size(); ++h) {
    const std::int32_t v = mesh.triangles[h / 3][h % 3];
    ++corners[v];
    start[v] = h;
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::uint32_t passed = 0, h = start[v];
    if (corners[v] > 0) {
      do {
        ++passed;
        h = twin[h / 3 * 3 + (h % 3 + 2) % 3];
      } while (h != start[v]);
    }
    if (corners[v] == 0 || passed != corners[v]) {
      report(faults.badVertices, static_cast<std::int32_t>(v));
    }
  }
  return faults;
}

}  // namespace swept::test
