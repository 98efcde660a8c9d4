// Groups adjacent faces with similar normals into clusters. Culling decides most clusters as a
// whole, so it need not visit every face in every step. Cost: O(faces) to build.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/body_topology.h"
#include "swept/types.h"

namespace swept {

struct FaceCluster {
  std::uint32_t firstFace = 0, faceCount = 0;  ///< range in FaceClusters::faces
  std::uint32_t firstEdge = 0, edgeCount = 0;  ///< range in FaceClusters::innerEdges
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;  ///< mm; the ball about the centre contains all vertices
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double cosCone = 1, sinCone = 0;  ///< every normal is within this cone about the axis
  double minHeight = 0;             ///< mm; smallest height of its triangles
};

struct FaceClusters {
  /// Largest number of faces of a cluster. Larger clusters have wider normal cones, so culling
  /// could decide fewer clusters as a whole.
  static constexpr std::uint32_t kMaxFaces = 24;

  std::vector<FaceCluster> clusters;
  std::vector<std::uint32_t> faces;      ///< the faces in the order of the clusters
  std::vector<std::uint32_t> clusterOf;  ///< per face
  std::vector<std::uint32_t> indexOf;    ///< per face: its index in `faces`
  /// Edges whose two faces are in one cluster, sorted by cluster.
  std::vector<std::uint32_t> innerEdges;
  std::vector<std::uint32_t> borderEdges;  ///< all other edges, sorted by pair of clusters
  /// Data of the inner and the border edges for sampling, in the same order: the indices in `faces`
  /// of the two faces (for a boundary edge, both are the left face), and the end vertices.
  struct EdgeEnds {
    std::uint32_t left, right;
    std::int32_t a, b;
  };
  std::vector<EdgeEnds> innerEnds, borderEnds;

  /// A range of border edges between the same two clusters, all with the same value of `opposed`.
  struct Border {
    std::uint32_t firstEdge = 0, edgeCount = 0;
    std::int32_t left = 0;
    /// The cluster on the other side; -1 for boundary and non-manifold edges, whose side patches
    /// are never enclosed.
    std::int32_t right = -1;
    bool opposed = false;
  };
  std::vector<Border> borders;
  /// Per cluster: index of the first border with this cluster on its left. Borders without a
  /// cluster on their right stand at the end; one more entry has the index of the first of them.
  std::vector<std::uint32_t> firstBorder;

  /// Data for the first, quick test of a face (swept_elements.h), in the order of `faces`.
  struct FaceBall {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();  ///< mm
    float radius = 0;                                  ///< mm; the ball contains all corners
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float height = 0;  ///< mm; smallest height of the triangle
  };
  std::vector<FaceBall> balls;
};

FaceClusters buildClusters(const TriMesh& body, const BodyTopology& topology);

}  // namespace swept
