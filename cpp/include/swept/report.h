// What a run tells about itself: findings, sizes, timings, measured quality.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "swept/types.h"

namespace swept {

/// One note or warning: stable code, how many, first element indices, text for people.
struct Finding {
  std::string code;  ///< e.g. "Flipped", "SelfIntersections"
  std::int64_t count = 0;
  std::vector<std::int64_t> first;  ///< at most 8
  std::string text;
};

/// What the mesh checker found (check/mesh_check.h); every compute() carries one.
struct MeshCheck {
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::int64_t shells = 0;
  bool finite = true;
  bool closed = false;
  bool manifold = false;  ///< edges and vertices
  bool oriented = false;  ///< each edge once in each direction, outer shells outward
  std::int64_t openEdges = 0;
  std::int64_t nonManifoldEdges = 0;
  std::int64_t nonManifoldVertices = 0;
  std::int64_t misorientedEdges = 0;
  std::int64_t degenerateTriangles = 0;
  std::int64_t unusedVertices = 0;
  std::int64_t selfIntersections = 0;  ///< pairs of triangles; -1: not counted
  std::vector<std::pair<std::int64_t, std::int64_t>> firstIntersections;  ///< at most 32 pairs
  double volume = 0;                                                      ///< mm^3
  double area = 0;                                                        ///< mm^2
  bool passes() const {
    return finite && closed && manifold && oriented && degenerateTriangles == 0;
  }
};

struct StageSeconds {
  std::string stage;
  double seconds = 0;
};

struct Report {
  Status status = Status::Ok;
  std::string code;     ///< finding code of a failure, empty when Ok
  std::string message;  ///< for people; empty when Ok
  MeshCheck check;
  double cellSize = 0;                                   ///< mm
  Eigen::Vector3d gridOrigin = Eigen::Vector3d::Zero();  ///< lattice point (0,0,0), mm
  std::array<std::int64_t, 3> grid{0, 0, 0};             ///< cells along x, y, z
  std::int64_t placements = 0;
  std::int64_t refinedPlacements = 0;
  double positionFilterDistance = 0;  ///< mm: farthest a dropped pose was from a kept one
  std::int64_t sweptFaces = 0;        ///< face copies sampled after culling
  std::int64_t sweptPatches = 0;      ///< side patches sampled after culling
  std::int64_t crossings = 0;         ///< contributing crossings
  double largestStepTravel = 0;       ///< mm
  double chordError = 0;  ///< mm: bound on how far the refined motion leaves the true one
  double simplificationDeviation = 0;  ///< mm, measured both ways; 0: not simplified
  double conservativeBound = 0;        ///< mm: 0 unless conservative
  std::string backend = "cpu";
  std::string device;
  int threads = 0;
  std::vector<StageSeconds> seconds;  ///< "total" is the last entry
  std::uint64_t estimatedMemoryBytes = 0;
  std::uint64_t peakMemoryBytes = 0;
  std::vector<Finding> warnings;
};

/// The report as JSON text (UTF-8). Keys are those of docs/report.md.
std::string toJson(const Report& report);

}  // namespace swept
