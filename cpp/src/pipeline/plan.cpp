// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/plan.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "base/accuracy_text.h"
#include "base/memory.h"
#include "base/number_text.h"
#include "geometry/mesh_parts.h"
#include "grid/plan_grid.h"
#include "motion/merge_steps.h"
#include "motion/pivot.h"
#include "motion/position_filter.h"
#include "motion/refine_motion.h"
#include "motion/split_edges.h"
#include "pipeline/thinned_body.h"
#include "pipeline/trial_steps.h"
#include "sampling/dense/dense_sampler.h"
#include "swept/preview.h"

namespace swept {
namespace {

/// Enlarges the box of the sweep by the space that an offset or a conservative envelope needs.
Eigen::AlignedBox3d grownBox(Eigen::AlignedBox3d box, double cell, const Options& options) {
  const double cells = options.conservative ? kMaxMarginCells : 0;
  const double margin =
      options.offset + cells * cell + (options.conservative ? options.tolerance : 0);
  box.min().array() -= margin;
  box.max().array() += margin;
  return box;
}

/// Margin on every side of the grid of a preview session, as a fraction of the longest side.
/// Motions of later calls can then use the same grid.
constexpr double kMargin = 0.03;

Eigen::AlignedBox3d withRoom(Eigen::AlignedBox3d box) {
  const double margin = kMargin * box.sizes().maxCoeff();
  box.min().array() -= margin;
  box.max().array() += margin;
  return box;
}

/// Mean memory (bytes) per copy of a triangle with its side patches. It is small, since most copies
/// cross no grid line or lie inside the sweep.
constexpr double kBytesPerCopy = 24;
/// Largest number of triangle copies in a preview, so that it stays quick.
constexpr double kPreviewCopies = 4e6;

/// Refines the motion, but only so finely that the copies of triangles take at most half of the
/// memory limit. Then merges the steps that are not needed for the chord tolerance. Splits the long
/// edges of a turning body if `maySplit`.
Motion refined(Prepared& p, const Options& options, double cell, bool maySplit, RunContext& run) {
  const Trajectory& trajectory = p.trajectory.trajectory;
  const double chord = allowedChord(p, options, cell);
  if (!(options.offset > 0 || options.conservative)) {
    const std::uint64_t limit = memoryLimit(run);
    const double maxCopies = limit == 0 ? 1e300 : static_cast<double>(limit) / 2 / kBytesPerCopy;
    const MotionApproximation how = planApproximation(
        p.body.mesh, trajectory, chord, cell,
        p.keepRoom ? std::min(maxCopies, kPreviewCopies) : maxCopies, maySplit, run);
    if (std::isfinite(how.longestEdge)) p.body.mesh = splitEdges(p.body.mesh, how.longestEdge, run);
    return mergeSteps(refineMotion(p.body.mesh, trajectory, how.chord, run), p.body.mesh, chord,
                      run);
  }
  // offset/cover.h flattens side patches itself. So only the chords of points matter here, and the
  // body is replaced by its vertices. An offset is measured from the chords, a conservative
  // envelope from the true motion near them.
  TriMesh points;
  points.vertices = p.body.mesh.vertices;
  return mergeSteps(refineMotion(points, trajectory, chord / 2, run), points, chord / 2, run);
}

/// Plans the run on the grid of the previous run. Returns false if the sweep leaves that grid or
/// fills too little of it.
bool planOnLastGrid(Prepared& p, const Options& options, RunContext& run) {
  const GridPlan& last = *p.lastGrid;
  Motion motion = refined(p, options, last.cell, false, run);
  const Eigen::AlignedBox3d box = grownBox(sweptBox(p.body.mesh, motion, run), last.cell, options);
  constexpr double kMinFilled = 0.75;
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = last.cell * (last.points[axis] - 1), margin = last.cell * kGridMarginCells;
    longest = std::max(longest, side);
    if (box.min()[axis] < last.origin[axis] + margin) return false;
    if (box.max()[axis] > last.origin[axis] + side - margin) return false;
  }
  if (box.sizes().maxCoeff() < kMinFilled * longest) return false;
  p.motion = std::move(motion);
  p.grid = last;
  return true;
}

}  // namespace

