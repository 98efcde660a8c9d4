// Clearance of a moving body against neighbouring parts, over the whole continuous motion.
// In:    body, trajectory, neighbours (all in the same world), required distance, tolerances.
// Out:   per neighbour: smallest distance, where and when; verdict; penetration; time intervals.
// Units: mm, s. Cost: a few hundred to a few thousand distance queries a neighbour, O(log) each.
// Promise: between two poses the motion is bounded, never only sampled: no part of the motion comes
// closer than `distance - tolerance`, whatever lies between the poses (docs/clearance.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/neighbour_rule.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// A part that stands still. chordError: how far its triangles may lie off the exact surface, mm.
struct ClearanceNeighbour {
  std::string name;
  TriMesh mesh;
  double chordError = 0;
  NeighbourRule rule = {};  ///< what this one asks for instead of the common distance
};

struct ClearanceOptions {
  double required = 0;        ///< mm, distance asked for; 0: only contact and clash matter
  double tolerance = 0.01;    ///< mm, how far the smallest distance may be off between two poses
  double bodyChordError = 0;  ///< mm, as ClearanceNeighbour::chordError, for the moving body
  double intervalTolerance =
      0;                    ///< mm of travel to which ends of intervals are found; 0: 10 tolerance
  int curveSamples = 200;   ///< points of the graph of distance over time; 0: none
  bool penetration = true;  ///< measure how deep a clash goes and where
};

/// Clear: at least the required distance. BelowRequired: apart, but nearer than required. Contact:
/// nearer than tolerance + chord errors, so that it cannot be told from touching. Clash: the solids
/// share space by more than that; where the rule allows contact, by more than that and by more than
/// the depth that it allows.
enum class ClearanceVerdict { Clear, BelowRequired, Contact, Clash };
const char* clearanceVerdictName(ClearanceVerdict verdict);  // clear | below | contact | clash

/// Closed span of time. With Interpolation::None: from the first to the last pose of a run of
/// poses.
struct TimeInterval {
  double from = 0;
  double to = 0;
};

struct CurvePoint {
  double timeSeconds = 0;
  double distance = 0;  ///< mm; 0 where the parts meet or one lies in the other
};

struct PenetrationResult {
  bool known = false;  ///< false: no clash, not asked for, or neither mesh is closed
  /// Largest distance, over the motion, of a surface point of one part that lies inside the other
  /// to that other's surface, mm; the search stopped when no point could be deeper than depthBound.
  double depth = 0;
  double depthBound = 0;
  double timeSeconds = 0;
  double parameter = 0;  ///< pose index plus share of the step after it
  Pose pose;
  bool pointOfBody = true;  ///< the deepest point belongs to the body, not to the neighbour
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< the deepest point, world
  Eigen::Vector3d surface = Eigen::Vector3d::Zero();  ///< nearest point of the surface it passed
  /// Box (world, at `pose`) round the crossing of the surfaces and what lies inside the other part.
  Eigen::Vector3d regionMin = Eigen::Vector3d::Zero();
  Eigen::Vector3d regionMax = Eigen::Vector3d::Zero();
};

struct NeighbourClearance {
  std::string name;
  NeighbourRule rule;  ///< that holds for it: a required distance or contact
  ClearanceVerdict verdict = ClearanceVerdict::Clear;
  double distance =
      0;  ///< mm between the triangles, 0 where they meet; at most `tolerance` too large
  double guaranteed = 0;   ///< distance - tolerance (if interpolated) - chord errors, not below 0
  double chordError = 0;   ///< mm, both parts together
  double timeSeconds = 0;  ///< when the smallest distance occurs; for a clash: when it is deepest
  Pose pose;               ///< placement of the body at that time
  Eigen::Vector3d pointOnBody = Eigen::Vector3d::Zero();       ///< world
  Eigen::Vector3d pointOnNeighbour = Eigen::Vector3d::Zero();  ///< world
  std::int64_t bodyTriangle = -1;  ///< -1: surfaces meet, or the mesh had to be mended first
  std::int64_t neighbourTriangle = -1;
  bool closed = true;   ///< false: the neighbour's mesh is open, inside is not defined
  bool inside = false;  ///< at some time one part lies inside the other without touching it
  PenetrationResult penetration;
  std::vector<TimeInterval> below;    ///< guaranteed distance below required (if required > 0)
  std::vector<TimeInterval> contact;  ///< contact or clash
  std::vector<CurvePoint> curve;
  std::int64_t distanceQueries = 0;
  std::int64_t certificates = 0;  ///< spans of motion proven to stay away
  double seconds = 0;

  /// Clear, or in contact where the rule allows it.
  bool meetsRule() const {
    return verdict == ClearanceVerdict::Clear ||
           (verdict == ClearanceVerdict::Contact && rule.contact.has_value());
  }
};

struct ClearanceReport {
  Status status = Status::Ok;
  std::string code;
  std::string message;
  std::vector<NeighbourClearance> neighbours;  ///< in the order given, without the ignored ones
  std::vector<std::string> ignored;            ///< names
  /// Index of the neighbour that comes nearest (deepest clash first); of those that may be touched
  /// only where no other comes into question.
  int smallest = -1;
  std::string summary;  ///< "12 checked, smallest 3.2 mm at t = 4.1 s (bracket)"
  double required = 0;  ///< the common one
  double tolerance = 0;
  std::int64_t placements = 0;
  std::int64_t bodyTriangles = 0;
  std::int64_t neighbourTriangles = 0;
  std::string interpolation;
  std::string witness = "motion";  ///< "motion": true motion; "envelope": still envelope mesh
  int threads = 0;
  std::vector<StageSeconds> seconds;  ///< "total" is the last entry
  std::vector<Finding> warnings;
};

/// Never throws except std::bad_alloc; failures are in report.status. The same numbers for any
/// count of threads.
ClearanceReport checkClearance(const TriMesh& body, const Trajectory& trajectory,
                               const std::vector<ClearanceNeighbour>& neighbours,
                               const ClearanceOptions& options, RunContext& run);

/// What the body touches, or lies in, at the first pose of its motion: contacts that may be meant.
/// A row for each neighbour, as checkClearance() has it for that pose; its rule is the one that
/// would allow what is found there (contact, a tenth deeper than what is found), or none for what
/// is clear and for open meshes, whose depth is not known. Rules of the neighbours are passed over.
ClearanceReport firstContacts(const TriMesh& body, const Trajectory& trajectory,
                              const std::vector<ClearanceNeighbour>& neighbours,
                              const ClearanceOptions& options, RunContext& run);

/// The report as JSON text (UTF-8); keys as in docs/clearance.md.
std::string toJson(const ClearanceReport& report);

/// Distance of each point to a mesh, for colour maps, mm; negative inside if the mesh is closed.
/// Throws Error(InvalidInput), Error(Cancelled).
std::vector<double> distanceToMesh(const std::vector<Eigen::Vector3d>& points, const TriMesh& mesh,
                                   RunContext& run);

/// The slow way, for comparison: one query by FCL at every pose and at `between` more in each step.
/// Sees nothing between those. Throws Error(Cancelled).
struct StampedClearance {
  double distance = 0;
  double timeSeconds = 0;
  std::int64_t poses = 0;
};
StampedClearance stampedClearance(const TriMesh& body, const Trajectory& trajectory,
                                  const TriMesh& neighbour, int between, RunContext& run);

}  // namespace swept
