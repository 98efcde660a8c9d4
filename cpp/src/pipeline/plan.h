// Plans a run before it samples.
// In:    checked body, any trajectory, options.
// Out:   checked trajectory, motion refined to the chord tolerance, grid with room for an offset,
//        estimate of memory and time. Refuses a run that does not fit into memory.
// Cost:  O(placements), plus the bounding box of the sweep.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>

#include "grid/grid_plan.h"
#include "input/body_check.h"
#include "input/options_check.h"
#include "input/trajectory_check.h"
#include "motion/motion.h"
#include "swept/compute.h"

namespace swept {

/// Margins (cells) of a conservative envelope. The run tries them in turn until containment is
/// proven.
constexpr std::array<double, 4> kMarginCells{1.0, 1.5, 2.0, 2.5};
constexpr double kMaxMarginCells = kMarginCells.back();

struct Prepared {
  /// Pivot of the trajectory in coordinates of the given body. It is the origin of the coordinates
  /// of `body` and `trajectory`.
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
  CheckedBody body;
  CheckedTrajectory trajectory;
  std::size_t givenPoses = 0;         ///< number of poses before the position filter
  double positionFilterDistance = 0;  ///< mm, largest distance of a dropped pose from the last used
  /// Grid of the previous run, used again if the sweep still fits into it and fills most of it.
  /// With keepRoom (previews), a new grid has a margin for the sweeps of later calls.
  const GridPlan* lastGrid = nullptr;
  bool keepRoom = false;
  bool keepBody = false;     ///< true: do not split long edges, since the topology is in use
  double bodyDeviation = 0;  ///< mm, largest distance between the given body and the thinned one
  Motion motion;
  GridPlan grid;
};

/// Checks the trajectory and applies the position filter. Requires prepared.body.
void prepareTrajectory(Prepared& prepared, const Trajectory& trajectory, const Options& options);

/// Computes motion and grid. Requires prepared.body and prepared.trajectory.
void planRun(Prepared& prepared, const Options& options, RunContext& run);

/// Returns the chord tolerance (mm) for cells of this size (mm); in previews, it is larger. Throws
/// Error(InvalidInput, "BadOption") if the chord tolerance of the options is larger than a cell.
double allowedChord(const Prepared& prepared, const Options& options, double cell);
/// Returns whether the motion has too few placements for the chord tolerance, to save memory.
bool exceedsChord(const Prepared& prepared, double cell, const Options& options);

Estimate estimateOf(const Prepared& prepared, const Options& options);
/// Returns the bytes per crossing of the surface at the peak of a run.
double bytesOfCrossing(const Options& options);
/// Returns the bytes that estimateOf() adds for the dense sampler. Most of them are for its largest
/// batch.
std::uint64_t denseBytes(const TriMesh& body);

/// Returns Estimate::usefulFilter. Requires the grid and the unfiltered poses.
std::optional<double> usefulFilterOf(const Prepared& prepared, const Options& options);

/// Returns whether the run fits into its memory limit if it takes `times` the estimated memory.
bool fitsMemory(const Estimate& estimate, const RunContext& run, std::uint64_t times = 1);
/// Throws Error(ResourceLimit) if the run would exceed its memory limit.
void requireMemory(const Estimate& estimate, const RunContext& run);

}  // namespace swept
