// What a run needs to know before it samples: checked inputs, placements, grid, and what it takes.
// In:    checked body, any trajectory, options. Out: motion refined to the chord of the options,
// grid
//        with room for an offset, estimate of memory and time; refuses what does not fit.
// Cost:  O(placements), but for the box of the sweep.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>

#include "grid/grid_plan.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "motion/motion.h"
#include "swept/compute.h"

namespace swept {

/// A conservative surface is looked for at these distances (cells) until one is proven.
constexpr std::array<double, 4> kMarginCells{1.0, 1.5, 2.0, 2.5};
constexpr double kMaxMarginCells = kMarginCells.back();

struct Prepared {
  /// Origin of the coordinates of body and trajectory, in those of the body as given.
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  CheckedBody body;
  CheckedTrajectory trajectory;
  std::size_t givenPoses = 0;         ///< before the position filter
  double positionFilterDistance = 0;  ///< mm
  /// Grid of the run before, to be used again if the sweep still suits it; a new one then gets some
  /// room for sweeps to come.
  const GridPlan* lastGrid = nullptr;
  bool keepRoom = false;
  bool keepBody = false;  ///< its topology is known: long edges stay as they are
  Motion motion;
  GridPlan grid;
};

/// Checks the trajectory and leaves out what the position filter drops. Needs the body.
void prepareTrajectory(Prepared& prepared, const Trajectory& trajectory, const Options& options);

/// Motion and grid. Needs body and trajectory.
void planRun(Prepared& prepared, const Options& options, RunContext& run);

Estimate estimateOf(const Prepared& prepared, const Options& options);
/// At the peak of a run.
double bytesOfCrossing(const Options& options);
/// What estimateOf() takes for the dense sampler; most of it is the largest batch.
std::uint64_t denseBytes(const TriMesh& body);

/// See Estimate::usefulFilter. Needs the grid, and the poses without a filter.
double usefulFilterOf(const Prepared& prepared, const Options& options);

/// Does the run fit into its budget if it takes `times` what the estimate says?
bool fitsMemory(const Estimate& estimate, const RunContext& run, std::uint64_t times = 1);
/// Throws Error(ResourceLimit) if the run would take more memory than it may.
void requireMemory(const Estimate& estimate, const RunContext& run);

}  // namespace swept
