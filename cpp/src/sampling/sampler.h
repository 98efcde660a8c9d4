// What every sampler (cpu, gl, fake) implements: body + motion + grid -> marked edges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/body_topology.h"
#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct FaceClusters;
class SampleCache;

struct SamplerInput {
  const TriMesh& body;
  const BodyTopology& topology;
  const Motion& motion;
  const GridPlan& grid;
  bool cull = true;        ///< drop provably enclosed faces and patches
  bool orientable = true;  ///< closed and consistently oriented outward: culling by direction holds
  const FaceClusters* clusters = nullptr;  ///< of the body, where they are known already
  SampleCache* cache = nullptr;            ///< of the CPU sampler, for continuous motions
};

/// The reference sampler, native, on all cores. Exact: vertices are snapped to odd multiples of
/// 2^-17 cell, every decision (ray hits triangle, which side of a lattice point) is then made in
/// integers with ties by simulation of simplicity (lattice shifted by (e, e^2, e^3)), so that a
/// closed surface gives a closed set of crossings.
MarkedEdges sampleCpu(const SamplerInput& input, RunContext& run);

}  // namespace swept
