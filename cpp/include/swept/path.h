// Installation paths: how a part gets to its place between neighbours, clear of them all the way.
// In:    the part, where it belongs, where it comes from (or "just out of here"), neighbours with
//        their rules (swept/neighbour_rule.h), the clearance asked for. Units: mm, s, rad. All in
//        one world.
// Out:   a trajectory of few keys, proven clear between its keys by the clearance engine, with the
//        interpolation that it names; or an honest answer why there is none.
// Cost:  milliseconds for a straight way out; seconds where the part has to turn in narrow places.
// Promise: nothing is called a path that checkClearance() does not find clear. The same answer for
//        the same seed and any count of threads, unless the wall-clock budget ends the search.
// Method and sources: docs/paths.md.
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

/// Get the part out: at least `radius` mm away, or, with a direction, past all neighbours along it.
struct Extraction {
  double radius = 0;
  std::optional<Eigen::Vector3d> direction;
};

struct PathTask {
  Pose goal;                             ///< where the part belongs
  std::optional<Pose> start;             ///< where it comes from; not given: see extraction
  std::optional<Extraction> extraction;  ///< instead of a start; one of the two is needed
  std::vector<Pose> via;                 ///< places that the path has to pass, from start to goal
};

struct PathOptions {
  double clearance = 0;       ///< mm; 0: apart by more than the tolerance
  double tolerance = 0.01;    ///< mm, as ClearanceOptions::tolerance
  double bodyChordError = 0;  ///< mm, as ClearanceOptions::bodyChordError
  /// mm: neighbours that are nearer than the clearance at the goal (or start) may be so, and touch,
  /// as long as no point of the part is farther than this from where it is at the goal (or start).
  double release = 0;
  bool translationOnly = false;       ///< the part never turns: it comes as it stands at the goal
  std::optional<double> largestTurn;  ///< rad from how the part stands at the goal, 0 to pi
  Interpolation interpolation = Interpolation::Linear;  ///< linear or screw
  double budgetSeconds = 60;                            ///< wall clock; only ends a search
  /// Moves tried in six dimensions after which a search ends, the same on every machine; 0: no
  /// limit. 1: the quick methods alone.
  std::int64_t mostSteps = 0;
  bool askLess = true;  ///< where nothing is found, look for a smaller clearance that works
  std::uint64_t seed = 1;
};

/// Found: the path is certified. NotFound: none within the budget, nothing is proven.
/// NoTranslation: proven that the part cannot come without turning.
enum class PathVerdict { NotFound, Found, NoTranslation };
const char* pathVerdictName(PathVerdict verdict);  // not_found | found | no_translation

/// How far a search without success got.
struct PathEscape {
  double distance = 0;                ///< mm that the part's middle came away from the goal
  Pose pose;                          ///< there
  std::vector<std::string> blockers;  ///< neighbours that stopped most moves, the worst first
};

/// A path in numbers.
struct PathFigures {
  std::int64_t keys = 0;
  double length = 0;     ///< mm that the part's middle travels
  double turn = 0;       ///< rad, sum over the path
  double clearance = 0;  ///< mm, smallest guaranteed one outside the release zones
};

struct PathReport {
  Status status = Status::Ok;
  std::string code;
  std::string message;
  PathVerdict verdict = PathVerdict::NotFound;
  std::string summary;
  /// What found it: "straight", "straight moves", "grid of places", "no turning" or "six
  /// dimensions".
  std::string method;
  Trajectory path;       ///< start first; 100 mm a second; empty unless found
  double length = 0;     ///< mm that the part's middle travels
  double turn = 0;       ///< rad, sum over the path
  double clearance = 0;  ///< mm, smallest guaranteed one outside the release zones
  PathEscape escape;     ///< unless found
  /// mm: the largest clearance for which a path was found instead of the one asked for; -1: none.
  double possibleClearance = -1;
  std::vector<std::string> contacts;  ///< neighbours to which the release zones apply
  std::vector<std::string> ignored;   ///< neighbours that the rules leave out
  double required = 0;
  double tolerance = 0;
  double release = 0;
  std::uint64_t seed = 0;
  bool budgetEnded = false;  ///< the wall clock ended the search
  std::int64_t steps = 0;    ///< moves tried
  std::int64_t bodyTriangles = 0;
  std::int64_t neighbourTriangles = 0;
  std::string interpolation;
  int threads = 0;
  std::vector<NeighbourClearance> certificate;  ///< of the path outside the release zones
  std::vector<StageSeconds> seconds;            ///< "total" is the last entry
  std::vector<Finding> warnings;
  std::optional<PathFigures> before;  ///< of the motion that was improved
  std::int64_t keptMoves = 0;  ///< improving: moves that stay as they were, nearer than asked for
  std::int64_t unmendedMoves = 0;  ///< of them: outside the release zones
};

/// What somebody who watches a search may see: the placement that came farthest out so far.
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

/// Neighbours that ask for a distance of their own get it, ignored ones are left out, contact at
/// any time is refused (BadRule). Never throws except std::bad_alloc; failures are in
/// report.status. Codes besides those of checkClearance(): GoalBlocked, StartBlocked, ViaBlocked
/// (inside a neighbour, or nearer than the clearance: which, how much), SamePose (start is goal),
/// NoStart.
PathReport findPath(const TriMesh& part, const PathTask& task,
                    const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options,
                    RunContext& run, PathWatch* watch = nullptr);

/// How a motion is improved.
struct ImproveTask {
  Trajectory motion;                ///< linear or screw, at least two poses
  std::vector<std::size_t> locked;  ///< keys that stay where and when they are; both ends always do
  bool moreClearance = false;       ///< as much clearance as can be had, not only what is asked for
};

/// A motion made better: what is nearer to a neighbour than the clearance is led another way, what
/// is not is made shorter with fewer keys. What cannot be mended stays exactly as it is, and so
/// does what is nearer within `release` of the ends (keptMoves); all else is certified as in
/// findPath(). The verdict is NotFound if nothing keeps the clearance. Options as for findPath(),
/// the interpolation is that of the motion. Never throws except std::bad_alloc; codes besides those
/// of findPath(): BadPose.
PathReport improvePath(const TriMesh& part, const ImproveTask& task,
                       const std::vector<ClearanceNeighbour>& neighbours,
                       const PathOptions& options, RunContext& run);

/// The report as JSON text (UTF-8); keys as in docs/paths.md.
std::string toJson(const PathReport& report);

}  // namespace swept
