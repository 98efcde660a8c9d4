// Groups of neighbouring faces with similar normals. Most groups are decided as a whole, so that
// culling does not have to visit every face in every step. Cost: O(faces) to build.
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
  /// Faces of a cluster: larger clusters have wider cones, and more of them would be mixed.
  static constexpr std::uint32_t kMaxFaces = 24;

  std::vector<FaceCluster> clusters;
  std::vector<std::uint32_t> faces;        ///< the faces in the order of the clusters
  std::vector<std::uint32_t> clusterOf;    ///< per face
  std::vector<std::uint32_t> indexOf;      ///< per face: its index in `faces`
  std::vector<std::uint32_t> innerEdges;   ///< edges whose two faces are in one cluster, by cluster
  std::vector<std::uint32_t> borderEdges;  ///< all other edges, by pair of clusters
  /// What sampling needs of these edges, in their order: the indices in `faces` of the two faces
  /// (for a boundary edge the left one twice), and the end points.
  struct EdgeEnds {
    std::uint32_t left, right;
    std::int32_t a, b;
  };
  std::vector<EdgeEnds> innerEnds, borderEnds;

  /// A range of border edges with the same pair of clusters, whose faces run along the edge in the
  /// same sense.
  struct Border {
    std::uint32_t firstEdge = 0, edgeCount = 0;
    std::int32_t left = 0;
    /// Cluster; -1: boundary and non-manifold edges, which are never enclosed.
    std::int32_t right = -1;
    bool opposed = false;
  };
  std::vector<Border> borders;
  /// Per cluster the first border that has it on its left, and one entry behind the last: from
  /// there on come those with no cluster on their right.
  std::vector<std::uint32_t> firstBorder;

  /// What a first test of a face needs, in the order of `faces`.
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
