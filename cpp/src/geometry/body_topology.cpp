// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/body_topology.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/parallel.h"

namespace swept {
namespace {

struct HalfEdge {
  std::uint64_t key;   // (a << 32 | b), a < b
  std::uint32_t face;  // lowest bit of the pair (face << 1 | runs from b to a)
};

}  // namespace

BodyTopology buildTopology(const TriMesh& body) {
  BodyTopology topology;
  const std::size_t faces = body.triangles.size();
  topology.normals.resize(faces);
  topology.heights.resize(faces);
  std::vector<HalfEdge> halves(3 * faces);
  parallelBlocks(faces, 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto& t = body.triangles[f];
      const Eigen::Vector3d e1 = body.vertices[t[1]] - body.vertices[t[0]];
      const Eigen::Vector3d e2 = body.vertices[t[2]] - body.vertices[t[0]];
      const Eigen::Vector3d n = e1.cross(e2);
      const double area2 = n.norm();
      const double longest = std::max({e1.norm(), e2.norm(), (e2 - e1).norm()});
      topology.normals[f] = (area2 > 0 ? Eigen::Vector3d(n / area2) : n).cast<float>();
      topology.heights[f] = static_cast<float>(longest > 0 ? area2 / longest : 0);
      for (int c = 0; c < 3; ++c) {
        const auto from = static_cast<std::uint32_t>(t[c]);
        const auto to = static_cast<std::uint32_t>(t[(c + 1) % 3]);
        const std::uint64_t low = std::min(from, to), high = std::max(from, to);
        halves[3 * f + c] = {low << 32 | high,
                             static_cast<std::uint32_t>(f << 1 | (from > to ? 1 : 0))};
      }
    }
  });
  // Bucket by the lower vertex, then sort the few of each bucket: linear and in order.
  std::vector<std::uint32_t> start(body.vertices.size() + 1, 0);
  for (const HalfEdge& h : halves) ++start[h.key >> 32];
  exclusiveScan(start);
  std::vector<HalfEdge> sorted(halves.size());
  {
    std::vector<std::uint32_t> next(start);
    for (const HalfEdge& h : halves) sorted[next[h.key >> 32]++] = h;
  }
  parallelBlocks(body.vertices.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::sort(sorted.begin() + start[v], sorted.begin() + start[v + 1],
                [](const HalfEdge& x, const HalfEdge& y) {
                  return x.key != y.key ? x.key < y.key : x.face < y.face;
                });
    }
  });
  topology.edges.reserve(halves.size() / 2 + 1);
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t j = i + 1;
    while (j < sorted.size() && sorted[j].key == sorted[i].key) ++j;
    BodyEdge edge;
    edge.a = static_cast<std::int32_t>(sorted[i].key >> 32);
    edge.b = static_cast<std::int32_t>(sorted[i].key & 0xffffffffu);
    edge.left = static_cast<std::int32_t>(sorted[i].face >> 1);
    if (j - i == 2) {
      edge.right = static_cast<std::int32_t>(sorted[i + 1].face >> 1);
      edge.opposed = (sorted[i].face & 1) == (sorted[i + 1].face & 1);
    }
    topology.edges.push_back(edge);
    i = j;
  }
  return topology;
}

}  // namespace swept
