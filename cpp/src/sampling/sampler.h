// The contract of every sampler (cpu, gl, dense).
// In: SamplerInput: body, motion, grid.
// Out: marked edges. Every lattice edge that the swept surface crosses has its first crossing from
// each end.
// Units: mm; fractions of an edge.
// Promise: exact decisions, the same bytes for any number of threads. Source: docs/pipeline.md.
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
class PlacementGroups;
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
  bool cull = true;  ///< leave out faces and side patches that provably lie inside the swept volume
  /// True if the body is closed and its normals point outward; culling by direction is then valid.
  bool orientable = true;
  const FaceClusters* clusters = nullptr;  ///< clusters of the body, if they exist already
  SampleCache* cache = nullptr;            ///< cache of the CPU sampler, for continuous motions
  /// Receives the number of crossings that the CPU sampler sorts, which determines its memory.
  std::uint64_t* crossings = nullptr;
  /// True if spaces that the outside does not reach always count as inside. Elements deep inside
  /// the sweep may then be left out.
  bool fillsHollows = false;
  const InsideMap* inside = nullptr;  ///< map of the inside of the sweep, for the CPU sampler
  /// The placements that a trial of the CPU sampler samples. In a continuous motion, the step that
  /// starts at such a placement is also sampled.
  PlacementRange only{};
  const PlacementGroups* groups = nullptr;  ///< groups of the whole motion, if they exist already
  /// A trial samples only one of this many parts of the clusters of a closed body
  /// (culling/kept_elements.h). 0: no clusters.
  std::size_t clusterParts = 1;

  /// Returns the input for another motion and grid, without the data that depend on the motion.
  SamplerInput with(const Motion& otherMotion, const GridPlan& otherGrid) const {
    return {body,       topology, otherMotion, otherGrid, cull,
            orientable, clusters, nullptr,     nullptr,   fillsHollows};
  }
};

/// The reference sampler, on all cores of the CPU. It snaps vertices to odd multiples of 2^-17
/// cell. Then it decides exactly, in integers, whether a line hits a triangle, and on which side of
/// a lattice point. Ties are decided by simulation of simplicity, as if the lattice were shifted by
/// (e, e^2, e^3). So a closed surface gives a consistent set of crossings.
MarkedEdges sampleCpu(const SamplerInput& input, RunContext& run);

}  // namespace swept
