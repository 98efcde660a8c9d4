// Groups of neighbouring faces with like normals: most are decided as a whole, so that the culling
// of enclosed faces does not have to look at every face in every step. Cost: O(faces) to build.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/body_topology.h"
#include "swept/types.h"

namespace swept {

struct FaceCluster {
  std::uint32_t firstFace = 0, faceCount = 0;  ///< in FaceClusters::faces
  std::uint32_t firstEdge = 0, edgeCount = 0;  ///< in FaceClusters::innerEdges
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;  ///< mm, ball about the centre that holds all vertices
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double cosCone = 1, sinCone = 0;  ///< every normal is within this of the axis
  double leastHeight = 0;           ///< mm, of its triangles
};

struct FaceClusters {
  std::vector<FaceCluster> clusters;
  std::vector<std::uint32_t> faces;        ///< faces by cluster
  std::vector<std::uint32_t> clusterOf;    ///< per face
  std::vector<std::uint32_t> placeOf;      ///< per face: its place in `faces`
  std::vector<std::uint32_t> innerEdges;   ///< edges whose two faces are in one cluster, by cluster
  std::vector<std::uint32_t> borderEdges;  ///< all others, by pair of clusters
  /// What sampling needs of these edges, in their order: places in `faces` of the two faces (of the
  /// left one twice at rims), and the ends.
  struct EdgeEnds {
    std::uint32_t left, right;
    std::int32_t a, b;
  };
  std::vector<EdgeEnds> innerEnds, borderEnds;

  /// Border edges that have one pair of clusters and the same sense of "same way".
  struct Border {
    std::uint32_t firstEdge = 0, edgeCount = 0;
    std::int32_t left = 0;
    std::int32_t right = -1;  ///< cluster; -1: rims and the like, never enclosed
    bool opposed = false;
  };
  std::vector<Border> borders;

  /// What a first look at a face needs, in the order of `faces`.
  struct FaceBall {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();  ///< mm
    float radius = 0;                                  ///< mm, all corners are within
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float height = 0;  ///< mm, smallest of the triangle
  };
  std::vector<FaceBall> balls;
};

FaceClusters buildClusters(const TriMesh& body, const BodyTopology& topology);

}  // namespace swept
