// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/culling/face_clusters.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/half_edges.h"

namespace swept {
namespace {

/// Smallest cosine of the angle between a normal and that of the first face of the cluster: a cone
/// of at most 10 degrees.
constexpr float kMinCosine = 0.985f;
constexpr std::uint32_t kNone = 0xffffffffu;

void measure(const TriMesh& body, const BodyTopology& topology, const FaceClusters& all,
             FaceCluster& cluster) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low,
                  normals = Eigen::Vector3d::Zero();
  cluster.minHeight = 1e300;
  const auto eachFace = [&](const auto& use) {
    for (std::uint32_t n = 0; n < cluster.faceCount; ++n) use(all.faces[cluster.firstFace + n]);
  };
  eachFace([&](std::uint32_t f) {
    for (const std::int32_t v : body.triangles[f]) {
      low = low.cwiseMin(body.vertices[v]);
      high = high.cwiseMax(body.vertices[v]);
    }
    normals += topology.normals[f].cast<double>();
    cluster.minHeight = std::min(cluster.minHeight, static_cast<double>(topology.heights[f]));
  });
  cluster.centre = (low + high) / 2;
  const double length = normals.norm();
  cluster.axis = length > 0 ? Eigen::Vector3d(normals / length) : Eigen::Vector3d::UnitZ();
  double radius2 = 0, cosine = length > 0 ? 1 : -1;
  eachFace([&](std::uint32_t f) {
    for (const std::int32_t v : body.triangles[f]) {
      radius2 = std::max(radius2, (body.vertices[v] - cluster.centre).squaredNorm());
    }
    cosine = std::min(cosine, cluster.axis.dot(topology.normals[f].cast<double>()));
  });
  cluster.radius = std::sqrt(radius2);
  // The margin covers the rounding of the normals, which are 32-bit floats.
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) + 1e-6;
  cluster.cosCone = std::cos(angle);
  cluster.sinCone = std::sin(angle);
}

