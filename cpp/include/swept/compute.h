// The one call that matters: body + trajectory -> envelope.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {

class Simplifier;

/// Envelope mesh and what is known about it. `mesh` is empty unless report.status is Ok.
struct Result {
  Report report;
  TriMesh mesh;
  std::vector<double> contactTime;  ///< per vertex: s, when the surface point is touched
  std::vector<std::array<std::int32_t, 2>>
      featureEdges;  ///< vertex pairs along creases and corners
  Sources sources;   ///< empty unless Options::sources
  /// The surface before simplification, ready to be cut at another tolerance; only if
  /// Options::tolerance was above 0.
  std::shared_ptr<const Simplifier> kept;
};

/// Never throws except std::bad_alloc from copying its own message; failures are in report.status.
Result compute(const TriMesh& body, const Trajectory& trajectory, const Options& options,
               RunContext& run);

/// Simplifies the kept surface of a result to another tolerance (mm, up to 1e9; 0: not at all)
/// without sampling again: mesh, contactTime, featureEdges, sources.of, report.check and
/// report.simplificationDeviation change. Throws Error; the result is then as before.
void recut(Result& result, double tolerance, RunContext& run);

/// What a run would take.
struct Estimate {
  std::array<std::int64_t, 3> grid{0, 0, 0};
  double cellSize = 0;  ///< mm
  std::uint64_t memoryBytes = 0;
  double seconds = 0;          ///< rough, on this machine
  std::int64_t triangles = 0;  ///< rough
  /// mm: a position filter that leaves out two thirds of the poses or more and changes the result
  /// by no more than the chord does; 0: none
  double usefulFilter = 0;
};
/// In milliseconds, from boxes only. Throws Error as compute() would report it.
Estimate estimate(const TriMesh& body, const Trajectory& trajectory, const Options& options);
/// The same after a look: the body is checked and a few steps are sampled. Takes up to a second or
/// so, and never more than the run. Throws Error as compute() would report it.
Estimate estimateByTrial(const TriMesh& body, const Trajectory& trajectory, const Options& options,
                         RunContext& run);

/// Checks any mesh: closed, manifold, oriented, self-intersections (docs/pipeline.md, "Check").
MeshCheck checkMesh(const TriMesh& mesh, RunContext& run);

}  // namespace swept