void prepareTrajectory(Prepared& p, const Trajectory& trajectory, const Options& options) {
  p.trajectory = checkTrajectory(trajectory);
  p.trajectory.trajectory = carriedByPivot(std::move(p.trajectory.trajectory), p.pivot);
  p.givenPoses = p.trajectory.trajectory.poses.size();
  if (!(options.positionFilter > 0)) return;
  FilteredTrajectory filtered =
      filterPositions(p.trajectory.trajectory, boxOf(p.body.mesh), options.positionFilter);
  p.trajectory.findings.push_back(
      {"PositionFiltered",
       filtered.dropped,
       {},
       textOf(4, filtered.dropped, " of ", p.givenPoses,
              " poses were left out; at each of them, no point of the part is farther than ",
              filtered.distance, " mm from its place at the last pose used")});
  p.trajectory.trajectory = std::move(filtered.trajectory);
  for (std::int32_t& pose : filtered.kept) pose = p.trajectory.given[pose];
  p.trajectory.given = std::move(filtered.kept);
  p.positionFilterDistance = filtered.distance;
}

// The grid depends on the motion, and the refined motion on the cell. So a first, coarse motion
// determines the cell.
void planRun(Prepared& p, const Options& options, RunContext& run) {
  if (p.lastGrid != nullptr && planOnLastGrid(p, options, run)) return;
  const Eigen::AlignedBox3d bodyBox = boxOf(p.body.mesh);
  const double size = bodyBox.diagonal().norm();
  const Trajectory& trajectory = p.trajectory.trajectory;
  double cell = options.cellSize.value_or(0);
  if (!options.cellSize) {
    const Motion coarse = refineMotion(p.body.mesh, trajectory, size / 50, run);
    Eigen::AlignedBox3d box = sweptBox(p.body.mesh, coarse, run);
    if (p.keepRoom) box = withRoom(box);
    for (int i = 0; i < 3; ++i) cell = plannedCell(grownBox(box, cell, options), options);
  }
  const TriMesh given = p.body.mesh;  // body before edges are split: same box, fewer vertices
  // If the cell size is given, planGrid() is called once before edges are split. It throws if the
  // cell is too small for any grid.
  if (!p.keepBody && options.cellSize && trajectory.interpolation != Interpolation::None) {
    const Motion coarse = refineMotion(p.body.mesh, trajectory, size / 50, run);
    planGrid(sweptBox(p.body.mesh, coarse, run), bodyBox, options);
  }
  p.motion = refined(p, options, cell, !p.keepBody, run);
  if (std::optional<TriMesh> thin = thinnedBody(p, given, cell, options, run)) {
    p.body.mesh = std::move(*thin);
    p.bodyDeviation = bodyThinning(p, cell, options);
    p.motion = refined(p, options, cell, !p.keepBody, run);
  }
  const Eigen::AlignedBox3d box = grownBox(sweptBox(given, p.motion, run), cell, options);
  Options fixed = options;
  if (p.keepRoom) fixed.cellSize = cell;
  p.grid = planGrid(p.keepRoom ? withRoom(box) : box, bodyBox, fixed);
}

double allowedChord(const Prepared& p, const Options& options, double cell) {
  const double chord = chordTolerance(options, cell);
  return p.keepRoom ? std::max(chord, kPreviewChord * cell) : chord;
}

bool exceedsChord(const Prepared& p, double cell, const Options& options) {
  constexpr double kRounding = 1 + 1e-6;
  return p.motion.chordError > kRounding * allowedChord(p, options, cell);
}

// Returns the peak memory (bytes) per crossing of the surface: the larger of two phases. Sampling
// keeps raw crossings twice (12 bytes each). Later phases keep edges, crossings, cells and the mesh
// (about 170 bytes).
double bytesOfCrossing(const Options& options) {
  constexpr double kSource = sizeof(SurfaceSource) + sizeof(double);  // a row, and the exact time
  return options.sources ? 180 + kSource : 180;
}

std::uint64_t denseBytes(const TriMesh& body) {
  return 250'000'000 + 3200 * static_cast<std::uint64_t>(body.triangles.size());
}

