// What a run reports: findings, sizes, timings, measured quality.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swept/types.h"

namespace swept {

/// One note or warning: a stable code, the number of cases, the first element indices, and a text
/// for people.
struct Finding {
  std::string code;  ///< e.g. "Flipped", "SelfIntersections"
  std::int64_t count = 0;
  std::vector<std::int64_t> first;  ///< at most 8
  std::string text;
};

/// Result of the mesh checker (check/mesh_check.h). Every result of compute() has one.
struct MeshCheck {
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  std::int64_t shells = 0;
  bool finite = true;
  bool closed = false;
  bool manifold = false;  ///< for edges and for vertices
  /// Each edge occurs once in each direction, and outer shells face outwards.
  bool oriented = false;
  std::int64_t openEdges = 0;
  std::int64_t nonManifoldEdges = 0;
  std::int64_t nonManifoldVertices = 0;
  std::int64_t misorientedEdges = 0;
  std::int64_t degenerateTriangles = 0;
  std::int64_t unusedVertices = 0;
  std::optional<std::int64_t> selfIntersections;  ///< pairs of triangles; not set: not counted
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

/// What the reports of all runs have in common. Unless the status is Ok, the run failed, and the
/// report has no result.
struct RunReport {
  Status status = Status::Ok;
  std::string code;                   ///< code of the failure; empty if Ok
  std::string message;                ///< for people; empty if Ok
  int threads = 0;                    ///< number of threads used
  std::vector<StageSeconds> seconds;  ///< "total" is the last entry
  std::vector<Finding> warnings;
};

struct Report : RunReport {
  MeshCheck check;
  double cellSize = 0;                                   ///< mm
  Eigen::Vector3d gridOrigin = Eigen::Vector3d::Zero();  ///< grid point (0, 0, 0), mm
  std::array<std::int64_t, 3> grid{0, 0, 0};             ///< cells along x, y, z
  std::int64_t placements = 0;
  std::int64_t refinedPlacements = 0;
  /// mm: largest distance of a body point between a skipped pose and the last pose kept before it.
  double positionFilterDistance = 0;
  std::int64_t sweptFaces = 0;    ///< copies of faces that were sampled after culling
  std::int64_t sweptPatches = 0;  ///< swept patches of edges that were sampled after culling
  std::int64_t crossings = 0;     ///< crossings that contribute to the envelope
  double largestStepTravel = 0;   ///< mm
  double chordError = 0;  ///< mm: bound on the deviation of the refined motion from the true motion
  /// mm: bound on the distance between the given body and the one that was swept in its place,
  /// which may be thinned.
  double bodyDeviation = 0;
  double simplificationDeviation = 0;  ///< mm, measured in both directions
  /// mm: bound on the distance of the envelope from the volume it must contain. Set only if the
  /// envelope is conservative.
  std::optional<double> conservativeBound;
  std::string backend = "cpu";
  std::string device;
  std::uint64_t estimatedMemoryBytes = 0;
  std::uint64_t peakMemoryBytes = 0;
};

/// Returns the report as JSON text (UTF-8). docs/report.md describes the keys.
std::string toJson(const Report& report);

}  // namespace swept
