// Measures the clearance of a moving body from neighbouring parts, over the whole continuous
// motion.
// In:    body, trajectory and neighbours, all in the same world coordinates; required distance;
//        tolerances.
// Out:   for each neighbour: the smallest distance, where and when it occurs, the verdict, the
//        depth of a clash, and time intervals.
// Units: mm, s.
// Cost:  for each neighbour a few hundred to a few thousand distance queries, each O(log n) for n
//        triangles.
// Promise: the motion between two poses is bounded, not only sampled. No part of the motion comes
//        closer than `distance - tolerance` (docs/clearance.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "swept/neighbour_rule.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A part that stands still. chordError: how far (mm) its triangles may deviate from the exact
/// surface.
struct ClearanceNeighbour {
  std::string name;
  TriMesh mesh;
  double chordError = 0;
  NeighbourRule rule = {};  ///< the rule of this neighbour; replaces the common distance
};

struct ClearanceOptions {
  double required = 0;  ///< mm, distance that must be kept; 0: only contact and clash matter
  /// mm, largest error of the smallest distance, due to the motion between poses.
  double tolerance = 0.01;
  double bodyChordError = 0;  ///< mm, as ClearanceNeighbour::chordError, for the moving body
  /// Accuracy of the ends of intervals, as mm of travel, above 0. Not set: 10 times the tolerance.
  std::optional<double> intervalTolerance;
  int curveSamples = 200;   ///< number of points of the graph of distance over time, 0 or more
  bool penetration = true;  ///< measure the depth and the place of a clash
};

/// Contact: the measured distance is at most tolerance + chord errors, so the parts may touch.
/// Clash: the parts overlap by more than tolerance + chord errors. If the rule allows contact, they
/// also overlap by more than the rule allows.
/// BelowRequired: distance - chord errors is below the required distance.
/// Clear: none of these. The true distance may be below the required one by up to the tolerance.
enum class ClearanceVerdict { Clear, BelowRequired, Contact, Clash };
const char* clearanceVerdictName(ClearanceVerdict verdict);  // clear | below | contact | clash

/// Closed span of time. With Interpolation::None, both ends are times of poses.
struct TimeInterval {
  double from = 0;
  double to = 0;
};

struct CurvePoint {
  double timeSeconds = 0;
  double distance = 0;  ///< mm; 0 if the parts meet or one part lies inside the other
};

struct PenetrationResult {
  bool known = false;  ///< false: no clash, depth not measured, or neither mesh is closed
  /// Consider all surface points of one part that lie inside the other part during the motion.
  /// `depth` is the largest distance (mm) found from such a point to the surface of that other
  /// part. No point is deeper than depthBound.
  double depth = 0;
  double depthBound = 0;
  double timeSeconds = 0;
  double parameter = 0;  ///< pose index plus fraction of the motion step after that pose
  Pose pose;
  /// true: the deepest point belongs to the body; false: to the neighbour.
  bool pointOfBody = true;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< the deepest point, world coordinates
  /// The point of the other surface nearest to `point`
  Eigen::Vector3d surface = Eigen::Vector3d::Zero();
  /// Box (world coordinates, at `pose`) around the intersection of the surfaces and around all
  /// vertices of either part that lie inside the other.
  Eigen::Vector3d regionMin = Eigen::Vector3d::Zero();
  Eigen::Vector3d regionMax = Eigen::Vector3d::Zero();
};