void groupBorders(const BodyTopology& topology, FaceClusters& out) {
  const auto pairOf = [&](std::uint32_t e) {
    const BodyEdge& edge = topology.edges[e];
    if (edge.right < 0) return std::uint64_t{0xffffffffffffffffu};
    return static_cast<std::uint64_t>(out.clusterOf[edge.left]) << 32 |
           static_cast<std::uint64_t>(out.clusterOf[edge.right]) << 1 | (edge.opposed ? 1u : 0u);
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(out.borderEdges.size());
  for (const std::uint32_t e : out.borderEdges) order.emplace_back(pairOf(e), e);
  std::sort(order.begin(), order.end());
  for (std::uint32_t n = 0; n < order.size(); ++n) {
    out.borderEdges[n] = order[n].second;
    if (n == 0 || order[n].first != order[n - 1].first) {
      const BodyEdge& edge = topology.edges[order[n].second];
      FaceClusters::Border border;
      border.firstEdge = n;
      border.left = static_cast<std::int32_t>(out.clusterOf[edge.left]);
      border.right = edge.right < 0 ? -1 : static_cast<std::int32_t>(out.clusterOf[edge.right]);
      border.opposed = edge.opposed;
      out.borders.push_back(border);
    }
    ++out.borders.back().edgeCount;
  }
  out.firstBorder.assign(out.clusters.size() + 1, 0);
  for (const FaceClusters::Border& border : out.borders) {
    if (border.right >= 0) ++out.firstBorder[static_cast<std::size_t>(border.left)];
  }
  exclusiveScan(out.firstBorder);
}

std::vector<FaceClusters::EdgeEnds> endsOf(const BodyTopology& topology, const FaceClusters& all,
                                           const std::vector<std::uint32_t>& edges) {
  std::vector<FaceClusters::EdgeEnds> ends;
  ends.reserve(edges.size());
  for (const std::uint32_t e : edges) {
    const BodyEdge& edge = topology.edges[e];
    ends.push_back({all.indexOf[edge.left], all.indexOf[edge.right < 0 ? edge.left : edge.right],
                    edge.a, edge.b});
  }
  return ends;
}

/// Grows clusters breadth first, each from the first face that has no cluster yet.
void growClusters(const TriMesh& body, const BodyTopology& topology, FaceClusters& out) {
  const auto faces = static_cast<std::uint32_t>(body.triangles.size());
  const Adjacency adjacency = findAdjacency(body);
  const auto startOf = [&](std::uint32_t h) { return body.triangles[h / 3][h % 3]; };
  out.faces.reserve(faces);
  out.clusterOf.assign(faces, kNone);
  for (std::uint32_t seed = 0; seed < faces; ++seed) {
    if (out.clusterOf[seed] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(out.clusters.size());
    FaceCluster cluster;
    cluster.firstFace = static_cast<std::uint32_t>(out.faces.size());
    out.faces.push_back(seed);
    out.clusterOf[seed] = id;
    for (std::size_t next = cluster.firstFace;
         next < out.faces.size() && out.faces.size() - cluster.firstFace < FaceClusters::kMaxFaces;
         ++next) {
      for (std::uint32_t h = 3 * out.faces[next]; h < 3 * out.faces[next] + 3; ++h) {
        const std::uint32_t across = adjacency.across[h];
        if (across == kNoNeighbour || startOf(across) == startOf(h)) continue;
        const std::uint32_t other = across / 3;
        if (out.clusterOf[other] != kNone) continue;
        if (topology.normals[other].dot(topology.normals[seed]) < kMinCosine) continue;
        out.clusterOf[other] = id;
        out.faces.push_back(other);
      }
    }
    cluster.faceCount = static_cast<std::uint32_t>(out.faces.size()) - cluster.firstFace;
    out.clusters.push_back(cluster);
  }
}

/// Separates the edges inside clusters from those between clusters. Returns the index of the first
/// inner edge of each cluster.
std::vector<std::uint32_t> splitEdges(const BodyTopology& topology, FaceClusters& out) {
  std::vector<std::uint32_t> start(out.clusters.size() + 1, 0);
  const auto inner = [&](const BodyEdge& e) {
    return e.right >= 0 && !e.opposed && out.clusterOf[e.left] == out.clusterOf[e.right];
  };
  for (const BodyEdge& e : topology.edges) {
    if (inner(e)) ++start[out.clusterOf[e.left]];
  }
  out.innerEdges.resize(exclusiveScan(start));
  std::vector<std::uint32_t> next(start);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (inner(topology.edges[e])) {
      out.innerEdges[next[out.clusterOf[topology.edges[e].left]]++] = e;
    } else {
      out.borderEdges.push_back(e);
    }
  }
  return start;
}

void makeBalls(const TriMesh& body, const BodyTopology& topology, FaceClusters& out) {
  out.balls.resize(out.faces.size());
  parallelBlocks(out.faces.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::uint32_t f = out.faces[n];
      const auto& t = body.triangles[f];
      const Eigen::Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]],
                            &c = body.vertices[t[2]];
      const Eigen::Vector3d centre = (a.cwiseMin(b).cwiseMin(c) + a.cwiseMax(b).cwiseMax(c)) / 2;
      const double radius2 = std::max(
          {(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()});
      out.balls[n] = {centre.cast<float>(), static_cast<float>(std::sqrt(radius2)),
                      topology.normals[f], topology.heights[f]};
    }
  });
}

}  // namespace

FaceClusters buildClusters(const TriMesh& body, const BodyTopology& topology) {
  const auto faces = static_cast<std::uint32_t>(body.triangles.size());
  FaceClusters out;
  growClusters(body, topology, out);
  const std::vector<std::uint32_t> start = splitEdges(topology, out);
  groupBorders(topology, out);
  out.indexOf.resize(faces);
  for (std::uint32_t n = 0; n < faces; ++n) out.indexOf[out.faces[n]] = n;
  out.innerEnds = endsOf(topology, out, out.innerEdges);
  out.borderEnds = endsOf(topology, out, out.borderEdges);
  makeBalls(body, topology, out);
  parallelBlocks(out.clusters.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      out.clusters[c].firstEdge = start[c];
      out.clusters[c].edgeCount = start[c + 1] - start[c];
      measure(body, topology, out, out.clusters[c]);
    }
  });
  return out;
}

}  // namespace swept
