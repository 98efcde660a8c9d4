// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/body_topology.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/parallel.h"
#include "geometry/half_edges.h"

namespace swept {
BodyTopology buildTopology(const TriMesh& body) {
  BodyTopology topology;
  const std::size_t faces = body.triangles.size();
  topology.normals.resize(faces);
  topology.heights.resize(faces);
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
    }
  });
  topology.edges.reserve(3 * faces / 2 + 1);
  EdgeTable(body).forEachEdge([&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                                  const std::uint64_t* last) {
    const auto faceOf = [](std::uint64_t record) {
      return static_cast<std::int32_t>(EdgeTable::halfEdge(record) / 3);
    };
    BodyEdge edge;
    edge.a = low;
    edge.b = high;
    edge.left = faceOf(*first);
    for (const std::uint64_t* r = first; r != last; ++r)
      edge.left = std::min(edge.left, faceOf(*r));
    if (last - first == 2) {
      edge.right = std::max(faceOf(first[0]), faceOf(first[1]));
      edge.opposed = EdgeTable::ascending(first[0]) == EdgeTable::ascending(first[1]);
    }
    topology.edges.push_back(edge);
  });
  return topology;
}

}  // namespace swept
