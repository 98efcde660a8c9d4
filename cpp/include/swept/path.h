// Finds installation paths: motions on which a part reaches its goal and stays clear of its
// neighbours.
// In:    the part, its goal, its start (or a distance or direction in which to take it out),
//        neighbours with their rules (swept/neighbour_rule.h), and the required clearance. All in
//        world coordinates. Units: mm, s, rad.
// Out:   a trajectory of few keys with the given interpolation. The clearance check proves that the
//        motion is clear, also between the keys. If no path is found, the report says how far the
//        part came and what blocked it.
// Cost:  milliseconds if a straight path exists; seconds if the part has to turn in narrow places.
// Promise: a path is returned only if checkClearance() finds it clear. The same seed gives the same
//        answer with any number of threads, unless the time limit ends the search.
// Method: docs/paths.md, with sources.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "swept/clearance.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Takes the part away from its goal: at least `radius` mm, or along a direction until it is past
/// all neighbours.
struct Extraction {
  double radius = 0;
  std::optional<Eigen::Vector3d> direction;
};

struct PathTask {
  Pose goal;  ///< placement at the end of the path
  /// Placement at the start of the path; if not set, `extraction` is needed.
  std::optional<Pose> start;
  /// Takes the place of a start; exactly one of the two must be set.
  std::optional<Extraction> extraction;
  /// Placements through which the path must pass, in order from start to goal.
  std::vector<Pose> via;
};

struct PathOptions {
  /// mm, distance to keep; 0: the part stays apart by more than the tolerance.
  double clearance = 0;
  double tolerance = 0.01;    ///< mm, as ClearanceOptions::tolerance
  double bodyChordError = 0;  ///< mm, as ClearanceOptions::bodyChordError
  /// mm. The part may be closer to a neighbour than the clearance at its start or goal. It may then
  /// stay that close, or touch, while no point of it is farther than this from its position there.
  double release = 0;
  /// The part never turns: it keeps the orientation that it has at the goal.
  bool translationOnly = false;
  /// Largest turn (rad) away from the orientation at the goal, 0 to pi.
  std::optional<double> largestTurn;
  Interpolation interpolation = Interpolation::Linear;  ///< linear or screw
  double budgetSeconds = 60;  ///< time limit by the wall clock; only ends a search
  /// Largest number of moves that the search with turns tries before it ends. The result then does
  /// not depend on the speed of the machine. 1: only the quick methods. Not set: no limit.
  std::optional<std::int64_t> mostSteps;
  /// If no path is found, look for a smaller clearance that allows one.
  bool tryLowerClearance = true;
  std::uint64_t seed = 1;
};

/// Found: the path is certified. NotFound: no path within the limits; nothing is proven.
/// NoTranslation: proven that no path exists without turning the part.
enum class PathVerdict { NotFound, Found, NoTranslation };
const char* pathVerdictName(PathVerdict verdict);  // not_found | found | no_translation

/// How far a search without success got.
struct PathEscape {
  double distance = 0;  ///< mm, how far the middle of the part came away from the goal
  Pose pose;            ///< placement at that distance
  std::vector<std::string> blockers;  ///< neighbours that stopped moves, the most frequent first
};

/// Figures of a path.
struct PathFigures {
  std::int64_t keys = 0;
  double length = 0;     ///< mm, length of the path of the part's middle
  double turn = 0;       ///< rad, sum of all turns
  double clearance = 0;  ///< mm, smallest guaranteed distance outside the release zones
};

struct PathReport : RunReport {
  PathVerdict verdict = PathVerdict::NotFound;
  std::string summary;
  /// Method that found the path: "straight", "straight moves", "grid of places", "no turning" or
  /// "six dimensions".
  std::string method;
  Trajectory path;       ///< from the start to the goal, at 100 mm per second; empty unless found
  double length = 0;     ///< mm, length of the path of the part's middle
  double turn = 0;       ///< rad, sum of all turns
  double clearance = 0;  ///< mm, smallest guaranteed distance outside the release zones
  PathEscape escape;     ///< set unless a path is found
  /// mm: the largest clearance for which a path was found, smaller than the required one. Not set
  /// if none was found or searched for.
  std::optional<double> possibleClearance;
  std::vector<std::string> contacts;  ///< neighbours to which the release zones apply
  std::vector<std::string> ignored;   ///< neighbours that the rules ignore
  double required = 0;
  double tolerance = 0;
  double release = 0;
  std::uint64_t seed = 0;
  bool budgetEnded = false;  ///< the time limit ended the search
  std::int64_t steps = 0;    ///< number of moves tried
  std::int64_t bodyTriangles = 0;
  std::int64_t neighbourTriangles = 0;
  std::string interpolation;
  /// Clearance check of the path outside the release zones.
  std::vector<NeighbourClearance> certificate;
  std::optional<PathFigures> before;  ///< figures of the given motion, if a motion was improved
  /// improvePath(): moves left unchanged although they are closer than the clearance.
  std::int64_t keptMoves = 0;
  std::int64_t unmendedMoves = 0;  ///< those of keptMoves that lie outside the release zones
};

/// Shows the progress of a search to another thread: the placement farthest from the goal so far.
class PathWatch {
 public:
  void show(const Pose& pose) {
    const std::lock_guard<std::mutex> lock(mutex_);
    pose_ = pose;
  }
  std::optional<Pose> farthest() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return pose_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<Pose> pose_;
};

/// Rules with a required distance replace the clearance for their neighbours, ignored neighbours
/// are left out, and rules that allow contact are refused (BadRule). Never throws except
/// std::bad_alloc; report.status describes a failure. Codes besides those of checkClearance():
/// GoalBlocked, StartBlocked and ViaBlocked (the part overlaps a neighbour or is closer than the
/// clearance; the text says which and by how much), SamePose (start equals goal), NoStart.
PathReport findPath(const TriMesh& part, const PathTask& task,
                    const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options,
                    RunContext& run, PathWatch* watch = nullptr);

/// The motion to improve, and how.
struct ImproveTask {
  Trajectory motion;  ///< linear or screw, at least two poses
  /// Indices of keys that keep placement and time; the ends always do.
  std::vector<std::size_t> locked;
  /// Make the clearance as large as possible, not only as large as required.
  bool moreClearance = false;
};

/// Improves a motion. Moves within `release` of the ends stay exactly as given. Of the rest, moves
/// that come closer to a neighbour than the clearance are replaced by another path, or stay as
/// given if none is found. The others become shorter, with fewer keys. `keptMoves` counts the moves
/// that stay as given; all others are certified as in findPath(). The verdict is NotFound if no
/// move of the result is certified. The options are those of findPath(), but the interpolation is
/// that of the motion. Never throws except std::bad_alloc. Codes besides those of findPath():
/// BadPose.
PathReport improvePath(const TriMesh& part, const ImproveTask& task,
                       const std::vector<ClearanceNeighbour>& neighbours,
                       const PathOptions& options, RunContext& run);

/// Returns the report as JSON text (UTF-8). docs/paths.md describes the keys.
std::string toJson(const PathReport& report);

}  // namespace swept