struct NeighbourClearance {
  std::string name;
  NeighbourRule rule;  ///< the rule that was applied: a required distance, or allowed contact
  ClearanceVerdict verdict = ClearanceVerdict::Clear;
  double distance = 0;  ///< mm between the triangles, at most `tolerance` too large; 0: they meet
  /// Distance - chord errors - tolerance (the latter only if interpolated), at least 0.
  double guaranteed = 0;
  double chordError = 0;   ///< mm, sum of the chord errors of both parts
  double timeSeconds = 0;  ///< time of the smallest distance, or of the greatest depth of a clash
  Pose pose;               ///< placement of the body at that time
  Eigen::Vector3d pointOnBody = Eigen::Vector3d::Zero();       ///< world coordinates
  Eigen::Vector3d pointOnNeighbour = Eigen::Vector3d::Zero();  ///< world coordinates
  /// Indices of the triangles with these points. Not set in a clash, or if that mesh was repaired
  /// before the check.
  std::optional<std::int64_t> bodyTriangle;
  std::optional<std::int64_t> neighbourTriangle;
  bool closed = true;   ///< false: the neighbour's mesh is open, so its inside is not defined
  bool inside = false;  ///< true: at some time, one part lies inside the other without touching it
  PenetrationResult penetration;
  /// When the distance, less the chord errors, is below the required one (if required > 0)
  std::vector<TimeInterval> below;
  std::vector<TimeInterval> contact;  ///< when there is contact or clash
  std::vector<CurvePoint> curve;
  std::int64_t distanceQueries = 0;
  /// Number of time spans for which a lower bound of the distance was proven.
  std::int64_t certificates = 0;
  double seconds = 0;

  /// Returns true if the verdict is Clear, or Contact and the rule allows contact.
  bool meetsRule() const {
    return verdict == ClearanceVerdict::Clear ||
           (verdict == ClearanceVerdict::Contact && rule.contact.has_value());
  }
};

struct ClearanceReport : RunReport {
  std::vector<NeighbourClearance> neighbours;  ///< in the order given, without ignored neighbours
  std::vector<std::string> ignored;            ///< names of the neighbours that the rules ignore
  /// Index of the nearest neighbour; a clash counts as nearer than any distance, and the deepest
  /// clash as nearest. A neighbour with allowed contact counts only if there is no other. Not set
  /// if the run failed.
  std::optional<std::size_t> smallest;
  /// For example "12 checked, smallest distance 3.2 mm at t = 4.1 s (bracket)"
  std::string summary;
  double required = 0;  ///< the common required distance
  double tolerance = 0;
  std::int64_t placements = 0;
  std::int64_t bodyTriangles = 0;
  std::int64_t neighbourTriangles = 0;
  std::string interpolation;
  /// What was checked: "motion" (the true motion) or "envelope" (its mesh at rest)
  std::string witness = "motion";
};

/// Never throws except std::bad_alloc; report.status describes a failure. The numbers do not depend
/// on the number of threads.
ClearanceReport checkClearance(const TriMesh& body, const Trajectory& trajectory,
                               const std::vector<ClearanceNeighbour>& neighbours,
                               const ClearanceOptions& options, RunContext& run);

/// Finds what the body touches or overlaps at the first pose of its motion, so that intended
/// contacts can be allowed. Returns a row for each neighbour, as checkClearance() does for that
/// pose. The rule of a row would allow what was found: contact, with a depth of a tenth more than
/// measured. The rule is empty if the neighbour is clear, or if the mesh is open, so that the depth
/// is unknown. The rules of the given neighbours are ignored.
ClearanceReport firstContacts(const TriMesh& body, const Trajectory& trajectory,
                              const std::vector<ClearanceNeighbour>& neighbours,
                              const ClearanceOptions& options, RunContext& run);

/// Returns the report as JSON text (UTF-8). docs/clearance.md describes the keys.
std::string toJson(const ClearanceReport& report);

/// Returns the distance (mm) of each point from a mesh, for colour maps; negative inside a closed
/// mesh. Throws Error(InvalidInput), Error(Cancelled).
std::vector<double> distanceToMesh(const std::vector<Eigen::Vector3d>& points, const TriMesh& mesh,
                                   RunContext& run);

/// Measures distances by a slow method, for comparison: with one FCL query at each pose and at
/// `between` times within each motion step. Smaller distances between these times are missed.
/// Throws Error(Cancelled).
struct StampedClearance {
  double distance = 0;
  double timeSeconds = 0;
  std::int64_t poses = 0;
};
StampedClearance stampedClearance(const TriMesh& body, const Trajectory& trajectory,
                                  const TriMesh& neighbour, int between, RunContext& run);

}  // namespace swept
