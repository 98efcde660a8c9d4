// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/checkpoint_hook.h"
#include "fuzz/inputs.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "swept/preview.h"

namespace swept::fuzz {
namespace {

Options options(ByteSource& bytes) {
  Options options;
  options.backend = Backend::Cpu;
  options.resolution = 4 + bytes.below(28);
  if (bytes.chance(32)) options.cellSize = std::abs(bytes.odd());
  if (bytes.chance(8)) options.cellSize = bytes.special();
  if (bytes.chance(4)) options.resolution = bytes.byte() * 10000 - 5;
  if (bytes.chance(64)) {
    constexpr ComponentMethod kMethods[] = {
        ComponentMethod::Consistent, ComponentMethod::DualContouring,
        ComponentMethod::DualMarchingCubes, ComponentMethod::Equivalence, ComponentMethod::Greedy};
    options.components = kMethods[bytes.below(5)];
  }
  if (bytes.chance(64)) options.tolerance = std::abs(bytes.number()) / 8;
  options.keepCavities = bytes.chance(64);
  options.cull = bytes.chance(200);
  if (bytes.chance(16)) options.offset = bytes.number() / 4;
  options.conservative = bytes.chance(16);
  if (bytes.chance(16)) options.positionFilter = bytes.number() / 4;
  if (bytes.chance(16)) options.chordTolerance = bytes.number();
  if (bytes.chance(16)) options.weldTolerance = bytes.number() / 8;
  return options;
}

void show(const TriMesh& mesh, const Trajectory& motion, const Options& o) {
  std::printf("resolution %d cell %g components %s tolerance %g cavities %d cull %d offset %g\n",
              o.resolution, o.cellSize.value_or(0), componentMethodName(o.components), o.tolerance,
              o.keepCavities, o.cull, o.offset);
  std::printf("conservative %d filter %g chord %g weld %g\n", o.conservative, o.positionFilter,
              o.chordTolerance.value_or(-1), o.weldTolerance.value_or(-1));
  fuzz::show(motion);
  fuzz::show(mesh);
}

void require(bool holds, const std::string& what, const Report& report) {
  if (holds) return;
  throw BrokenPromise(what + " (" + statusName(report.status) + "/" + report.code + ": " +
                      report.message + ")");
}

/// Checks a result with the status Ok. With a tolerance, vertices may leave the planned box by this
/// distance.
void requireOk(const Result& result, const Options& options, double tolerance) {
  const Report& report = result.report;
  require(report.code.empty() && report.message.empty(), "Ok with a complaint", report);
  require(!result.mesh.triangles.empty(), "Ok without a mesh", report);
  require(report.check.finite, "Ok with numbers that are not finite", report);
  require(report.check.passes() || options.components != ComponentMethod::Consistent,
          "Ok although the check failed", report);
  require(result.contactTime.size() == result.mesh.vertices.size(), "times do not fit", report);
  Eigen::Vector3d cells(static_cast<double>(report.grid[0]), static_cast<double>(report.grid[1]),
                        static_cast<double>(report.grid[2]));
  const Eigen::Array3d slack = Eigen::Array3d::Constant(tolerance);
  const Eigen::AlignedBox3d box(report.gridOrigin - slack.matrix(),
                                report.gridOrigin + cells * report.cellSize + slack.matrix());
  for (const auto& v : result.mesh.vertices) {
    require(box.contains(v), "a vertex outside the planned box", report);
  }
}

/// Checks that a grown envelope contains the plain one, to within a cell.
void requireGrown(const Result& grown, const TriMesh& mesh, const Trajectory& trajectory,
                  Options options) {
  RunContext run;
  limit(run);
  options.offset = 0;
  options.conservative = false;
  options.cellSize = grown.report.cellSize;
  const Result plain = compute(mesh, trajectory, options, run);
  if (plain.report.status != Status::Ok) return;
  const MeshCheck& check = plain.report.check;
  require(grown.report.check.volume >= check.volume - check.area * *options.cellSize,
          "grown from " + std::to_string(check.volume) + " to " +
              std::to_string(grown.report.check.volume) + " mm^3",
          grown.report);
}

void requireFailure(const Result& result) {
  const Report& report = result.report;
  requireNamed("a run", report.status, report.code, report.message);
  require(result.mesh.vertices.empty() && result.mesh.triangles.empty() &&
              result.contactTime.empty() && result.featureEdges.empty() && !result.kept,
          "a failure that leaves something", report);
}

}  // namespace

void envelope(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  const Options chosen = options(bytes);
  const Trajectory trajectory = motion(bytes);
  RunContext run;
  limit(run);
  if (bytes.chance(16)) CheckpointHook::cancelAt(run, bytes.byte());
  const TriMesh mesh = body(bytes);
  if (printsInputs()) show(mesh, trajectory, chosen);
  Result result = compute(mesh, trajectory, chosen, run);
  if (result.report.status != Status::Ok) {
    requireFailure(result);
    return;
  }
  requireOk(result, chosen, chosen.tolerance);
  if (chosen.tolerance == 0 && (chosen.offset > 0 || chosen.conservative))
    requireGrown(result, mesh, trajectory, chosen);
  if (result.kept == nullptr) return;
  double tolerance = std::abs(bytes.number());
  try {
    recut(result, tolerance, run);
  } catch (const Error& error) {
    requireNamed("a cut at another tolerance", error);
    tolerance = chosen.tolerance;  // the result has not changed
  }
  requireOk(result, chosen, tolerance);
}

void preview(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  const Options chosen = options(bytes);
  Trajectory trajectory = motion(bytes);
  RunContext run;
  limit(run);
  const TriMesh mesh = body(bytes);
  try {
    PreviewSession session(mesh, chosen, run);
    const int calls = 1 + bytes.below(4);
    for (int i = 0; i < calls; ++i) {
      RunContext call;
      limit(call);
      if (bytes.chance(16)) CheckpointHook::cancelAt(call, bytes.byte());
      if (printsInputs()) show(mesh, trajectory, chosen);
      const Result result = session.compute(trajectory, call);
      result.report.status == Status::Ok ? requireOk(result, chosen, 0) : requireFailure(result);
      // The motion is edited as in the motion editor: one pose is moved, another is added or
      // deleted.
      if (!trajectory.poses.empty())
        trajectory.poses[bytes.byte() % trajectory.poses.size()].translation = bytes.point();
      if (bytes.chance(64)) {
        Pose pose = trajectory.poses.empty() ? Pose{} : trajectory.poses.back();
        pose.timeSeconds += 1;
        pose.translation += bytes.point();
        trajectory.poses.push_back(pose);
      } else if (bytes.chance(64) && !trajectory.poses.empty()) {
        trajectory.poses.pop_back();
      }
      if (bytes.chance(128) && !chosen.conservative) session.sketch(trajectory, call);
    }
  } catch (const Error& error) {
    requireNamed("a preview", error);
  }
}

}  // namespace swept::fuzz
