// Computes the envelope of a body that moves along a trajectory.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {

class Simplifier;

/// The envelope mesh and what is known about it. `mesh` is empty unless report.status is Ok.
struct Result {
  Report report;
  TriMesh mesh;
  std::vector<double> contactTime;  ///< for each vertex: the time (s) at which the body touches it
  std::vector<std::array<std::int32_t, 2>>
      featureEdges;  ///< pairs of vertices along creases and between corners
  Sources sources;   ///< empty unless Options::sources is set
  /// The surface before simplification, which recut() simplifies to another tolerance. Set only if
  /// Options::tolerance was above 0.
  std::shared_ptr<const Simplifier> kept;
};

/// Never throws, except std::bad_alloc while copying an error message. report.status describes a
/// failure.
Result compute(const TriMesh& body, const Trajectory& trajectory, const Options& options,
               RunContext& run);

/// Simplifies the kept surface of a result to another tolerance (mm, up to 1e9; 0: no
/// simplification) without sampling again. Changes mesh, contactTime, featureEdges, sources.of,
/// report.check and report.simplificationDeviation. Throws Error, and then leaves the result
/// unchanged.
void recut(Result& result, double tolerance, RunContext& run);

/// Estimated effort of a run.
struct Estimate {
  std::array<std::int64_t, 3> grid{0, 0, 0};
  double cellSize = 0;  ///< mm
  std::uint64_t memoryBytes = 0;
  double seconds = 0;          ///< rough estimate for this machine
  std::int64_t triangles = 0;  ///< rough estimate
  /// mm: a position filter that skips at least two thirds of the poses and changes the result by no
  /// more than the chord error. Set only by estimateByTrial(), if there is one.
  std::optional<double> usefulFilter;
};
/// Estimates from bounding boxes only, in milliseconds. Throws the Error that compute() would
/// report.
Estimate estimate(const TriMesh& body, const Trajectory& trajectory, const Options& options);
/// Checks the body and samples a few motion steps for a better estimate. Takes up to about a
/// second, and never longer than the run itself would. Throws the Error that compute() would
/// report.
Estimate estimateByTrial(const TriMesh& body, const Trajectory& trajectory, const Options& options,
                         RunContext& run);

/// Checks any mesh: closed, manifold, oriented, self-intersections (docs/pipeline.md, "Check").
/// Throws Error(InvalidInput, "BadIndex"), Error(Cancelled).
MeshCheck checkMesh(const TriMesh& mesh, RunContext& run);

}  // namespace swept
