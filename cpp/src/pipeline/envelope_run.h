// One run from body and trajectory to the envelope, stage by stage.
// In:    options, body, trajectory.
// Out:   mesh, contact times, feature edges, and the report with the seconds of each stage. Throws
//        Error.
// Cost:  see docs/performance.md.
// Promise: the same bytes for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/timer.h"
#include "check/mesh_check.h"
#include "contour/surface.h"
#include "geometry/body_topology.h"
#include "pipeline/finish_surface.h"
#include "pipeline/grown_sweep.h"
#include "pipeline/plan.h"
#include "sampling/cpu/sample_cache.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/sampler.h"

namespace swept {

/// The data that a preview session keeps between calls.
struct WarmBody {
  CheckedBody body;
  BodyTopology topology;
  FaceClusters clusters;
  std::optional<GridPlan> grid;
  SampleCache cache;

  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();  ///< origin of the body's coordinates

  void setBody(CheckedBody checked);
  void setPivot(const Eigen::Vector3d& wanted);
};

class EnvelopeRun {
 public:
  EnvelopeRun(const Options& options, RunContext& context, Result& result)
      : options_(options), run_(context), result_(result), report_(result.report) {}

  void compute(const TriMesh& body, const Trajectory& trajectory);
  /// Does the same with a body that is checked already. With `sketch`, the contoured surface is not
  /// repaired, checked or simplified.
  void compute(WarmBody& warm, const Trajectory& trajectory, bool sketch);

 private:
  void begin();
  void sweep(const Trajectory& trajectory);
  void refuseCombinations() const;
  void stage(const char* name) { report_.seconds.push_back({name, timer_.lap()}); }

  void describePlan();
  void adviseFilter();
  SamplerInput samplerInput(const BodyTopology& topology, bool cull) const;

  /// Computes the swept volume itself into result_.mesh.
  void envelope(const BodyTopology& topology);
  void finish(Surface surface, const HermiteGrid& hermite, SettlingMoves settlingMoves = {});

  /// Computes the swept volume grown by the offset, or a conservative envelope with its proof.
  void grow(const BodyTopology& topology);
  void growTo(const GrownSweep& sweep, const SamplerInput& input, double distance);
  HermiteGrid sample(const BodyTopology& topology, bool cull);
  void simplify();

  const Options& options_;
  RunContext& run_;
  Result& result_;
  Report& report_;
  Prepared prepared_;
  WarmBody* warm_ = nullptr;  ///< null without a session
  bool sketch_ = false;
  /// Adjacency of the mended mesh; empty if it was not computed.
  MeshTopology topology_;
  std::vector<SweptElement> elements_;  // kept until contouring no longer needs them
  Timer timer_;
  double cpuSeconds_ = 0;
};

}  // namespace swept
