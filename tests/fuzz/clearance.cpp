// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/clearance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/checkpoint_hook.h"
#include "fuzz/inputs.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "support/mesh_distance.h"
#include "swept/compute.h"

namespace swept::fuzz {
namespace {

constexpr int kMaxCheckpoints = 150;  ///< enough for some tenths of a second

ClearanceOptions clearanceOptions(ByteSource& bytes) {
  ClearanceOptions options;
  if (bytes.chance(128)) options.required = std::abs(bytes.number());
  if (bytes.chance(64)) options.tolerance = std::abs(bytes.number()) / 16;
  if (bytes.chance(32)) options.bodyChordError = bytes.number() / 64;
  if (bytes.chance(32)) options.intervalTolerance = bytes.number();
  options.curveSamples = bytes.chance(8) ? bytes.byte() * 100 - 5 : bytes.below(20);
  options.penetration = bytes.chance(200);
  return options;
}

std::vector<ClearanceNeighbour> neighbours(ByteSource& bytes) {
  std::vector<ClearanceNeighbour> parts;
  const int count = bytes.below(4);
  for (int i = 0; i < count; ++i) {
    ClearanceNeighbour part{std::to_string(i), body(bytes), 0};
    if (bytes.chance(32)) part.chordError = bytes.number() / 64;
    // The offset puts most parts beside the moving body, not into it.
    const Eigen::Vector3d aside(bytes.even(), bytes.even(), bytes.even());
    for (auto& v : part.mesh.vertices) v += aside;
    parts.push_back(std::move(part));
  }
  return parts;
}

void require(bool holds, const std::string& what, const NeighbourClearance& row) {
  if (holds) return;
  throw BrokenPromise("neighbour " + row.name + ", " + clearanceVerdictName(row.verdict) + " at " +
                      std::to_string(row.distance) + " mm: " + what);
}

void requireSpans(const std::vector<TimeInterval>& spans, const Trajectory& motion,
                  const NeighbourClearance& row) {
  for (const TimeInterval& span : spans) {
    require(span.from <= span.to, "a span of time that runs backwards", row);
    require(
        span.from >= motion.poses.front().timeSeconds && span.to <= motion.poses.back().timeSeconds,
        "a span of time outside the motion", row);
  }
}

void requireRow(const NeighbourClearance& row, const Trajectory& motion) {
  require(std::isfinite(row.distance) && row.distance >= 0, "no distance", row);
  require(row.guaranteed >= 0 && row.guaranteed <= row.distance, "guarantees too much", row);
  require(row.pointOnBody.allFinite() && row.pointOnNeighbour.allFinite(), "no points", row);
  require(row.pose.translation.allFinite() && row.pose.rotation.coeffs().allFinite(), "no pose",
          row);
  require(row.timeSeconds >= motion.poses.front().timeSeconds &&
              row.timeSeconds <= motion.poses.back().timeSeconds,
          "a time outside the motion", row);
  requireSpans(row.below, motion, row);
  requireSpans(row.contact, motion, row);
  for (const CurvePoint& point : row.curve) {
    require(point.distance >= 0 && std::isfinite(point.distance), "a hole in the curve", row);
  }
}

/// Returns whether it is defined, without mending the mesh, which points lie inside.
bool isClosed(const TriMesh& mesh) {
  RunContext run;
  const MeshCheck check = checkMesh(mesh, run);
  return check.closed && check.misorientedEdges == 0;
}

// Measures the corners of the body at the given poses. None may be nearer, or deeper inside, than
// the result says.
void requireCorners(const NeighbourClearance& row, const TriMesh& body, const Trajectory& motion,
                    const TriMesh& part, const ClearanceOptions& options) {
  double size = 1;
  for (const TriMesh* mesh : {&body, &part}) {
    for (const auto& v : mesh->vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  }
  for (const Pose& pose : motion.poses) {
    size = std::max(size, pose.translation.cwiseAbs().maxCoeff());
  }
  const double rounding = 1e-3 + 1e-9 * size;  // 1e-3: the rotation of a pose may be off by 1e-4
  const double touch = options.tolerance + row.chordError + rounding;
  const test::MeshDistance surface(part);
  const bool partIsClosed = isClosed(part);
  for (const Pose& pose : motion.poses) {
    const Eigen::Matrix3d rotation = pose.rotation.normalized().toRotationMatrix();
    for (const auto& t : body.triangles) {
      const Eigen::Vector3d corner = rotation * body.vertices[t[0]] + pose.translation;
      const double distance = surface.distance(corner);
      require(distance >= row.distance - options.tolerance - rounding,
              "a corner is " + std::to_string(distance) + " mm away", row);
      if (!partIsClosed || distance <= touch || !surface.inside(corner)) continue;
      require(row.verdict == ClearanceVerdict::Clash, "a corner lies inside", row);
      require(!row.penetration.known || distance <= row.penetration.depthBound + touch,
              "a corner lies deeper inside", row);
    }
  }
}

}  // namespace

void clearance(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  const ClearanceOptions chosen = clearanceOptions(bytes);
  const Trajectory trajectory = motion(bytes);
  RunContext run;
  limit(run);
  // With parts of kilometres and an accuracy of a hundredth of a millimetre, a run would take
  // nearly for ever, so every run is cancelled after some checkpoints.
  CheckpointHook::cancelAt(run, bytes.chance(16) ? 1 + bytes.byte() : kMaxCheckpoints);
  const TriMesh mesh = body(bytes);
  const std::vector<ClearanceNeighbour> parts = neighbours(bytes);
  if (printsInputs()) {
    std::printf("tolerance %g\n", chosen.tolerance);
    show(trajectory);
    show(mesh);
    for (const ClearanceNeighbour& part : parts) show(part.mesh);
  }
  const ClearanceReport report = checkClearance(mesh, trajectory, parts, chosen, run);
  if (report.status != Status::Ok) {
    requireNamed("a clearance", report.status, report.code, report.message);
    return;
  }
  if (report.neighbours.size() != parts.size() || !report.smallest || report.summary.empty()) {
    throw BrokenPromise("a report with holes");
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    requireRow(report.neighbours[i], trajectory);
    requireCorners(report.neighbours[i], mesh, trajectory, parts[i].mesh, chosen);
  }
}

}  // namespace swept::fuzz