// Returns a rough estimate. It assumes that the surface of the sweep is 1.5 times that of its
// bounding box.
Estimate estimateOf(const Prepared& p, const Options& options) {
  Estimate e;
  e.grid = p.grid.cells();
  e.cellSize = p.grid.cell;
  const double x = static_cast<double>(e.grid[0]), y = static_cast<double>(e.grid[1]),
               z = static_cast<double>(e.grid[2]);
  const double crossings = 1.5 * 2 * (x * y + y * z + z * x) * 1.5;
  const double faces = static_cast<double>(p.body.mesh.triangles.size());
  const double placements = static_cast<double>(p.motion.placements.size());
  e.triangles = static_cast<std::int64_t>(2 * crossings);
  e.memoryBytes = static_cast<std::uint64_t>(crossings * bytesOfCrossing(options) + faces * 200 +
                                             placements * 500 + (x + 1) * (y + 1) * 24);
  double elements = faces * placements * (p.motion.continuous ? 5e-9 : 8e-8);
  if (options.backend != Backend::Gpu &&
      dense::suits(p.body.mesh, p.motion, p.grid.cell, options.cull, true, {})) {
    // The dense sampler searches for the best placements of every vertex and samples some tens of
    // copies of each face, in batches.
    elements = 0.4 + placements * 2e-6 + faces * 1.1e-4 + crossings * 1e-6;
    e.memoryBytes += denseBytes(p.body.mesh);
  }
  e.seconds = 0.02 + crossings * 0.4e-6 + elements;
  return e;
}

std::optional<double> usefulFilterOf(const Prepared& p, const Options& options) {
  constexpr std::size_t kManyPoses = 1000, kMinReduction = 3;
  const std::size_t poses = p.trajectory.trajectory.poses.size();
  const double distance = allowedChord(p, options, p.grid.cell);
  if (poses < kManyPoses || options.positionFilter > 0 || options.conservative) return std::nullopt;
  // The time of the dense sampler hardly depends on the number of poses, so a filter saves nothing.
  if (options.backend != Backend::Gpu &&
      dense::suits(p.body.mesh, p.motion, p.grid.cell, options.cull, true, {})) {
    return std::nullopt;
  }
  const FilteredTrajectory kept =
      filterPositions(p.trajectory.trajectory, boxOf(p.body.mesh), distance);
  // Merged steps (motion/merge_steps.h) may have saved the time already.
  const std::size_t used = std::min(poses, p.motion.placements.size());
  if (kMinReduction * kept.trajectory.poses.size() > used) return std::nullopt;
  return distance;
}

bool fitsMemory(const Estimate& e, const RunContext& run, std::uint64_t times) {
  const std::uint64_t limit = memoryLimit(run);
  return limit == 0 || e.memoryBytes <= limit / times;
}

void requireMemory(const Estimate& e, const RunContext& run) {
  if (fitsMemory(e, run)) return;
  const std::uint64_t limit = memoryLimit(run);
  const double ratio = std::sqrt(static_cast<double>(e.memoryBytes) / static_cast<double>(limit));
  throw Error(
      Status::ResourceLimit, "ResourceLimit",
      textOf(4, "the run would need about ", e.memoryBytes / 1'000'000,
             " MB of memory for a grid of ", e.grid[0], " x ", e.grid[1], " x ", e.grid[2],
             " cells, but the limit is ", limit / 1'000'000,
             " MB; the smallest cell that fits is about ", cellOrAccuracy(e.cellSize * ratio)));
}

namespace {

/// Plans a run. `body` is in coordinates about the pivot of the trajectory.
Prepared preparedFor(CheckedBody body, const Trajectory& trajectory, const Options& options,
                     RunContext& run) {
  Prepared prepared;
  prepared.pivot = pivotOf(trajectory);
  prepared.body = std::move(body);
  prepareTrajectory(prepared, trajectory, options);
  planRun(prepared, options, run);
  return prepared;
}

}  // namespace

Estimate estimate(const TriMesh& body, const Trajectory& trajectory, const Options& options) {
  checkOptions(options);
  RunContext run;
  CheckedBody unchecked;
  unchecked.mesh = seenFromPivot(body, pivotOf(trajectory));
  return estimateOf(preparedFor(std::move(unchecked), trajectory, options, run), options);
}

Estimate estimateByTrial(const TriMesh& body, const Trajectory& trajectory, const Options& options,
                         RunContext& run) {
  checkOptions(options);
  BodyCost cost;
  CheckedBody checked;
  {
    const std::uint64_t resident = residentMemoryBytes();
    const std::clock_t start = std::clock();
    const MemoryWatch memory;
    checked = checkBody(seenFromPivot(body, pivotOf(trajectory)), options, run);
    cost.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    cost.bytes = memory.peakBytes() - std::min(memory.peakBytes(), resident);
  }
  const Prepared prepared = preparedFor(std::move(checked), trajectory, options, run);
  Estimate found = estimateByTrial(estimateOf(prepared, options), prepared,
                                   buildTopology(prepared.body.mesh), cost, options, run);
  found.usefulFilter = usefulFilterOf(prepared, options);
  return found;
}

}  // namespace swept
