// The contract of every sampler (cpu, gl, dense, fake): body + motion + grid -> marked edges.
// In: SamplerInput. Out: for every lattice edge that the swept surface crosses, the first crossing
// seen from each end. Units: mm; fractions of an edge. Promise: exact decisions, the same bytes for
// any number of threads. Source: METHOD.md section 2.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "geometry/body_topology.h"
#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct FaceClusters;
class InsideMap;
class PlaceGroups;
class SampleCache;

/// The placements [begin, end).
struct PlacementRange {
  std::size_t begin = 0, end = ~std::size_t{0};
};

struct SamplerInput {
  const TriMesh& body;
  const BodyTopology& topology;
  const Motion& motion;
  const GridPlan& grid;
  bool cull = true;  ///< drop provably enclosed faces and side patches
  /// Closed and consistently oriented outward: culling by direction is valid.
  bool orientable = true;
  const FaceClusters* clusters = nullptr;  ///< of the body, where they are known already
  SampleCache* cache = nullptr;            ///< of the CPU sampler, for continuous motions
  /// Receives the number of crossings that the CPU sampler sorts, which is what its memory holds.
  std::uint64_t* crossings = nullptr;
  /// Enclosed spaces count as inside, whatever they are: what lies deep inside may be left out.
  bool fillsHollows = false;
  const InsideMap* inside = nullptr;  ///< what is known to lie inside, for the CPU sampler
  /// Trials of the CPU sampler take some placements of a continuous motion, each with the step that
  /// starts there, as a run does.
  PlacementRange only{};
  const PlaceGroups* groups = nullptr;  ///< of the whole motion, where they are known already
  /// Trials show only one part in so many of the clusters of a closed body; 0: none of them.
  std::size_t clusterParts = 1;

  /// The same body along another motion or on another grid, without what is known of this one.
  SamplerInput with(const Motion& otherMotion, const GridPlan& otherGrid) const {
    return {body,       topology, otherMotion, otherGrid, cull,
            orientable, clusters, nullptr,     nullptr,   fillsHollows};
  }
};

/// The reference sampler: native code on all cores. Exact: vertices are snapped to odd multiples of
/// 2^-17 cell; every decision (does a line hit a triangle, on which side of a lattice point) is
/// then made in integers, with ties by simulation of simplicity (the lattice is shifted by (e, e^2,
/// e^3)). A closed surface therefore gives a closed set of crossings.
MarkedEdges sampleCpu(const SamplerInput& input, RunContext& run);

}  // namespace swept
